// SPDX-License-Identifier: MIT
/**
 * @file Makes the cage that a message names.
 */

/** @import {Cage} from '../../wasm/umbilic.js' */
/** @import {CageCounts} from '../../wasm/types.js' */
/** @import {Source} from './protocol.js' */

/**
 * @param {typeof Cage} core
 * @param {Source} source
 * @returns {{cage: Cage, counts: CageCounts}} the mesh to go on from, and the counts of the cage that it comes from
 * @throws {import('../../wasm/umbilic.js').InputError}
 */
export function cageFrom(core, source) {
  if (source.kind === 'text') {
    const cage = core.read(source.text);
    return { cage, counts: cage.counts };
  }
  const { name, family, thickness } = source;
  const cage = core.generate(name, { family, thickness });
  const { counts } = cage;
  if (source.kind === 'generated') return { cage, counts };
  try {
    return { cage: cage.refined(source.level, source.points), counts };
  } finally {
    cage.dispose();
  }
}
