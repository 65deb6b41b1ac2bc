// SPDX-License-Identifier: MIT
/**
 * @file The catalog's tables, from its numbers: the paper's tables beside ours, and whether the paper's claims hold. The
 * catalog's Markdown file and the page of methods show them. Names of shapes and functionals are set in backquotes.
 */
import { compact, integer, upperBound, withError } from './numbers.js';

/** @typedef {{ title: string, head: string[], rows: (string | number)[][] }} Table */
/**
 * @typedef {object} Entry
 * @property {string} shape
 * @property {string} functional
 * @property {string} status
 * @property {number} energy
 * @property {number | null} error
 * @property {number | null} paper
 * @property {number | null} exact
 * @property {string} [exact_source]
 * @property {{name: string}} group
 * @property {Record<string, number>} [energies] of the minimizer on the last level, all functionals
 * @property {{energy: number | null, difference: number | null}} [second_opinion]
 * @property {{level: number, negative: number} | null} certificate
 * @property {{energy: number, group: {name: string}, level: number, certificate: {negative: number} | null}} [below] what
 *   the minimizer descends to
 * @property {{energy: number, error: number | null, agrees: boolean | null} | null} second_family
 */
/** @typedef {{name: string, genus: number, junctions: number, arms: number, sides?: number, cage?: {rise?: number}}} Shape holes have sides */
/** @typedef {{shape: string, functional: string, thickness: number, energy: number, level: number, stop: string}} Start */
/** @typedef {{shapes: Shape[], functionals: {name: string}[], entries: Entry[], starts: Start[]}} Catalog */

/** An energy with its error, to two digits of the error as on the page. @param {number} energy @param {number} bar */
function limitWords(energy, bar) {
  const { value, error } = withError(energy, bar, 2);
  return `${value} ± ${error}`;
}

/** @param {number} energy @param {number | null} bar null if the energy is an upper bound */
const boundWords = (energy, bar) => (bar === null ? `≤ ${upperBound(energy)}` : limitWords(energy, bar));

/** A number with four digits. @param {number} value */
const short = (value) => (value >= 1000 ? integer(value) : compact(value, 4));

/** @param {Entry | undefined} entry */
export function energyWords(entry) {
  if (!entry) return '';
  if (entry.status === 'converged' && entry.error !== null) return limitWords(entry.energy, entry.error);
  if (entry.status === 'zero_attained') return '0';
  if (entry.status === 'infimum_not_attained') return `→ ${short(entry.energy)}`;
  return entry.status === 'none_found' ? 'none' : boundWords(entry.energy, null);
}

/** @param {Catalog} catalog */
function lookup({ entries }) {
  /** @param {string} shape @param {string} functional */
  return (shape, functional) => entries.find((e) => e.shape === shape && e.functional === functional);
}

/** @param {number} share */
const percent = (share) => {
  const size = Math.abs(100 * share);
  return `${share >= 0 ? '+' : '−'}${size.toFixed(size < 0.1 ? 4 : size < 10 ? 1 : 0)} %`;
};

/** Table 1, cell by cell. @param {Catalog} catalog @returns {Table[]} */
function tableOne(catalog) {
  const find = lookup(catalog);
  return ['bending', 'mvs_cross', 'mvs'].map((functional) => ({
    title: `\`${functional}\`, Table 1 of the paper:`,
    head: [
      'genus',
      'shape',
      'group',
      'ours',
      'paper',
      'ours / paper',
      ...(functional === 'bending' ? ['exact'] : ['2 paper / ours']),
    ],
    rows: catalog.shapes.flatMap(({ name, genus }) => {
      const entry = find(name, functional);
      if (!entry?.paper) return [];
      const last =
        functional === 'bending'
          ? (entry.exact?.toFixed(entry.exact > 150 ? 3 : 4) ?? '')
          : ((2 * entry.paper) / entry.energy).toFixed(3);
      return [
        [
          genus,
          name,
          entry.group.name,
          energyWords(entry),
          integer(entry.paper),
          (entry.energy / entry.paper).toFixed(4),
          last,
        ],
      ];
    }),
  }));
}

/** The shapes that are no holes. @param {Catalog} catalog */
const closed = ({ shapes }) => shapes.filter(({ sides }) => !sides);

/** All energies of the catalog's closed surfaces. @param {Catalog} catalog @returns {Table} */
function allEnergies(catalog) {
  const find = lookup(catalog);
  return {
    title:
      'All closed surfaces; ± is the error bar of a limit, ≤ an upper bound that does not converge, → an infimum that is not attained:',
    head: ['genus', 'shape', ...catalog.functionals.map(({ name }) => `\`${name}\``)],
    rows: closed(catalog).map(({ name, genus }) => [
      genus,
      name,
      ...catalog.functionals.map((functional) => energyWords(find(name, functional.name))),
    ]),
  };
}

/** Tables 2 and 3. @param {Catalog} catalog @param {number} arms @returns {Table} */
function perJunction(catalog, arms) {
  const find = lookup(catalog);
  return {
    title: `\`mvs_cross\` per ${arms}-way junction, Table ${arms - 1} of the paper:`,
    head: ['shape', 'junctions', 'ours per junction', 'paper per junction'],
    rows: catalog.shapes.flatMap(({ name, junctions, arms: n }) => {
      const entry = n === arms && find(name, 'mvs_cross');
      if (!entry) return [];
      const ours = boundWords(entry.energy / junctions, entry.error && entry.error / junctions);
      return [[name, junctions, ours, entry.paper ? short(entry.paper / junctions) : '']];
    }),
  };
}

/**
 * For shapes of the same genus: whether more junctions with fewer arms have less energy.
 * @param {Catalog} catalog
 * @returns {Table}
 */
function preferences(catalog) {
  const find = lookup(catalog);
  const of = (/** @type {Shape} */ shape) => find(shape.name, 'mvs_cross');
  const cost = (/** @type {Shape} */ shape) => of(shape)?.energy ?? NaN;
  const bar = (/** @type {Shape} */ shape) => of(shape)?.error ?? 0;
  /** @param {Shape} few @param {Shape} many */
  const preferred = (few, many) => {
    const gain = cost(few) - cost(many);
    if (Math.abs(gain) <= bar(few) + bar(many)) return 'equal within the bars';
    return gain > 0 ? 'yes' : 'no';
  };
  const rows = catalog.shapes.flatMap((few, i) =>
    catalog.shapes
      .slice(i + 1)
      .filter((many) => many.genus === few.genus && many.arms < few.arms && many.junctions > 0)
      .map((many) => [
        few.genus,
        `${few.junctions} × ${few.arms}-way, ${few.name}`,
        short(cost(few)),
        `${many.junctions} × ${many.arms}-way, ${many.name}`,
        short(cost(many)),
        preferred(few, many),
      ]),
  );
  return {
    title: 'Whether `mvs_cross` prefers more junctions of fewer arms at the same genus:',
    head: ['genus', 'few', 'energy', 'many', 'energy', 'prefers many'],
    rows,
  };
}

/** Energies from the other family of cages. @param {Catalog} catalog @returns {Table} */
function families(catalog) {
  return {
    title: 'The same shape from two families of cages:',
    head: ['shape', 'functional', 'flag cage', 'hub cage', 'difference', 'bars overlap'],
    rows: catalog.entries.flatMap((entry) => {
      const other = entry.second_family;
      if (!other) return [];
      const words = boundWords(other.energy, other.error);
      const agrees = other.agrees === null ? '' : other.agrees ? 'yes' : 'no';
      return [
        [entry.shape, entry.functional, energyWords(entry), words, percent(other.energy / entry.energy - 1), agrees],
      ];
    }),
  };
}

/** Energies from cages of different thickness, the paper's figure 3. @param {Catalog} catalog @returns {Table} */
function starts(catalog) {
  const keys = [...new Set(catalog.starts.map((s) => `${s.shape} ${s.functional} ${s.level}`))];
  return {
    title: "Thin and fat starts (the paper's figure 3), energies at the end of the level:",
    head: ['shape', 'functional', 'level', 'from thickness 0.5', '1', '1.5', 'spread'],
    rows: keys.map((key) => {
      const same = catalog.starts.filter((s) => `${s.shape} ${s.functional} ${s.level}` === key);
      const energies = same.map((s) => s.energy);
      const spread = Math.max(...energies) / Math.min(...energies) - 1;
      return [...key.split(' '), ...energies.map((e) => e.toPrecision(8)), spread.toExponential(1)];
    }),
  };
}

/** @param {Catalog} catalog @returns {Table} */
function certificates(catalog) {
  const find = lookup(catalog);
  return {
    title:
      'Directions that lower the energy of the minimizer once it may leave its symmetry (and the level they were counted at):',
    head: ['shape', ...catalog.functionals.map(({ name }) => `\`${name}\``)],
    rows: closed(catalog).map(({ name }) => [
      name,
      ...catalog.functionals.map((functional) => {
        const certificate = find(name, functional.name)?.certificate;
        return certificate ? `${certificate.negative} (${certificate.level})` : '';
      }),
    ]),
  };
}

/** The open surfaces. @param {Catalog} catalog @returns {Table[]} */
function holes(catalog) {
  const find = lookup(catalog);
  const rows = catalog.shapes.flatMap(({ name, sides, cage }) => {
    const entry = sides && find(name, 'mvs_cross');
    if (!entry) return [];
    const { group, certificate } = entry;
    const directions = certificate ? `${certificate.negative} (${certificate.level})` : '';
    return [[sides, name, cage?.rise ?? '', group.name, energyWords(entry), directions]];
  });
  if (!rows.length) return [];
  return [
    {
      title:
        "Holes, N-sided surfaces whose boundary holds position, tangent and curvature of their cage, a saddle over the regular polygon; the factor A is the constant area of the cage's own surface:",
      head: ['sides', 'shape', 'rise', 'group', '`mvs_cross`', 'directions that lower it (level)'],
      rows,
    },
  ];
}

/** What the minimizers descend to, beside the surface of the same genus with two junctions. @param {Catalog} catalog @returns {Table[]} */
function descents(catalog) {
  const find = lookup(catalog);
  const rows = catalog.entries.flatMap((entry) => {
    const { shape, functional, group, below } = entry;
    if (!below) return [];
    const { genus } = /** @type {Shape} */ (catalog.shapes.find(({ name }) => name === shape));
    const twin = find(`two-${genus + 1}`, functional);
    return [
      [
        ...[genus, shape, functional],
        `${energyWords(entry)}, ${group.name}`,
        `${below.energy.toPrecision(8)} (level ${below.level}), ${below.group.name}`,
        below.certificate ? below.certificate.negative : '',
        twin ? `${energyWords(twin)}, ${twin.shape}` : '',
      ],
    ];
  });
  if (!rows.length) return [];
  const head = ['genus', 'shape', 'functional', 'minimizer', 'what it descends to', 'directions that lower that'];
  return [
    {
      title:
        'Minimizers of second order from which such directions lead down, and where the descent ends, beside the minimizer of this genus with two junctions:',
      head: [...head, 'two junctions'],
      rows,
    },
  ];
}

/** @param {number[]} values @param {(value: number) => string} [words] */
const range = (values, words = short) => `${words(Math.min(...values))} to ${words(Math.max(...values))}`;

/** @param {number[]} values */
const spread = (values) => (Math.max(...values) / Math.min(...values)).toFixed(2);

/**
 * The claims of the paper's section 4.3: the cost per junction, and which junctions are cheaper.
 * @param {Catalog} catalog
 * @returns {string[]} sentences
 */
function claims(catalog) {
  const find = lookup(catalog);
  /** @param {...string} names */
  const costs = (...names) =>
    catalog.shapes
      .filter(({ name }) => names.includes(name) && find(name, 'mvs_cross'))
      .map(({ name, junctions }) => (find(name, 'mvs_cross')?.energy ?? NaN) / junctions);
  const symmetric = costs('two-3', 'tetrahedron-frame', 'cube-frame');
  const others = costs('hexagonal-prism-frame', 'truncated-tetrahedron-frame');
  const dodecahedron = costs('dodecahedron-frame');
  if (!symmetric.length || !others.length || !dodecahedron.length) return [];
  const cheaper = Math.max(...symmetric) < Math.min(...others);
  const dearer = dodecahedron[0] > Math.max(...symmetric);
  return [
    `With the number of 3-way junctions the energy grows proportionally within a factor of ${spread(symmetric)} for two junctions, tetrahedron and cube, and of ${spread([...symmetric, ...others, ...dodecahedron])} over all frames.`,
    `The paper's claim that symmetric junctions are cheaper ${cheaper ? 'holds' : 'does not hold'} for its shapes: ${range(symmetric)} against ${range(others)} for the hexagonal prism and the truncated tetrahedron. It ${dearer ? 'does not extend' : 'extends'} to the dodecahedron, whose junctions are as symmetric and cost ${short(dodecahedron[0])}.`,
  ];
}

/**
 * Whether the paper's columns could be half of our integrals: then, doubled, they would be upper bounds.
 * @param {Catalog} catalog
 * @returns {string[]} sentences
 */
function halved(catalog) {
  const find = lookup(catalog);
  /** @param {string} functional @param {(shape: Shape) => boolean} wanted */
  const doubled = (functional, wanted) =>
    catalog.shapes.filter(wanted).flatMap(({ name }) => {
      const entry = find(name, functional);
      return entry?.paper ? [(2 * entry.paper) / entry.energy] : [];
    });
  const polyhedra = doubled('mvs_cross', ({ junctions }) => junctions > 2);
  const pairs = doubled('mvs_cross', ({ junctions }) => junctions === 2);
  const mvs = doubled('mvs', ({ junctions }) => junctions > 0);
  if (!polyhedra.length || !pairs.length || !mvs.length) return [];
  const digits = (/** @type {number} */ ratio) => ratio.toFixed(3);
  const list = pairs.map(digits).join(', ');
  return [
    `Twice the paper's \`mvs_cross\` is ${range(polyhedra, digits)} times ours for polyhedral frames, and ${list} times for two junctions with more and more arms; twice its \`mvs\` is ${range(mvs, digits)} times ours.`,
  ];
}

/**
 * Our minimizers by other sums of the same four squares beside the paper's columns: halves, and the squares of the two
 * cross derivatives alone, which `mvs_cross` has and `mvs` has not. Each with its ratio to the paper's number.
 * @param {Catalog} catalog
 * @returns {Table[]}
 */
function otherSums(catalog) {
  const find = lookup(catalog);
  return ['mvs_cross', 'mvs'].flatMap((functional) => {
    const rows = catalog.shapes.flatMap(({ name, genus }) => {
      const { energies, paper } = find(name, functional) ?? {};
      if (!energies || !paper) return [];
      const { mvs, mvs_cross: all } = energies;
      const sums = [all, all / 2, all - mvs, (all - mvs) / 2, mvs, mvs / 2];
      return [[genus, name, integer(paper), ...sums.map((sum) => `${short(sum)} (${(sum / paper).toFixed(3)})`)]];
    });
    if (!rows.length) return [];
    return [
      {
        title: `Our \`${functional}\` minimizers on their last level by other sums, in brackets divided by the paper's \`${functional}\`; cross terms are \`mvs_cross\` − \`mvs\`:`,
        head: ['genus', 'shape', 'paper', '`mvs_cross`', 'half', 'cross terms', 'half', '`mvs`', 'half'],
        rows,
      },
    ];
  });
}

/**
 * By how much the energies differ from those that were computed another way.
 * @param {Catalog} catalog
 * @returns {string[]} sentences
 */
function opinions({ entries }) {
  const differences = entries
    .filter(({ status }) => status !== 'zero_attained')
    .flatMap(({ shape, functional, second_opinion: opinion }) =>
      opinion && opinion.difference !== null ? [{ shape, functional, size: Math.abs(opinion.difference) }] : [],
    )
    .sort((a, b) => b.size - a.size);
  if (!differences.length) return [];
  const [largest] = differences;
  const median = differences[Math.floor(differences.length / 2)].size;
  const words = (/** @type {number} */ size) => size.toExponential(1);
  return [
    `Computed another way, the minimized energies of these ${differences.length} surfaces differ by ${words(largest.size)} of themselves at most (\`${largest.shape}\`, \`${largest.functional}\`), half of them by no more than ${words(median)}.`,
  ];
}

/** All tables and sentences, in their order. @param {Catalog} catalog @returns {Array<Table | string>} */
export function catalogTables(catalog) {
  return [
    ...tableOne(catalog),
    ...halved(catalog),
    ...otherSums(catalog),
    ...[perJunction(catalog, 3), perJunction(catalog, 4)],
    ...claims(catalog),
    ...[preferences, families, starts, allEnergies, certificates].map((table) => table(catalog)),
    ...descents(catalog),
    ...holes(catalog),
    ...opinions(catalog),
  ];
}
