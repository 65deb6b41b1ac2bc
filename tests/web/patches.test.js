// SPDX-License-Identifier: MIT
/**
 * @file The edges of patches, in limit meshes of the core.
 */
import { beforeAll, expect, test } from '@jest/globals';
import { Minimizer, load } from '../../wasm/umbilic.js';
import { patchEdges } from '../../web/scene/patches.js';

beforeAll(() => load());

// Symmetric cages have patches in both orientations.
test.each(['two-3', 'cube-frame'])(
  'of %s are those of the coarsest mesh, each in as many parts as its density',
  (generator) => {
    const run = new Minimizer({ cage: { generator }, terms: { bending: 1 }, options: { levels: [0, 0] } });
    const { edges } = run.controlMesh();
    for (const density of [1, 2, 3, 5]) {
      const mesh = run.limitMesh(density);
      const found = patchEdges(mesh, density);
      expect(found.length).toBe(density * edges.length);
      const ends = new Map();
      for (const vertex of found) ends.set(vertex, (ends.get(vertex) ?? 0) + 1);
      // Points inside an edge have two parts of it, and the others are the corners of patches.
      const inside = [...ends.values()].filter((count) => count === 2).length;
      expect(inside).toBe(((density - 1) * edges.length) / 2);
    }
    run.dispose();
  },
);
