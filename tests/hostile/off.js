// SPDX-License-Identifier: MIT
/**
 * @file OFF files with anything in them: keywords, counts, vertices, faces and lines.
 */
import { junk, off, range, utf16 } from './contents.js';
import { cage } from './row.js';

const vertices = '1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1';
const faces = '3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2';

// One row a line.
// prettier-ignore
export const offRows = [
  // The keyword.
  cage('OFF alone', 'OFF', 'refused', 'line 1: the file ends before the numbers of vertices and faces'),
  cage('OFF without a keyword', off({ head: '4 4 6' }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('OFF with the counts in its line', off({ head: 'OFF 4 4 6' }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('OFF with the counts without a blank', off({ head: 'OFF4 4 6' }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('binary OFF', 'OFF BINARY\n\u0000\u0000\u0000\u0004', 'refused', 'line 1: binary OFF is not read; save it as text'),
  cage('4OFF', off({ head: '4OFF\n4 4 6' }), 'refused', 'line 1: 4OFF has vertices of another dimension than 3'),
  cage('nOFF', off({ head: 'nOFF\n3\n4 4 6' }), 'refused', 'line 1: nOFF has vertices of another dimension than 3'),
  cage('off in small letters', off({ head: 'off\n4 4 6' }), 'refused', 'neither OBJ nor OFF nor PLY'),
  cage('COFF without colours', off({ head: 'COFF\n4 4 6' }), 'minimized', 'ignored of the vertices what COFF on line 1 announces: colours'),
  cage('STCNOFF with all that it announces', off({ head: 'STCNOFF\n4 4 6', vertices: vertices.replace(/$/gm, ' 0 0 1  1 0 0 1  0 0') }), 'minimized', 'ignored of the vertices what STCNOFF on line 1 announces: normals, colours, texture coordinates'),
  cage('COFFEE', off({ head: 'COFFEE\n4 4 6' }), 'refused', 'neither OBJ nor OFF nor PLY'),
  cage('OFF twice', off({ head: 'OFF\nOFF\n4 4 6' }), 'refused', "line 2: expected the numbers of vertices and faces, found 'OFF'"),
  cage('OFF behind a byte-order mark', `\uFEFF${off()}`, 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('OFF in UTF-16', utf16(off(), true), 'refused', 'line 1: not a text file: it holds a zero byte'),
  cage('OFF behind comments', `# made\n\n# by hand\n${off()}`, 'minimized', '4 vertices, 4 faces, genus 0'),

  // Counts.
  cage('OFF with one count', off({ head: 'OFF\n4' }), 'refused', 'line 8: more lines than the 4 vertices and 1 faces that line 2 announces'),
  cage('OFF with two counts', off({ head: 'OFF\n4 4' }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('OFF with no edges counted', off({ head: 'OFF\n4 4 0' }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('OFF with a negative count of edges', off({ head: 'OFF\n4 4 -6' }), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('OFF with a negative count of vertices', off({ head: 'OFF\n-4 4 6' }), 'refused', "line 2: expected the numbers of vertices and faces, found '-4'"),
  cage('OFF with a negative count of faces', off({ head: 'OFF\n4 -4 6' }), 'refused', "line 2: expected the numbers of vertices and faces, found '-4'"),
  cage('OFF with 2^63 vertices', off({ head: 'OFF\n9223372036854775808 4 6' }), 'refused', 'line 2: 9223372036854775807 vertices and 4 faces: at most 4000000 and 4000000 are read'),
  cage('OFF with 2^32 + 4 vertices', off({ head: 'OFF\n4294967300 4 6' }), 'refused', 'line 2: 4294967300 vertices and 4 faces: at most 4000000 and 4000000 are read'),
  cage('OFF with 4 000 000 vertices announced', off({ head: 'OFF\n4000000 4 6' }), 'refused', 'line 10: the file ends after 8 of the 4000000 vertices that line 2 announces'),
  cage('OFF with 4 000 001 faces announced', off({ head: 'OFF\n4 4000001 6' }), 'refused', 'line 2: 4 vertices and 4000001 faces: at most 4000000 and 4000000 are read'),
  cage('OFF with a count of words', off({ head: 'OFF\nfour 4 6' }), 'refused', "line 2: expected the numbers of vertices and faces, found 'four'"),
  cage('OFF with a count of 4.0', off({ head: 'OFF\n4.0 4 6' }), 'refused', "line 2: expected the numbers of vertices and faces, found '4.0'"),
  cage('OFF with no vertices and no faces', 'OFF\n0 0 0\n', 'refused', 'the cage has no faces'),
  cage('OFF with vertices and no faces', off({ head: 'OFF\n4 0 0', faces: '' }), 'refused', 'the cage has no faces'),
  cage('OFF with a vertex too few', off({ head: 'OFF\n5 4 6' }), 'refused', 'line 10: the file ends after 3 of the 4 faces that line 2 announces'),
  cage('OFF with a vertex too many', off({ head: 'OFF\n3 4 6' }), 'refused', "line 6: expected a face's number of vertices, found '-1'"),
  cage('OFF with a face too few', off({ head: 'OFF\n4 5 6' }), 'refused', 'line 10: the file ends after 4 of the 5 faces that line 2 announces'),
  cage('OFF with a face too many', off({ head: 'OFF\n4 3 6' }), 'refused', 'line 10: more lines than the 4 vertices and 3 faces that line 2 announces'),

  // Vertices.
  cage('OFF with a coordinate NaN', off({ vertices: vertices.replace('1 1 1', 'nan 1 1') }), 'refused', "line 3: coordinate 'nan' of vertex 1 is not finite"),
  cage('OFF with a coordinate 1e999', off({ vertices: vertices.replace('1 1 1', '1e999 1 1') }), 'refused', "line 3: coordinate '1e999' of vertex 1 is not finite"),
  cage('OFF with a coordinate of a word', off({ vertices: vertices.replace('1 1 1', 'x 1 1') }), 'refused', "line 3: coordinate 'x' of vertex 1 is not a number"),
  cage('OFF with two coordinates', off({ vertices: vertices.replace('1 1 1', '1 1') }), 'refused', 'line 7: face 1 has 0 vertices'),
  cage('OFF in one line', off().replaceAll('\n', ' '), 'refused', 'line 1: more than the 4 numbers of a colour behind the vertices of a face'),
  cage('OFF with one number in each line', off().replaceAll(' ', '\n'), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('OFF with wrapped lines and a wrong index', off({ faces: faces.replace('1 3 2', '1 3 4') }).replaceAll(' ', '\n'), 'refused', 'line 29: index 4 does not exist: 4 vertices have the indices 0 to 3'),
  cage('OFF with CRLF', off().replaceAll('\n', '\r\n'), 'minimized', '4 vertices, 4 faces, genus 0'),
  cage('OFF with a zero byte', off({ vertices: vertices.replace('1 1 1', '1 \u0000 1') }), 'refused', "line 3: coordinate '?' of vertex 1 is not a number"),
  cage('OFF with junk for its vertices', () => `OFF\n4 4 6\n${String.fromCharCode(...junk(1000).map((b) => b & 127))}`, 'refused', "line 3: coordinate '?!Au?8' of vertex 1 is not a number"),

  // Faces.
  cage('OFF with index 4 of 4', off({ faces: faces.replace('0 1 2', '0 1 4') }), 'refused', 'line 7: index 4 does not exist: 4 vertices have the indices 0 to 3'),
  cage('OFF with index -1', off({ faces: faces.replace('0 1 2', '0 1 -1') }), 'refused', 'line 7: index -1 does not exist: 4 vertices have the indices 0 to 3'),
  cage('OFF with index 2^32', off({ faces: faces.replace('0 1 2', '4294967296 1 2') }), 'refused', 'line 7: index 4294967296 does not exist: 4 vertices have the indices 0 to 3'),
  cage('OFF with index 1.0', off({ faces: faces.replace('0 1 2', '0 1.0 2') }), 'refused', "line 7: '1.0' is not a vertex index"),
  cage('OFF with a face of no vertices', off({ faces: faces.replace('3 0 1 2', '0') }), 'refused', 'line 7: face 1 has 0 vertices'),
  cage('OFF with a face of two vertices', off({ faces: faces.replace('3 0 1 2', '2 0 1') }), 'refused', 'line 7: face 1 has 2 vertices'),
  cage('OFF with a face of -3 vertices', off({ faces: faces.replace('3 0 1 2', '-3 0 1 2') }), 'refused', "line 7: expected a face's number of vertices, found '-3'"),
  cage('OFF with a face of 2^31 vertices', off({ faces: faces.replace('3 0 1 2', '2147483648 0 1 2') }), 'refused', 'line 7: a face of more than 10000 vertices'),
  cage('OFF with a face that ends early', off({ faces: faces.replace('3 0 1 2', '4 0 1 2') }), 'refused', 'line 7: a face of 4 vertices has only 3'),
  cage('OFF with colours of faces', off({ faces: faces.replace(/$/gm, ' 255 0 0') }), 'minimized', 'ignored the colours of 4 faces (the first on line 7)'),
  cage('OFF with a colour from a map', off({ faces: faces.replace(/$/gm, ' 7') }), 'minimized', 'ignored the colours of 4 faces (the first on line 7)'),
  cage('OFF with a colour of five numbers', off({ faces: faces.replace(/$/gm, ' 1 2 3 4 5') }), 'refused', 'line 7: more than the 4 numbers of a colour behind the vertices of a face'),
  cage('OFF with a colour of words', off({ faces: faces.replace(/$/gm, ' red') }), 'refused', "line 7: 'red' behind a face is not a number"),
  cage('OFF with a vertex twice in a face', off({ faces: faces.replace('0 1 2', '0 1 1') }), 'refused', 'line 7: face 1 names vertex 1 twice'),
  cage('OFF cut in its faces', off().slice(0, 50), 'refused', 'line 8: a face of 3 vertices has only 0'),
  cage('OFF with 100 000 vertices that no face uses', () => off({ head: 'OFF\n100004 4 6', vertices: `${vertices}\n${range(100000).map((i) => `${i} 0 0`).join('\n')}` }), 'minimized', 'dropped 100000 vertices that no face uses'),
];
