// SPDX-License-Identifier: MIT
/**
 * @file Meshes that nobody on this project made, where a folder with them stands beside the repository: minimized for some
 * steps, or refused with the reason.
 */
import { describe, expect, test } from '@jest/globals';
import { existsSync } from 'node:fs';
import path from 'node:path';
import { jsonOf, root, umbilic } from './program.js';

const folder = path.join(root, '../shared/cages');
const there = existsSync(folder);
if (!there) console.log(`Skipped: there is no folder ${folder}`);

(there ? describe : describe.skip)('a mesh of the shared folder', () => {
  test.each(['spot_control_mesh.obj', 'chamfer-cube.off', 'fandisk_quads.off', 'dodecahedron_poly.obj'])(
    '%s is minimized for some steps',
    (name) => {
      for (const functional of ['bending', 'mvs_cross']) {
        const optimize = (/** @type {number} */ iterations) =>
          jsonOf(
            ['optimize', path.join(folder, name), '--functional', functional, '--levels', '0', '--report', '-'].concat(
              '--max-iterations',
              `${iterations}`,
            ),
          );
        const before = optimize(0);
        const after = optimize(5);
        expect(after.cage.genus).toBe(0);
        const [{ iterations, stop }] = after.levels;
        if (iterations < 5) expect(stop).toBe('converged');
        // A dodecahedron that stays symmetric has nothing to move but its size.
        if (iterations > 0) expect(after.energies[functional]).toBeLessThan(before.energies[functional]);
        else expect(after.energies[functional]).toBe(before.energies[functional]);
      }
    },
    300_000,
  );

  test.each(['hemisphere_open.off', 'cube_no_bottom.obj'])(
    '%s is minimized for some steps with its tangents held',
    (name) => {
      for (const functional of ['bending', 'mvs_cross']) {
        const optimize = (/** @type {number} */ iterations) =>
          jsonOf(
            ['optimize', path.join(folder, name), '--functional', functional, '--levels', '0', '--report', '-'].concat(
              '--boundary',
              'tangent',
              '--max-iterations',
              `${iterations}`,
            ),
          );
        const [before, after] = [optimize(0), optimize(5)];
        expect(after.cage.boundaries).toHaveLength(1);
        expect(after.energies.resolved).toBe(true);
        expect(after.levels[0].energy).toBeLessThan(before.levels[0].energy);
      }
    },
    300_000,
  );

  test.each([
    [
      'moebius.obj',
      /line \d+: face \d+ cannot be turned to match all of its neighbours: the surface is not orientable/,
    ],
  ])('%s is refused', (name, reason) => {
    const { code, err } = umbilic(['optimize', path.join(folder, name), '--functional', 'bending']);
    expect(code).toBe(3);
    expect(err).toMatch(reason);
  });
});
