// SPDX-License-Identifier: MIT
/**
 * @file Cages from files, pipes and the generator, and cages that are none.
 */
import { afterAll, describe, expect, test } from '@jest/globals';
import { jsonOf, openTetrahedron, outputOf, scratchFolder, shell, tetrahedron, umbilic } from './program.js';

const scratch = scratchFolder();
afterAll(scratch.dispose);

const readers = [
  ['info'],
  ['evaluate'],
  ['optimize', '--functional', 'bending'],
  ['check-gradient', '--functional', 'bending'],
];

describe.each(readers)('%s', (...command) => {
  test('names file, line and reason of a broken cage and ends with 3', () => {
    const broken = `${tetrahedron}f 1 3 2\n`;
    const file = scratch.write('broken.obj', broken);
    const reason = 'line 9: edge between vertices 1 and 2 belongs to 3 faces: not a manifold';
    expect(umbilic([...command, file])).toEqual({ code: 3, out: '', err: `umbilic: ${file}: ${reason}\n` });
    expect(umbilic([...command, '-'], { input: broken })).toEqual({
      code: 3,
      out: '',
      err: `umbilic: standard input: ${reason}\n`,
    });
  });

  test('ends with 3 where there is no file', () => {
    const { code, err } = umbilic([...command, scratch.path('missing.obj')]);
    expect({ code, err }).toEqual({
      code: 3,
      err: `umbilic: cannot read ${scratch.path('missing.obj')}: No such file or directory\n`,
    });
    expect(umbilic([...command, scratch.folder])).toMatchObject({ code: 3, out: '' });
  });

  test('ends with 3 on empty and binary input', () => {
    expect(umbilic([...command, '-'])).toMatchObject({ code: 3, err: 'umbilic: standard input: the file is empty\n' });
    expect(umbilic([...command, '-'], { input: 'PK\x03\x04\0\0\0' })).toMatchObject({
      code: 3,
      err: 'umbilic: standard input: line 1: not a text file: it holds a zero byte\n',
    });
  });
});

test('a name of a cage that a terminal would obey is printed without what makes it do so', () => {
  const cage = { name: 'a\n\u001b[2Jb', text: 'v 0 0 0\nf 1 2 3\n' };
  const problem = JSON.stringify({ umbilic: 'problem', version: 1, cage, terms: { bending: 1 } });
  const { code, err } = umbilic(['optimize', '-'], { input: problem });
  expect({ code, err }).toEqual({
    code: 3,
    err: 'umbilic: a??[2Jb: line 2: face 1 names vertex 2, but there are 1 vertices\n',
  });
});

describe('binary PLY', () => {
  /** A tetrahedron in the format binary_big_endian. @param {number} [index] the last index of the first face */
  function ply(index = 2) {
    const header =
      'ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n' +
      'property uchar red\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n';
    const body = Buffer.alloc(4 * 25 + 4 * 13);
    const third = 1 / 3;
    const vertices = [
      [third, third, third],
      [third, -third, -third],
      [-third, third, -third],
      [-third, -third, third],
    ];
    vertices.flat().forEach((x, i) => body.writeDoubleBE(x, 25 * Math.floor(i / 3) + 8 * (i % 3)));
    const faces = [
      [0, 1, index],
      [0, 2, 3],
      [0, 3, 1],
      [1, 3, 2],
    ];
    faces.forEach((face, f) => {
      body.writeUInt8(3, 100 + 13 * f);
      face.forEach((v, k) => body.writeInt32BE(v, 101 + 13 * f + 4 * k));
    });
    return Buffer.concat([Buffer.from(header), body]);
  }

  test.each(readers)('is read by %s, from a file and from a pipe', (...command) => {
    const file = scratch.write('tetrahedron.ply', ply());
    expect(umbilic([...command, file])).toMatchObject({ code: 0 });
    expect(shell(`"$UMBILIC" ${command.join(' ')} - < tetrahedron.ply`, scratch.folder)).toMatchObject({ code: 0 });
  });

  test('is described as any other cage', () => {
    const { cage } = jsonOf(['info', scratch.write('coloured.ply', ply()), '--json']);
    expect(cage).toEqual(jsonOf(['info', '-', '--json'], { input: tetrahedron }).cage);
  });

  test('stands in problems and reports as text with the same digits', () => {
    const file = scratch.write('third.ply', ply());
    const problem = jsonOf(['optimize', file, '--functional', 'bending', '--print-problem']);
    const vertices = problem.cage.text.match(/^v .*$/gm);
    expect(vertices.slice(0, 2)).toEqual([`v ${1 / 3} ${1 / 3} ${1 / 3}`, `v ${1 / 3} ${-1 / 3} ${-1 / 3}`]);
    const asked = { umbilic: 'problem', version: 1, cage: { file: 'third.ply' }, terms: { bending: 1 } };
    const beside = scratch.write('problem.json', JSON.stringify(asked));
    expect(jsonOf(['optimize', beside, '--print-problem']).cage.text).toBe(problem.cage.text);
  });

  test.each(readers)('is refused by %s with the name of the element', (...command) => {
    const file = scratch.write('broken.ply', ply(4));
    const reason = "'face' 1: index 4 does not exist: 4 vertices have the indices 0 to 3";
    expect(umbilic([...command, file])).toEqual({ code: 3, out: '', err: `umbilic: ${file}: ${reason}\n` });
  });
});

describe('a cage whose surface cannot be evaluated', () => {
  // Two triangles back to back: closed, and every vertex has valence 2.
  const pillow = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n';

  test('is described by info and refused by the rest', () => {
    expect(outputOf(['info', '-'], { input: pillow })).toContain('its surface cannot be evaluated: ');
    expect(jsonOf(['info', '-', '--json'], { input: pillow })).not.toHaveProperty('first_level');
    const { code, err } = umbilic(['evaluate', '-'], { input: pillow });
    expect(code).toBe(3);
    expect(err).toMatch(/^umbilic: standard input: .*vertex 1\b.*valence 2/);
  });

  test('is refused where a third-order functional would diverge', () => {
    const { code, err } = umbilic(['optimize', '-', '--functional', 'mvs', '--cap', 'none'], { input: tetrahedron });
    expect(code).toBe(3);
    expect(err).toMatch(/^umbilic: standard input: /);
  });
});

describe('an open cage', () => {
  const annulus =
    'v 9 9 9\nv 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n' +
    't crease 2/1/0 0 1 3\ng south\nf 2 3 7 6\ng rest\nf 3 4 8 7\nf 4 5 9 8\nf 5 2 6 9\n';

  test('is described by info with its boundaries and groups', () => {
    expect(outputOf(['info', '-'], { input: annulus })).toBe(
      'standard input: 8 vertices, 12 edges, 4 faces, genus 0, 2 boundaries\n' +
        'repaired: dropped 1 vertex that no face uses\n' +
        'note: ignored 1 crease tag (on line 10): edges stay smooth\n' +
        '  boundary 1: 4 vertices, from vertex 2\n  boundary 2: 4 vertices, from vertex 6\n' +
        '  group south: 1 face\n  group rest: 3 faces\n' +
        '  valences     8 x 3\n  face sizes   4 x 4\n' +
        '  first level that can be evaluated: 1\n',
    );
    const { cage, first_level } = jsonOf(['info', '-', '--json'], { input: annulus });
    expect(first_level).toBe(1);
    expect(cage).toMatchObject({
      genus: 0,
      components: [{ boundaries: 2 }],
      boundaries: [
        { number: 1, vertices: 4, first_vertex: 2, component: 1 },
        { number: 2, vertices: 4, first_vertex: 6, component: 1 },
      ],
      groups: [
        { name: 'south', faces: 1 },
        { name: 'rest', faces: 3 },
      ],
      notes: ['ignored 1 crease tag (on line 10): edges stay smooth'],
    });
  });

  test.each(readers.slice(1))('is read by %s', (...command) => {
    expect(umbilic([...command, '-'], { input: openTetrahedron })).toMatchObject({ code: 0 });
  });

  test.each(readers.slice(1))('is refused by %s where too many faces meet on its boundary', (...command) => {
    const count = 13;
    const rim = [...Array(count + 1).keys()].map(
      (k) => `v ${Math.cos((k * 3) / count)} ${Math.sin((k * 3) / count)} 0`,
    );
    const faces = [...Array(count).keys()].map((k) => `f 1 ${k + 2} ${k + 3}`);
    expect(umbilic([...command, '-'], { input: ['v 0 0 0', ...rim, ...faces].join('\n') })).toEqual({
      code: 3,
      out: '',
      err: 'umbilic: standard input: vertex 1 has 13 faces and lies on the boundary, where at most 12 are possible\n',
    });
  });
});

describe('a generated cage', () => {
  test('goes through a pipe', () => {
    const { code, out } = shell('"$UMBILIC" cage cube | "$UMBILIC" info -', scratch.folder);
    expect(code).toBe(0);
    expect(out).toBe(
      'standard input: 8 vertices, 12 edges, 6 faces, genus 0\n' +
        '  valences     8 x 3\n  face sizes   6 x 4\n  first level that can be evaluated: 1\n',
    );
  });

  const withoutFamily = ['cube', 'torus', 'disk', 'cylinder', 'catenoid', 'spherical-cap', 'n-sided'];
  const names = outputOf(['cage', '--list'])
    .trim()
    .split('\n')
    .map((line) => /** @type {[string, number]} */ ([line.split(' ')[0], Number(/genus (\d+)/.exec(line)?.[1])]));

  test('is one of 27', () => expect(names).toHaveLength(27));

  test.each(names)('%s has the genus that it is listed with, in both families', (name, genus) => {
    const families = withoutFamily.includes(name)
      ? [[]]
      : [
          ['--family', 'hub'],
          ['--family', 'flag'],
        ];
    for (const family of families) {
      const { cage } = jsonOf(['info', '-', '--json'], { input: outputOf(['cage', name, ...family]) });
      expect(cage.genus).toBe(genus);
    }
  });

  test('is written to a file', () => {
    expect(outputOf(['cage', 'torus', '--segments', '5x4', '--ratio', '0.3', '-o', 'torus.obj'], scratch)).toBe('');
    expect(jsonOf(['info', 'torus.obj', '--json'], scratch).cage).toMatchObject({ vertices: 20, faces: 20, genus: 1 });
  });

  test('is thicker with --thickness, and hub is another family than flag', () => {
    const thin = outputOf(['cage', 'two-3', '--thickness', '0.5']);
    expect(thin).toMatch(/^v 0 0 1\.166/);
    expect(outputOf(['cage', 'two-3'])).toMatch(/^v 0 0 1\.333/);
    expect(jsonOf(['info', '-', '--json'], { input: thin }).valences).toEqual({ 4: 18, 6: 4 });
    const hub = outputOf(['cage', 'two-3', '--family', 'hub']);
    expect(jsonOf(['info', '-', '--json'], { input: hub }).valences).toEqual({ 4: 12, 5: 12 });
  });
});
