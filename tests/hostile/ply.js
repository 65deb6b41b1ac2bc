// SPDX-License-Identifier: MIT
/**
 * @file PLY files with anything in them: headers, text and bytes.
 */
import { binaryPly, bytes, junk, ply, range } from './contents.js';
import { cage } from './row.js';

const xyz = 'property float x\nproperty float y\nproperty float z';
const points = '1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1';
const faces = '3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n';
/** @param {string} first of the faces */
const withFirstFace = (first) => ply({ body: `${points}\n${faces.replace('3 0 1 2', first)}` });

// One row a line.
// prettier-ignore
export const plyRows = [
  // The header.
  cage('PLY alone', 'ply\n', 'refused', 'line 2: the file ends before the line end_header'),
  cage('PLY in capitals', ply().replace('ply', 'PLY'), 'refused', 'neither OBJ nor OFF nor PLY'),
  cage('PLY with CR', ply().replaceAll('\n', '\r'), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('PLY with CRLF', ply().replaceAll('\n', '\r\n'), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('PLY behind a byte-order mark', `\uFEFF${ply()}`, 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('PLY without a format', ply({ format: '' }), 'refused', 'line 2: the line of the format must come first'),
  cage('PLY with two formats', ply({ format: 'format ascii 1.0\nformat ascii 1.0' }), 'refused', 'line 3: a second line of the format'),
  cage('PLY of version 2.0', ply({ format: 'format ascii 2.0' }), 'refused', "line 2: version '2.0' of the format is not 1.0"),
  cage('PLY in a middle-endian format', ply({ format: 'format binary_middle_endian 1.0' }), 'refused', "line 2: format 'binary_middle_endian' is none of ascii, binary_little_endian, binary_big_endian"),
  cage('PLY without the end of its header', ply({ end: '' }), 'refused', "line 9: expected element, property, comment or end_header, found '1'"),
  cage('PLY without vertices', ply({ vertex: '' }), 'refused', 'line 5: the header ends without an element vertex'),
  cage('PLY without faces', ply({ face: '' }), 'refused', 'line 7: the header ends without an element face: strips, edges and points are not read'),
  cage('PLY of triangle strips', ply({ face: 'element tristrips 1\nproperty list int int vertex_indices' }), 'refused', 'line 9: the header ends without an element face: strips, edges and points are not read'),
  cage('PLY with two elements vertex', ply({ vertex: `element vertex 4\n${xyz}\nelement vertex 4\n${xyz}` }), 'refused', 'line 7: a second element vertex'),
  cage('PLY with a property first', ply({ vertex: `property float x\nelement vertex 4\n${xyz}` }), 'refused', 'line 3: a property before the first element'),
  cage('PLY with an unknown type', ply({ vertex: 'element vertex 4\nproperty half x\nproperty float y\nproperty float z' }), 'refused', "line 4: 'half' is no type of a property (as uchar, int, float or double are)"),
  cage('PLY with a property without a name', ply({ vertex: `element vertex 4\n${xyz}\nproperty float` }), 'refused', 'line 7: the property has no name'),
  cage('PLY without z', ply({ vertex: 'element vertex 4\nproperty float x\nproperty float y' }), 'refused', 'line 3: the element vertex has no property z'),
  cage('PLY with x twice', ply({ vertex: `element vertex 4\n${xyz}\nproperty float x` }), 'refused', 'line 3: the element vertex has two properties x'),
  cage('PLY with a list of coordinates', ply({ vertex: 'element vertex 4\nproperty list uchar float x\nproperty float y\nproperty float z' }), 'refused', 'line 3: the property x is a list, not a number'),
  cage('PLY with faces without their list', ply({ face: 'element face 4\nproperty int material' }), 'refused', 'line 7: the element face has no property vertex_indices or vertex_index'),
  cage('PLY with indices that are no list', ply({ face: 'element face 4\nproperty int vertex_indices' }), 'refused', 'line 7: the property vertex_indices is no list'),
  cage('PLY with both names of the list', ply({ face: 'element face 4\nproperty list uchar int vertex_indices\nproperty list uchar int vertex_index', body: `${points}\n3 0 1 2 0\n3 0 2 3 0\n3 0 3 1 0\n3 1 3 2 0\n` }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('PLY with -4 vertices', ply({ vertex: `element vertex -4\n${xyz}` }), 'refused', "line 3: expected the name of an element and how many there are, found 'vertex' and '-4'"),
  cage('PLY with 2^64 vertices', ply({ vertex: `element vertex 18446744073709551616\n${xyz}` }), 'refused', 'line 3: 9223372036854775807 elements vertex: at most 4000000 are read'),
  cage('PLY with 4 000 000 vertices announced', ply({ vertex: `element vertex 4000000\n${xyz}` }), 'refused', "line 14: '2' is more than the header announces"),
  cage('PLY with 2^31 faces announced', ply({ face: 'element face 2147483648\nproperty list uchar int vertex_indices' }), 'refused', 'line 7: 2147483648 elements face: at most 4000000 are read'),
  cage('PLY with 2^62 elements that have no properties', ply({ face: 'element nothing 4611686018427387904\nelement face 4\nproperty list uchar int vertex_indices' }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('PLY with 2^62 elements of a list', ply({ face: 'element face 4\nproperty list uchar int vertex_indices\nelement more 4611686018427387904\nproperty list uchar int a' }), 'refused', "line 19: the file ends after 0 of the 4611686018427387904 elements 'more' that line 9 announces"),
  cage('PLY with a count of words', ply({ vertex: `element vertex four\n${xyz}` }), 'refused', "line 3: expected the name of an element and how many there are, found 'vertex' and 'four'"),
  cage('PLY with a word too many', ply({ vertex: `element vertex 4 5\n${xyz}` }), 'refused', "line 3: more words than 'element' takes"),
  cage('PLY with an unknown statement', ply({ vertex: `elements vertex 4\n${xyz}` }), 'refused', "line 3: expected element, property, comment or end_header, found 'elements'"),
  cage('PLY with a header of 100 000 comments', () => ply({ format: `format ascii 1.0\n${'comment a\n'.repeat(100000)}obj_info b` }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('PLY with 10 000 properties', () => ply({ vertex: `element vertex 4\n${xyz}\n${range(10000).map((i) => `property float p${i}`).join('\n')}` }), 'refused', "line 10010: the line ends before 'p0'"),
  cage('PLY with an escape in a keyword', ply({ vertex: `\u001b[2J vertex 4\n${xyz}` }), 'refused', "line 3: expected element, property, comment or end_header, found '?[2J'"),

  // Text.
  cage('PLY with a coordinate NaN', ply({ body: `nan 1 1\n${points.slice(6)}\n${faces}` }), 'refused', 'line 10: the coordinate x is not finite'),
  cage('PLY with a coordinate 1e400', ply({ body: `1e400 1 1\n${points.slice(6)}\n${faces}` }), 'refused', 'line 10: the coordinate x is not finite'),
  cage('PLY with a line that ends early', ply({ body: `1 1\n${points.slice(6)}\n${faces}` }), 'refused', "line 10: the line ends before 'z'"),
  cage('PLY with a number too many', ply({ body: `1 1 1 1\n${points.slice(6)}\n${faces}` }), 'refused', "line 10: '1' is more than the header announces"),
  cage('PLY with a line too many', ply({ body: `${points}\n${faces}3 0 1 2\n` }), 'refused', 'line 18: the file goes on behind the last element that its header announces'),
  cage('PLY with a line too few', ply({ body: `${points}\n${faces.slice(0, 24)}` }), 'refused', "line 16: the file ends after 3 of the 4 elements 'face' that line 7 announces"),
  cage('PLY with index 4 of 4', withFirstFace('3 0 1 4'), 'refused', 'line 14: index 4 does not exist: 4 vertices have the indices 0 to 3'),
  cage('PLY with index -1', withFirstFace('3 0 1 -1'), 'refused', 'line 14: index -1 does not exist: 4 vertices have the indices 0 to 3'),
  cage('PLY with index 0.5', withFirstFace('3 0 1 0.5'), 'refused', 'line 14: index 0.5 does not exist: 4 vertices have the indices 0 to 3'),
  cage('PLY with index NaN', withFirstFace('3 0 1 nan'), 'refused', 'line 14: index nan does not exist: 4 vertices have the indices 0 to 3'),
  cage('PLY with a list of -1', withFirstFace('-1'), 'refused', "line 14: -1 is no length of the list 'vertex_indices'"),
  cage('PLY with a list of 1e300', withFirstFace('1e300 0 1 2'), 'refused', 'line 14: a face of more than 10000 vertices'),
  cage('PLY with a list of 2.5', withFirstFace('2.5 0 1 2'), 'refused', "line 14: 2.5 is no length of the list 'vertex_indices'"),
  cage('PLY with a list of NaN', withFirstFace('nan 0 1 2'), 'refused', "line 14: nan is no length of the list 'vertex_indices'"),
  cage('PLY with a face of two vertices', withFirstFace('2 0 1'), 'refused', 'line 14: face 1 has 2 vertices'),
  cage('PLY with no vertices at all', ply({ vertex: `element vertex 0\n${xyz}`, body: faces }), 'refused', 'line 10: index 0 does not exist: there are no vertices'),

  // Bytes.
  cage('binary PLY', () => binaryPly(), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('binary PLY, big-endian', () => binaryPly({ big: true }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('binary PLY that says it is of the other order', () => bytes(String.fromCharCode(...binaryPly()).slice(0, 11), 'binary_big_endian', binaryPly().subarray(31)), 'refused', "'face' 1: a face of more than 10000 vertices"),
  cage('binary PLY with a coordinate NaN', () => binaryPly({ x: NaN }), 'refused', "'vertex' 0: the coordinate x is not finite"),
  cage('binary PLY with an infinite coordinate', () => binaryPly({ x: -Infinity, big: true }), 'refused', "'vertex' 0: the coordinate x is not finite"),
  cage('binary PLY with the least denormal coordinate', () => binaryPly({ x: 5e-324 }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('binary PLY with the largest coordinate', () => binaryPly({ x: Number.MAX_VALUE }), 'refused', 'face 1 is part of no surface: all vertices of the cage lie on one line'),
  cage('binary PLY with index -1', () => binaryPly({ index: -1 }), 'refused', "'face' 1: index -1 does not exist: 4 vertices have the indices 0 to 3"),
  cage('binary PLY with index 2^31 - 1', () => binaryPly({ index: 2147483647 }), 'refused', "'face' 1: index 2147483647 does not exist: 4 vertices have the indices 0 to 3"),
  cage('binary PLY with a list of 2^32 - 1', () => binaryPly({ length: 4294967295 }), 'refused', "'face' 1: a face of more than 10000 vertices"),
  cage('binary PLY with a list of 10 000', () => binaryPly({ length: 10000 }), 'refused', "'face' 1: the file ends before 'vertex_indices'"),
  cage('binary PLY with an empty list', () => binaryPly({ length: 0 }), 'refused', 'the file goes on behind the last element that its header announces'),
  cage('binary PLY cut in its last face', () => binaryPly({ cut: 1 }), 'refused', "'face' 4: the file ends before 'vertex_indices'"),
  cage('binary PLY cut in its vertices', () => binaryPly({ cut: 100 }), 'refused', "'vertex' 2: the file ends before 'y'"),
  cage('binary PLY without its body', () => binaryPly({ cut: 160 }), 'refused', "the file ends after 0 of the 4 elements 'vertex' that line 3 announces"),
  cage('binary PLY cut in its header', () => binaryPly({ cut: 170 }), 'refused', 'line 9: the file ends before the line end_header'),
  cage('binary PLY with a byte too many', () => binaryPly({ more: 1 }), 'refused', 'the file goes on behind the last element that its header announces'),
  cage('binary PLY with junk for its body', () => bytes(binaryPly({ cut: 160 }), junk(160, 3)), 'refused', "'face' 1: a face of more than 10000 vertices"),
];
