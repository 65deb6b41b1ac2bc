// SPDX-License-Identifier: MIT
/**
 * @file Command lines that ask for what cannot be, or for no command at all.
 */
import { range, sheet, tetrahedron } from './contents.js';
import { command } from './row.js';

const minimize = 'optimize - --functional bending --levels 0 --max-iterations 2 -q --report -';
/** @param {string} more @param {import('./row.js').Outcome} outcome @param {string} says @param {string} [input] */
const minimizing = (more, outcome, says, input = tetrahedron) => command(`${minimize} ${more}`, outcome, says, input);

// One row a line.
// prettier-ignore
export const commandRows = [
  command('', 'usage', 'A command is required'),
  command('\u001b[2J', 'usage', 'The following argument was not expected: ?[2J'),
  command('a\u0007b', 'usage', 'The following argument was not expected: a?b'),
  command(range(1000).map(() => 'info').join(' '), 'usage', 'The following arguments were not expected: info info info info info info info info info info info in'),
  command('x'.repeat(100000), 'usage', 'The following argument was not expected: xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx'),
  command('info', 'usage', 'CAGE is required'),
  command('info -- --', 'refused', 'cannot read --: No such file or directory'),
  command('info does-not-exist.obj', 'refused', 'cannot read does-not-exist.obj: No such file or directory'),
  command('info /dev/null', 'refused', '/dev/null: the file is empty'),
  command('info /', 'refused', 'cannot read /: Is a directory'),
  command(`info ${'a'.repeat(300)}`, 'refused', 'cannot read aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa'),
  command('info does/not/../exist\u001b.obj', 'refused', 'cannot read does/not/../exist?.obj: No such file or directory'),
  command('evaluate - --levels 20', 'refused', 'level 20 would have 3.3e+12 faces; at most 2000000 are possible', tetrahedron),
  command('evaluate - --levels 99999999999999999999', 'usage', "'99999999999999999999' is not an integer from 0 to 20", tetrahedron),
  command('evaluate - --levels 0x1', 'usage', "'0x1' is not an integer from 0 to 20", tetrahedron),
  command('evaluate - --levels nan', 'usage', "'nan' is not an integer from 0 to 20", tetrahedron),
  command('cage torus --segments 1000000000x3', 'usage', "'1000000000x3' is not MxN, two numbers of segments"),
  command('cage torus --segments -3x3', 'usage', "'-3x3' is not MxN, two numbers of segments"),
  command('cage torus --ratio inf', 'usage', "'inf' is not a number"),
  command('cage torus --ratio 1e-400', 'usage', 'ratio 0 is not between 0 and 1'),
  command('cage __proto__', 'usage', 'there is no cage called __proto__;'),
  command('torus --ratio 2', 'usage', "'2' is not between 0 and 1"),
  command('optimize - --functional bending --levels 0..20', 'refused', 'level 20 would have 3.3e+12 faces; at most 2000000 are possible', tetrahedron),
  command('optimize - --functional bending --levels 3..2', 'usage', "'3..2' is not A..B or A with 0 <= A <= B <= 20"),
  command('optimize - --functional bending --levels 0..4294967296', 'usage', "'0..4294967296' is not A..B or A with 0 <= A <= B <= 20"),
  minimizing('--levels 0', 'usage', 'At Most 1 required but received 2'),
  minimizing('--tolerance 1e400', 'usage', "'1e400' is not a number"),
  minimizing('--tolerance -0', 'minimized', '4 vertices, 4 faces, genus 0'),
  minimizing('--max-iterations 99999999999', 'usage', "'99999999999' is not an integer from 0 to 2147483647"),
  minimizing('--threads 0', 'usage', "'0' is not an integer from 1 to 256"),
  minimizing('--threads 257', 'usage', "'257' is not an integer from 1 to 256"),
  minimizing('--threads 1', 'minimized', '4 vertices, 4 faces, genus 0'),
  minimizing('--weights mvs=1', 'usage', '--functional excludes --weights'),
  minimizing('--hold nothing', 'refused', "constraints.hold.groups[0]: there is no group 'nothing'; the cage has no groups"),
  minimizing('--pin 5', 'refused', 'constraints.pins[0].vertex: 5, but the cage has 4 vertices'),
  minimizing('--pin 0', 'usage', "'0' is not an integer from 1 to 2147483647"),
  minimizing('--pin 1@1,2', 'usage', "'1@1,2' has no three coordinates behind @"),
  minimizing('--pin 1@nan,0,0', 'usage', "'nan' is not a number"),
  minimizing('--pin 1@1e308,1e308,1e308', 'refused', 'constraints.pins[0].at[0]: too large for the cage'),
  minimizing('--pin 1 --pin 1@5,5,5', 'refused', 'constraints: pin 1 (x), pin 2 (x) cannot all hold'),
  minimizing('--within 0', 'usage', "'0' is not a number > 0"),
  minimizing('--within -1', 'usage', "'-1' is not a number > 0"),
  minimizing('--closeness -1', 'usage', "'-1' is negative"),
  minimizing('--accuracy 0%', 'usage', "'0%' is none of draft, good, fine, nor a percentage as in 2%"),
  minimizing('--accuracy 200%', 'usage', "'200%' is none of draft, good, fine, nor a percentage as in 2%"),
  minimizing('--boundary glued', 'usage', "'glued' is none of free, position, tangent, curvature"),
  minimizing('--fill', 'refused', 'fill: the cage is closed, and has no boundary to fill'),
  minimizing('--fill 0', 'usage', "'0' is not all, nor numbers of boundaries as in 1,3 (where INPUT follows, write --fill=all)", sheet(4, 4)),
  minimizing('--fill 2', 'refused', 'fill.loops[0]: there is no boundary 2; the cage has 1', sheet(4, 4)),
  minimizing('--holes nothing', 'refused', "constraints.holes.groups[0]: there is no group 'nothing'; the cage has no groups", sheet(4, 4)),
  minimizing('--density 65', 'usage', "'65' is not an integer from 1 to 64"),
];
