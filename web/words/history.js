// SPDX-License-Identifier: MIT
/**
 * @file What a step of the studio's history is called: the words after "Undo" and "Redo".
 */
import { cageWords } from './cages.js';
import { functionalWords } from './functionals.js';

/** @import {Action} from '../pages/studio/state/types.js' */

/** @type {Record<string, string>} */
const settingWords = {
  weights: 'change a weight',
  cap: 'choose the cap',
  symmetry: 'switch symmetry',
  levels: 'choose the levels',
  accuracy: 'choose the levels',
  tolerance: 'change the tolerance',
  max_iterations: 'change the iterations',
  origin: 'choose the start',
};

const editWords = {
  all: 'hold all faces',
  invert: 'invert what is held',
  grow: 'grow what is held',
  clear: 'free all faces',
};

const cageEditWords = {
  move: 'move a part of the cage',
  extrude: 'extrude faces',
  remove: 'delete faces',
  bridge: 'bridge',
  split: 'split a strip',
  mirror: 'mirror the cage',
};

/** @param {Extract<Action, {type: 'settingsChanged'}>['change']} change */
function settingName(change) {
  const { functional } = change;
  if (functional) return `minimize ${functional === 'blend' ? 'a blend' : functionalWords(functional).name}`;
  const [name] = Object.keys(change);
  return settingWords[name] ?? 'change a setting';
}

/** @param {Extract<Action, {type: 'generatorChanged'}>['change']} change */
function generatorName({ name, family }) {
  if (name) return `open ${cageWords(name).title}`;
  return family ? 'choose the family' : 'change the thickness';
}

/** @param {Action} action @returns {string | null} null if it changes nothing that can be undone */
export function stepName(action) {
  switch (action.type) {
    case 'generatorChanged':
      return generatorName(action.change);
    case 'fileChosen':
      return `open ${action.name}`;
    case 'settingsChanged':
      return settingName(action.change);
    case 'weightsChanged':
      if (action.corners) return 'choose a corner';
      return Object.keys(action.weights).length > 1 ? 'move the point of the blend' : settingWords.weights;
    case 'facesPainted':
      return action.held ? 'hold faces' : 'free faces';
    case 'groupHeld':
      return `${action.held ? 'hold' : 'free'} ${action.name}`;
    case 'holdEdited':
      return editWords[action.how];
    case 'vertexPinned':
      return `pin vertex ${action.vertex}`;
    case 'pinRemoved':
      return 'remove a pin';
    case 'copiesSwitched':
      return action.on ? 'copy over the symmetry' : 'copy nothing';
    case 'pinMoved':
      return 'move a pin';
    case 'pinTurned':
      if (typeof action.normal !== 'boolean') return 'turn a normal';
      return action.normal ? 'hold a normal' : 'free a normal';
    case 'conditionChosen':
      return 'change a boundary';
    case 'fillPressed':
      return action.filled ? 'fill a boundary' : 'open a boundary';
    case 'closenessChanged':
      return 'change the closeness';
    case 'cageEdited':
      return cageEditWords[action.edit.kind];
    case 'startPressed':
    case 'stepPressed':
      return 'minimize';
    case 'finerPressed':
      return 'go one level finer';
    case 'goOnPressed':
      return 'go on';
    case 'againPressed':
      return 'minimize again';
    case 'resetPressed':
      return 'reset';
    case 'entryLoaded':
      return 'open the catalog’s minimizer';
    case 'answered':
      return action.message.type === 'descended' ? 'descend' : null;
    default:
      return null;
  }
}
