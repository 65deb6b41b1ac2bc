// SPDX-License-Identifier: MIT
/**
 * @file All tables of hostile inputs, by family.
 */
import { commandRows } from './commands.js';
import { objRows } from './obj.js';
import { offRows } from './off.js';
import { plyRows } from './ply.js';
import { problemRows } from './problems.js';
import { placeRows, topologyRows } from './shapes.js';

/** @typedef {import('./row.js').Row} Row */

/** @type {[family: string, rows: Row[]][]} */
export const families = [
  ['OBJ', objRows],
  ['OFF', offRows],
  ['PLY', plyRows],
  ['topology', topologyRows],
  ['places', placeRows],
  ['problems', problemRows],
  ['commands', commandRows],
];
