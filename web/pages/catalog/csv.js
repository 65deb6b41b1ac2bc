// SPDX-License-Identifier: MIT
/**
 * @file The catalog as comma-separated values (RFC 4180): one line per entry, numbers with all digits.
 */

/** @import {Catalog, CatalogEntry, CatalogShape} from '../../files/catalog.js' */

/** @typedef {string | number | null | undefined} Value */

/** @type {Array<[string, (entry: CatalogEntry, shape: CatalogShape) => Value]>} */
const columns = [
  ['shape', ({ shape }) => shape],
  ['genus', (_, { genus }) => genus],
  ['junctions', (_, { junctions }) => junctions],
  ['arms', (_, { arms }) => arms],
  ['sides', (_, { sides }) => sides],
  ['boundary', (_, { constraints }) => constraints?.boundary?.condition],
  ['group', ({ group }) => group?.name],
  ['group_order', ({ group }) => group?.order],
  ['functional', ({ functional }) => functional],
  ['status', ({ status }) => status],
  ['energy', ({ energy }) => energy],
  ['error', ({ error }) => error],
  ['paper', ({ paper }) => paper],
  ['exact', ({ exact }) => exact],
  ['exact_source', ({ exact_source }) => exact_source],
  ['bending', ({ energies }) => energies?.bending],
  ['willmore', ({ energies }) => energies?.willmore],
  ['mvs', ({ energies }) => energies?.mvs],
  ['mvs_cross', ({ energies }) => energies?.mvs_cross],
  ['mehlum_tarrou', ({ energies }) => energies?.mehlum_tarrou],
  ['second_form_variation', ({ energies }) => energies?.second_form_variation],
  ['mean_curvature_variation', ({ energies }) => energies?.mean_curvature_variation],
  ['curvedness_variation', ({ energies }) => energies?.curvedness_variation],
  ['area', ({ energies }) => energies?.area],
  ['gaussian', ({ energies }) => energies?.gaussian],
  ['quadrature_error', ({ energies }) => energies?.quadrature_error],
  ['level', ({ level }) => level],
  ['faces', ({ faces }) => faces],
  ['negative_directions', ({ certificate }) => certificate?.negative],
  ['reason', ({ reason }) => reason],
];

/** @param {Value} value */
function field(value) {
  const text = value === null || value === undefined ? '' : String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** @param {Catalog} catalog @returns {string} */
export function catalogCsv({ version, shapes, entries }) {
  const byName = new Map(shapes.map((shape) => [shape.name, shape]));
  const lines = entries.map((entry) => {
    const shape = byName.get(entry.shape);
    if (!shape) throw new Error(`the catalog has no shape ${entry.shape}`);
    return [...columns.map(([, value]) => value(entry, shape)), version];
  });
  const head = [...columns.map(([name]) => name), 'version'];
  return [head, ...lines].map((line) => `${line.map(field).join(',')}\r\n`).join('');
}
