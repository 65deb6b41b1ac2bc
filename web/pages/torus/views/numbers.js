// SPDX-License-Identifier: MIT
/**
 * @file The numbers of the torus that minimizes the blend: its ratio, its energies beside their closed forms, and a
 * link to the studio.
 */
import { formatStudioAddress, parseStudioAddress } from '../../../address/studio.js';
import { element, find, setText, whenChanged } from '../../../views/dom.js';
import { functionals, functionalWords } from '../../../words/functionals.js';
import { invariants } from '../../../words/invariants.js';
import { compact, significant } from '../../../words/numbers.js';
import { CLIFFORD, isThePapers, namedWeights, printed, shareOf, torusInvariants } from '../family.js';

/** @import {TorusMinimizer} from '../../../../wasm/types.js' */
/** @import {Blend, Family, Least, State} from '../types.js' */

/** Digits of ratios and energies: enough to check exact values. */
const DIGITS = 7;

/** @param {Blend} blend "1 · Bending + 0.5 · MVS cross" */
function blendWords({ names, weights }) {
  return names
    .map((name, i) => ({ name: functionalWords(name).short, weight: weights[i] }))
    .filter(({ weight }) => weight > 0)
    .map(({ name, weight }) => (weight === 1 ? name : `${compact(weight, 4)} × ${name}`))
    .join(' + ');
}

/** What is special about the torus, in a sentence. @param {Blend} blend @param {TorusMinimizer} minimizer */
function remark(blend, { ratio, attained }) {
  if (Number.isNaN(ratio)) return 'Every torus has this energy.';
  if (!attained) return 'Thinner and thinner tori come as close to this energy as one likes; none has it.';
  if (Math.abs(ratio - CLIFFORD) < 1e-12) return 'Clifford’s torus, a = 1⁄√2.';
  const same = printed.find(({ weights }) => Math.abs(shareOf(weights) - shareOf(blend.weights)) < 1e-12);
  return same && isThePapers(blend) ? `The paper prints ${same.ratio}.` : '';
}

/** @param {Blend} blend @returns {string} the studio's address for minimizing the blend from a meshed torus */
function studioAddress(blend) {
  const weights = Object.fromEntries(Object.entries(namedWeights(blend)).filter(([, weight]) => weight > 0));
  const names = Object.keys(weights);
  const asked = names.length === 1 ? { functional: names[0] } : { functional: 'blend', weights };
  const { address } = parseStudioAddress('');
  return `./studio.html${formatStudioAddress({ ...address, shape: 'torus', start: 'cage', ...asked })}`;
}

/** @param {HTMLElement} root */
export function createNumbersView(root) {
  const ratio = find(root, '.ratio');
  const words = find(root, '.blend');
  const energy = find(root, '.energy');
  const note = find(root, '.remark');
  const studio = /** @type {HTMLAnchorElement} */ (find(root, 'a'));
  /** @param {string} id @param {'least' | 'here'} column */
  const cell = (id, column) => find(root, `[data-functional=${id}] .${column}`);

  const showLeast = whenChanged((/** @type {Blend} */ blend, /** @type {Least | null} */ least) => {
    studio.href = studioAddress(blend);
    setText(words, blendWords(blend));
    if (!least) return;
    const { minimizer, energies } = least;
    setText(ratio, minimizer.attained && minimizer.ratio > 0 ? significant(minimizer.ratio, DIGITS) : '–');
    setText(energy, `${minimizer.attained ? '' : 'infimum '}${significant(minimizer.energy, DIGITS)}`);
    setText(note, remark(blend, minimizer));
    for (const { id } of functionals) {
      setText(cell(id, 'here'), energies ? significant(energies[id], DIGITS) : '–');
      root.querySelector(`[data-functional=${id}]`)?.classList.toggle('objective', blend.names.includes(id));
    }
    const odd = energies && torusInvariants(minimizer.ratio);
    for (const { id } of invariants) {
      setText(find(root, `[data-invariant=${id}] .here`), odd ? significant(odd[id], DIGITS) : '–');
    }
  });
  const showFamily = whenChanged((/** @type {Family | null} */ family) => {
    if (!family) return;
    for (const { id } of functionals) {
      const { energy: value, ratio: at, attained } = family.alone[id];
      const where = Number.isNaN(at) ? 'everywhere' : attained ? `at ${significant(at, 5)}` : 'as a → 0';
      cell(id, 'least').replaceChildren(significant(value, DIGITS), ' ', element('span', { class: 'note' }, where));
    }
  });

  return {
    /** @param {State} state */
    update({ blend, least, family }) {
      showFamily(family);
      showLeast(blend, least);
    },
    dispose() {},
  };
}
