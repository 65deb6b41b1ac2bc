// SPDX-License-Identifier: MIT
/**
 * @file What the views derive from the state: the visible rows in order, the values to filter by, and single entries.
 */
import { entryName } from '../../address/compare.js';
import { boundaryWords, shapeTitle } from '../../words/entries.js';

/** @import {CatalogAddress} from '../../address/catalog.js' */
/** @import {Catalog, CatalogEntry, CatalogFunctional, CatalogShape} from '../../files/catalog.js' */
/** @import {EntryId, Filter, Row, State} from './types.js' */

/** All rows in the catalog's order. @param {Catalog} catalog @returns {Row[]} */
export function allRows({ shapes, functionals, entries }) {
  const byId = new Map(entries.map((entry) => [entryName(entry), entry]));
  return shapes.map((shape) => ({
    shape,
    entries: functionals.map(({ name }) => byId.get(entryName({ shape: shape.name, functional: name })) ?? null),
  }));
}

/** The symmetry group of a row, which all its entries share. @param {Row} row */
export function groupOf({ entries }) {
  return entries.find((entry) => entry?.group)?.group ?? null;
}

/** @param {Row} row @param {Filter} filter */
function passes(row, { genus, arms, group, status, search }) {
  const { shape, entries } = row;
  const open = shape.sides ? `open ${boundaryWords(shape)}` : '';
  const text =
    `${shape.name} ${shapeTitle(shape.name)} ${groupOf(row)?.name} genus ${shape.genus} ${open}`.toLowerCase();
  return (
    (genus === null || shape.genus === genus) &&
    (arms === null || shape.arms === arms) &&
    (group === '' || groupOf(row)?.name === group) &&
    (status === '' || entries.some((entry) => entry?.status === status)) &&
    search
      .toLowerCase()
      .split(/\s+/)
      .every((word) => text.includes(word))
  );
}

/**
 * The number by which a row is sorted; null if it has none, and then it comes last in either direction.
 * @param {Row} row
 * @param {string} key
 * @returns {number | null}
 */
function rank(row, key) {
  if (key === 'genus') return row.shape.genus;
  return row.entries.find((entry) => entry?.functional === key)?.energy ?? null;
}

/** @param {Row[]} rows in the catalog's order @param {CatalogAddress} address @returns {Row[]} */
function sorted(rows, { sort: key, direction }) {
  const sign = direction === 'asc' ? 1 : -1;
  if (key === 'shape') return sign > 0 ? rows : rows.toReversed();
  return rows.toSorted((one, other) => {
    const [a, b] = [rank(one, key), rank(other, key)];
    if (a === null || b === null) return Number(a === null) - Number(b === null);
    return sign * (a - b);
  });
}

/** The rows that pass the filter, sorted. @param {State} state @returns {Row[]} */
export function visibleRows({ catalog, address }) {
  if (!catalog) return [];
  return sorted(
    allRows(catalog).filter((row) => passes(row, address)),
    address,
  );
}

/**
 * The values that rows can be filtered by.
 * @param {Catalog} catalog
 * @returns {{genus: number[], arms: number[], group: string[]}}
 */
export function filterValues(catalog) {
  const rows = allRows(catalog);
  /** @param {number[]} values */
  const distinct = (values) => [...new Set(values)].sort((a, b) => a - b);
  return {
    genus: distinct(rows.map(({ shape }) => shape.genus)),
    arms: distinct(rows.map(({ shape }) => shape.arms).filter((arms) => arms > 0)),
    group: [...new Set(rows.flatMap((row) => groupOf(row)?.name ?? []))].sort(),
  };
}

/**
 * @param {Catalog | null} catalog
 * @param {EntryId} id
 * @returns {{entry: CatalogEntry, shape: CatalogShape, functional: CatalogFunctional} | null} null if there is none
 */
export function findEntry(catalog, id) {
  const entry = catalog?.entries.find((one) => entryName(one) === id);
  const shape = catalog?.shapes.find(({ name }) => name === entry?.shape);
  const functional = catalog?.functionals.find(({ name }) => name === entry?.functional);
  return entry && shape && functional ? { entry, shape, functional } : null;
}
