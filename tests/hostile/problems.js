// SPDX-License-Identifier: MIT
/**
 * @file Problems that contradict themselves, their cage or JSON.
 */
import { cube, range, sheet, tetrahedron } from './contents.js';
import { problem } from './row.js';

const head = { umbilic: 'problem', version: 1 };
const plain = {
  ...head,
  cage: { generator: 'cube' },
  terms: { bending: 1 },
  options: { levels: [1, 1], max_iterations: 3 },
};
const open = { ...plain, cage: { text: sheet(4, 4) } };

/** The problem of a cube with other members. @param {object} members */
const asked = (members) => JSON.stringify({ ...plain, ...members });
/** The problem of an open sheet. @param {object} members */
const askedOfSheet = (members) => JSON.stringify({ ...open, ...members });
/** @param {object} options */
const withOptions = (options) => asked({ options: { ...plain.options, ...options } });
/** The text of the problem, with one piece replaced. @param {string} piece @param {string} by */
const spelled = (piece, by) => JSON.stringify(plain).replace(piece, by);

// One row a line.
// prettier-ignore
export const problemRows = [
  // JSON.
  problem('an empty object', '{}', 'refused', 'umbilic: missing'),
  problem('cut in the middle', JSON.stringify(plain).slice(0, 60), 'refused', `line 1, column 61: this is no JSON, at '"cube"}'`),
  problem('two problems in one text', JSON.stringify(plain) + JSON.stringify(plain), 'refused', "line 1, column 130: this is no JSON, at '3}}{'"),
  problem('a comma too many', spelled('}}', ',}}'), 'refused', "line 1, column 129: this is no JSON, at '3,}'"),
  problem('a comment', spelled('{', '{/* a */'), 'refused', "line 1, column 2: this is no JSON, at '{/'"),
  problem('single quotes', JSON.stringify(plain).replaceAll('"', "'"), 'refused', "line 1, column 2: this is no JSON, at '{''"),
  problem('NaN as a number', spelled('"bending":1', '"bending":NaN'), 'refused', `line 1, column 81: this is no JSON, at '"bending":N'`),
  problem('Infinity as a number', spelled('"bending":1', '"bending":Infinity'), 'refused', `line 1, column 81: this is no JSON, at '"bending":I'`),
  problem('1e400 as a weight', spelled('"bending":1', '"bending":1e400'), 'refused', "line 1, column 85: the number '1e400' is too large"),
  problem('a number with a plus', spelled('"bending":1', '"bending":+1'), 'refused', `line 1, column 81: this is no JSON, at '"bending":+'`),
  problem('a number with a leading zero', spelled('"bending":1', '"bending":01'), 'refused', "line 1, column 82: this is no JSON, at '1'"),
  problem('a number of 100 000 digits', () => spelled('"bending":1', `"bending":1${'0'.repeat(100000)}`), 'refused', "line 1, column 100081: the number '10000000000000000000000000000000...' is too large"),
  problem('a line end in a string', spelled('cube', 'cu\nbe'), 'refused', `line 2, column 0: this is no JSON, at '"cu<U+000A>'`),
  problem('half of a surrogate pair', spelled('cube', '\\ud800'), 'refused', 'line 1, column 61: this is no JSON'),
  problem('an unknown escape', spelled('cube', '\\x41'), 'refused', 'line 1, column 56: this is no JSON'),
  problem('a zero byte in a string', spelled('cube', 'cube\\u0000'), 'refused', 'there is no cage called cube?;'),
  problem('an escape sequence as a name', spelled('cube', '\\u001b[2J'), 'refused', 'there is no cage called ?[2J;'),
  problem('blanks in front', ` \n\t\r ${JSON.stringify(plain)}`, 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('1000 objects in each other', () => `${'{"a":'.repeat(1000)}1${'}'.repeat(1000)}`, 'refused', 'nested more than 32 deep'),
  problem('a million arrays in each other', () => `{"umbilic":${'['.repeat(1000000)}`, 'refused', 'nested more than 32 deep'),
  problem('a member twice', spelled('"terms":{"bending":1}', '"terms":{"bending":1},"terms":{"mvs":1}'), 'refused', 'terms: stands there twice'),
  problem('a weight twice', spelled('"bending":1', '"bending":1,"bending":2'), 'refused', 'terms.bending: stands there twice'),
  problem('a member named __proto__', spelled('"version":1', '"version":1,"__proto__":{}'), 'refused', "'__proto__': unknown"),
  problem('10 000 unknown members', () => `{${range(10000).map((i) => `"a${i}":${i}`).join(',')}}`, 'refused', 'umbilic: missing'),

  // What it says that it is.
  problem('a problem that is none', asked({ umbilic: 'cage' }), 'refused', 'umbilic: expected "problem" or "report"'),
  problem('a problem that is a number', asked({ umbilic: 1 }), 'refused', 'umbilic: expected a string'),
  problem('no version', spelled('"version":1,', ''), 'refused', 'version: missing'),
  problem('version 0', asked({ version: 0 }), 'refused', 'version: 0 is not known to this program, which reads versions up to 1'),
  problem('version 2', asked({ version: 2 }), 'refused', 'version: 2 is not known to this program, which reads versions up to 1'),
  problem('version 1.5', asked({ version: 1.5 }), 'refused', 'version: expected a whole number'),
  problem('version "1"', asked({ version: '1' }), 'refused', 'version: expected a whole number'),
  problem('version 1e99', spelled('"version":1', '"version":1e99'), 'refused', 'version: 1e+99 is too large'),
  problem('version -1', asked({ version: -1 }), 'refused', 'version: -1 is not known to this program, which reads versions up to 1'),
  problem('version null', asked({ version: null }), 'refused', 'version: expected a whole number'),
  problem('an unknown member', asked({ termz: {} }), 'refused', "'termz': unknown"),
  problem('a report without anything', JSON.stringify({ umbilic: 'report', version: 1 }), 'refused', 'problem: missing'),
  problem('a report whose problem is a word', JSON.stringify({ umbilic: 'report', version: 1, problem: 'cube' }), 'refused', 'problem: expected an object'),

  // The cage.
  problem('no cage', JSON.stringify({ ...head, terms: { bending: 1 } }), 'refused', 'cage: missing'),
  problem('a cage null', asked({ cage: null }), 'refused', 'cage: expected an object'),
  problem('a cage of a word', asked({ cage: 'cube' }), 'refused', 'cage: expected an object'),
  problem('a cage of nothing', asked({ cage: {} }), 'refused', 'cage: expected one of the members generator, text, file'),
  problem('a cage of two kinds', asked({ cage: { generator: 'cube', text: cube } }), 'refused', 'cage: expected one of the members generator, text, file'),
  problem('an unknown generator', asked({ cage: { generator: 'sphere' } }), 'refused', 'there is no cage called sphere;'),
  problem('a generator of a number', asked({ cage: { generator: 7 } }), 'refused', 'cage.generator: expected a string'),
  problem('a generator with an unknown parameter', asked({ cage: { generator: 'cube', size: 2 } }), 'refused', "cage.'size': unknown"),
  problem('a torus of 2 segments', asked({ cage: { generator: 'torus', segments: [2, 8] } }), 'refused', '2 segments are not 3 to 1000'),
  problem('a torus of 10^9 segments', asked({ cage: { generator: 'torus', segments: [1e9, 1e9] } }), 'refused', '1000000000 segments are not 3 to 1000'),
  problem('a torus of ratio 1', asked({ cage: { generator: 'torus', ratio: 1 } }), 'refused', 'ratio 1 is not between 0 and 1'),
  problem('a torus of ratio null', asked({ cage: { generator: 'torus', ratio: null } }), 'refused', 'ratio nan is not between 0 and 1'),
  problem('a frame of thickness 0', asked({ cage: { generator: 'two-3', thickness: 0 } }), 'refused', 'thickness 0 is not between 0.01 and 2.25'),
  problem('a frame of thickness 1e308', asked({ cage: { generator: 'two-3', thickness: 1e308 } }), 'refused', 'thickness 1e+308 is not between 0.01 and 2.25'),
  problem('a cage text of a number', asked({ cage: { text: 7 } }), 'refused', 'cage.text: expected a string'),
  problem('a cage text that is empty', asked({ cage: { text: '' } }), 'refused', 'the file is empty'),
  problem('a cage text with an error, and a name with an escape', asked({ cage: { name: 'a\n\u001b[2Jb', text: 'v 0 0 0\nf 1 2 3\n' } }), 'refused', 'a??[2Jb: line 2: face 1 names vertex 2, but there are 1 vertices'),
  problem('a cage file that does not exist', asked({ cage: { file: 'does-not-exist.obj' } }), 'refused', 'does-not-exist.obj'),

  // The terms.
  problem('no terms', JSON.stringify({ ...head, cage: plain.cage }), 'refused', 'terms: missing'),
  problem('terms that are empty', asked({ terms: {} }), 'refused', 'terms: all weights are zero'),
  problem('terms of 0', asked({ terms: { bending: 0 } }), 'refused', 'terms: all weights are zero'),
  problem('terms of -1', asked({ terms: { bending: -1 } }), 'refused', 'terms: weight of bending is not a finite number >= 0'),
  problem('terms of null', asked({ terms: { bending: null } }), 'refused', 'terms: weight of bending is not a finite number >= 0'),
  problem('terms of "1"', asked({ terms: { bending: '1' } }), 'refused', 'terms.bending: expected a number'),
  problem('terms of an array', asked({ terms: ['bending'] }), 'refused', 'terms: expected an object'),
  problem('terms of an unknown functional', asked({ terms: { area: 1 } }), 'refused', "terms.'area': no functional"),
  problem('terms of 1e308 each', asked({ terms: { bending: 1e308, willmore: 1e308, mvs: 1e308 } }), 'doubtful', 'not_finite'),
  problem('terms of 5e-324', asked({ terms: { bending: 5e-324 } }), 'minimized', '8 vertices, 6 faces, genus 0'),

  // The options.
  problem('options of an array', asked({ options: [] }), 'refused', 'options: expected an object'),
  problem('an unknown option', withOptions({ speed: 3 }), 'refused', "options.'speed': unknown"),
  problem('an unknown cap', withOptions({ cap: 'round' }), 'refused', "options.cap: 'round' is unknown"),
  problem('an unknown metric', withOptions({ metric: 'euclid' }), 'refused', "options.metric: 'euclid' is unknown"),
  problem('one level', withOptions({ levels: [1] }), 'refused', 'options.levels: expected two numbers, [first, second]'),
  problem('three levels', withOptions({ levels: [0, 1, 2] }), 'refused', 'options.levels: expected two numbers, [first, second]'),
  problem('levels of words', withOptions({ levels: ['0', '1'] }), 'refused', 'options.levels[0]: expected a whole number'),
  problem('levels that fall', withOptions({ levels: [2, 1] }), 'refused', 'options.levels[1]: 1 is below levels[0], 2'),
  problem('levels below 0', withOptions({ levels: [-1, 1] }), 'refused', 'options.levels[0]: -1 is negative'),
  problem('levels of 0.5', withOptions({ levels: [0.5, 1] }), 'refused', 'options.levels[0]: expected a whole number'),
  problem('levels to 20', withOptions({ levels: [0, 20] }), 'refused', 'level 20 would have 6.6e+12 faces; at most 2000000 are possible'),
  problem('levels to 2^31', withOptions({ levels: [0, 2 ** 31] }), 'refused', 'options.levels[1]: 2147483648 is too large'),
  problem('levels null', withOptions({ levels: [null, null] }), 'refused', 'options.levels[0]: expected a whole number'),
  problem('-1 iterations', withOptions({ max_iterations: -1 }), 'refused', 'options.max_iterations: -1 is negative'),
  problem('1e99 iterations', withOptions({ max_iterations: 1e99 }), 'refused', 'options.max_iterations: 1e+99 is too large'),
  problem('no iterations', withOptions({ max_iterations: 0 }), 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('a tolerance of -1', withOptions({ tolerance: -1 }), 'refused', 'options.tolerance: -1 is not a finite number >= 0'),
  problem('a tolerance of null', withOptions({ tolerance: null }), 'refused', 'options.tolerance: nan is not a finite number >= 0'),
  problem('a tolerance of 1e308', withOptions({ tolerance: 1e308 }), 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('a tolerance of 0', withOptions({ tolerance: 0 }), 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('an accuracy of 0', withOptions({ accuracy: 0 }), 'refused', 'options.accuracy: 0 is not between 0 and 1'),
  problem('an accuracy of 1', withOptions({ accuracy: 1 }), 'refused', 'options.accuracy: 1 is not between 0 and 1'),
  problem('an accuracy of words', withOptions({ accuracy: 'good' }), 'refused', 'options.accuracy: expected a number'),
  problem('a symmetry of words', withOptions({ symmetry: 'yes' }), 'refused', 'options.symmetry: expected true or false'),

  // The start.
  problem('a start without points', asked({ start: { level: 1 } }), 'refused', 'start.points: missing'),
  problem('a start of two numbers', asked({ start: { level: 1, points: [1, 2] } }), 'refused', 'start.points: 2 numbers, not three for each point'),
  problem('a start of one point', asked({ start: { level: 1, points: [1, 2, 3] } }), 'refused', 'start: 1 points: expected 3, one for each orbit of vertices at level 1, or 26, of all vertices'),
  problem('a start with null', asked({ start: { level: 1, points: [1, 2, null] } }), 'refused', 'start: 1 points: expected 3, one for each orbit of vertices at level 1, or 26, of all vertices'),
  problem('a start at level -1', asked({ start: { level: -1, points: [] } }), 'refused', 'start.level: -1 is negative'),
  problem('a start at level 30', asked({ start: { level: 30, points: [] } }), 'refused', 'level 30 would have 6.92e+18 faces; at most 2000000 are possible'),
  problem('a start in one place', () => asked({ options: { ...plain.options, symmetry: false }, start: { level: 1, points: Array(78).fill(1) } }), 'doubtful', '8 vertices, 6 faces, genus 0'),
  problem('a start with 1e308', () => asked({ options: { ...plain.options, symmetry: false }, start: { level: 1, points: range(78).map((i) => (i % 2 ? 1e308 : -1e308)) } }), 'doubtful', 'not_finite'),

  // The constraints.
  problem('constraints of an array', asked({ constraints: [] }), 'refused', 'constraints: expected an object'),
  problem('an unknown constraint', asked({ constraints: { volume: 1 } }), 'refused', "constraints.'volume': unknown"),
  problem('hold and free at once', asked({ constraints: { hold: { faces: [1] }, free: { faces: [2] } } }), 'refused', 'constraints.hold and free are both given; one of them says what is held'),
  problem('all faces held', asked({ constraints: { hold: { faces: [1, 2, 3, 4, 5, 6] } } }), 'refused', 'constraints: all faces are held; nothing is free'),
  problem('no face free', asked({ constraints: { free: {} } }), 'refused', 'constraints: all faces are held; nothing is free'),
  problem('no face held', asked({ constraints: { hold: {} } }), 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('face 7 of 6 held', asked({ constraints: { hold: { faces: [7] } } }), 'refused', 'constraints.hold.faces[0]: there is no face 7; the cage has 6, numbered from 1'),
  problem('face 0 held', asked({ constraints: { hold: { faces: [0] } } }), 'refused', 'constraints.hold.faces[0]: there is no face 0; the cage has 6, numbered from 1'),
  problem('face 1.5 held', asked({ constraints: { hold: { faces: [1.5] } } }), 'refused', 'constraints.hold.faces[0]: expected a whole number'),
  problem('a group held that is not there', asked({ constraints: { hold: { groups: ['a\u001b'] } } }), 'refused', "constraints.hold.groups[0]: there is no group 'a?'; the cage has no groups"),
  problem('a pin of nothing', asked({ constraints: { pins: [{}] } }), 'refused', 'constraints.pins[0].vertex: expected either vertex, or face and uv'),
  problem('a pin of a vertex and a face', asked({ constraints: { pins: [{ vertex: 1, face: 1, uv: [0, 0] }] } }), 'refused', 'constraints.pins[0].vertex: expected either vertex, or face and uv'),
  problem('a pin of vertex 0', asked({ constraints: { pins: [{ vertex: 0 }] } }), 'refused', 'constraints.pins[0].vertex: 0 is below 1'),
  problem('a pin of vertex 9 of 8', asked({ constraints: { pins: [{ vertex: 9 }] } }), 'refused', 'constraints.pins[0].vertex: 9, but the cage has 8 vertices'),
  problem('a pin of a face without a place', asked({ constraints: { pins: [{ face: 1 }] } }), 'refused', 'constraints.pins[0].uv: missing'),
  problem('a pin outside its face', asked({ constraints: { pins: [{ face: 1, uv: [2, 0] }] } }), 'refused', 'constraints.pins[0].uv[0]: 2 is not between 0 and 1'),
  problem('a pin at null', asked({ constraints: { pins: [{ vertex: 1, at: [null, null, null] }] } }), 'refused', 'constraints.pins[0].at: every coordinate is null; leave it out to hold the point where it is'),
  problem('a pin at 1e308', asked({ constraints: { pins: [{ vertex: 1, at: [1e308, 0, 0] }] } }), 'refused', 'constraints.pins[0].at[0]: too large for the cage'),
  problem('a pin at two numbers', asked({ constraints: { pins: [{ vertex: 1, at: [1, 2] }] } }), 'refused', 'constraints.pins[0].at: expected an array of 3'),
  problem('a pin with a normal of 0', asked({ constraints: { pins: [{ vertex: 1, normal: [0, 0, 0] }] } }), 'refused', 'constraints.pins[0].normal: has no direction, all coordinates are 0'),
  problem('a pin that holds nothing', asked({ constraints: { pins: [{ vertex: 1, position: false }] } }), 'refused', 'constraints.pins[0].position: false, without a normal nothing is held'),
  problem('two pins of a vertex at two places', asked({ constraints: { pins: [{ vertex: 1, at: [0, 0, 0] }, { vertex: 1, at: [1, 0, 0] }] } }), 'refused', 'constraints: pin 1 (x), pin 2 (x) cannot all hold'),
  problem('the same pin twice', asked({ constraints: { pins: [{ vertex: 1 }, { vertex: 1 }] } }), 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('a pin in a held face at another place', asked({ constraints: { hold: { faces: [1] }, pins: [{ face: 1, uv: [0.5, 0.5], at: [9, 9, 9] }] } }), 'refused', 'constraints: pin 1 (x) cannot all hold while the held faces stay'),
  problem('1000 pins of one vertex', () => asked({ constraints: { pins: Array(1000).fill({ vertex: 1 }) } }), 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('a closeness of two kinds', asked({ constraints: { closeness: { weight: 1, within: 1 } } }), 'refused', 'constraints.closeness.weight: expected either this or within'),
  problem('a closeness of nothing', asked({ constraints: { closeness: {} } }), 'refused', 'constraints.closeness.weight: expected either this or within'),
  problem('a closeness within 0', asked({ constraints: { closeness: { within: 0 } } }), 'refused', 'constraints.closeness.within: 0 is not a finite number > 0'),
  problem('a closeness within null', asked({ constraints: { closeness: { within: null } } }), 'refused', 'constraints.closeness.within: nan is not a finite number > 0'),
  problem('a closeness within 1e-300', asked({ constraints: { closeness: { within: 1e-300 } } }), 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('a closeness of 1e300', asked({ constraints: { closeness: { weight: 1e300 } } }), 'minimized', '8 vertices, 6 faces, genus 0'),
  problem('a closeness with flat caps', JSON.stringify({ ...plain, cage: { text: tetrahedron }, options: { ...plain.options, cap: 'flat' }, constraints: { closeness: { weight: 1 } } }), 'refused', 'constraints.closeness: caps flat are not linear in the control points; use smooth or none'),
  problem('a boundary of a closed cage', asked({ constraints: { boundary: { loops: [{ loop: 1, condition: 'free' }] } } }), 'refused', 'constraints.boundary.loops[0]: the cage is closed'),
  problem('an unknown condition', askedOfSheet({ constraints: { boundary: { condition: 'glued' } } }), 'refused', "constraints.boundary.condition: 'glued' is unknown"),
  problem('boundary 2 of 1', askedOfSheet({ constraints: { boundary: { loops: [{ loop: 2, condition: 'free' }] } } }), 'refused', 'constraints.boundary.loops[0].loop: there is no boundary 2; the cage has 1'),
  problem('a stretch from a vertex inside', askedOfSheet({ constraints: { boundary: { loops: [{ loop: 1, from: 7, to: 1, condition: 'free' }] } } }), 'refused', 'constraints.boundary.loops[0].from: vertex 7 is not on that boundary'),
  problem('a stretch without its end', askedOfSheet({ constraints: { boundary: { loops: [{ loop: 1, from: 1, condition: 'free' }] } } }), 'refused', 'constraints.boundary.loops[0].from: a stretch needs from and to'),
  problem('curvature with nothing beyond', askedOfSheet({ constraints: { boundary: { condition: 'curvature' } } }), 'refused', 'constraints.boundary: the cage says nothing of the curvature across its boundary at vertex 1: hold t'),
  problem('a free boundary', askedOfSheet({ constraints: { boundary: { condition: 'free' } } }), 'minimized', '25 vertices, 16 faces, genus 0, boundaries 1'),
  problem('all faces holes', asked({ constraints: { holes: { faces: [1, 2, 3, 4, 5, 6] } } }), 'refused', 'constraints.holes: all faces are holes'),
  problem('holes that meet at a vertex', askedOfSheet({ constraints: { holes: { faces: [6, 11] } } }), 'refused', 'vertex 13 joins 2 fans of faces with holes between them: not a manifold'),
  problem('a fill of a closed cage', asked({ fill: {} }), 'refused', 'fill: the cage is closed, and has no boundary to fill'),
  problem('a fill of boundary 2 of 1', askedOfSheet({ fill: { loops: [2] } }), 'refused', 'fill.loops[0]: there is no boundary 2; the cage has 1'),
  problem('a fill with a corner inside', askedOfSheet({ fill: { corners: [7] } }), 'refused', 'fill.corners[0]: vertex 7 is on no boundary of the cage'),
  problem('a fill of a lone square', JSON.stringify({ ...plain, cage: { text: sheet(1, 1) }, fill: {} }), 'refused', 'fill: every face of the cage touches a filled boundary, and its surface depends on the fill: there i'),
  problem('flat sheet without energy', askedOfSheet({}), 'minimized', '25 vertices, 16 faces, genus 0, boundaries 1'),
];
