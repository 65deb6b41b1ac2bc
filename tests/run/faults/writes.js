// SPDX-License-Identifier: MIT
/**
 * @file Calls to the system that fail while `umbilic optimize` writes its three results, or the end of the program there
 * (tests/faults/shim.cpp). Afterwards each file is the old one or the whole new one, and a write without faults works.
 */
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { root } from '../process.js';
import { count } from './row.js';

/** @typedef {import('./row.js').Row} Row */

const program = path.join(root, 'build/native/umbilic');
const shim = path.join(root, 'build/native/tests/umbilic_fault_shim.so');
const results = ['r.json', 'c.obj', 'l.obj'];
const command =
  'optimize cube.obj --functional bending --levels 1 --max-iterations 3 -q --density 16 --report r.json -o c.obj --limit-mesh l.obj';
const OLD = 'what was there before\n';

/** @param {string} text @returns {string} without what differs from run to run */
const timeless = (text) => text.replace(/"seconds": [^,}\s]+/g, '"seconds"');

class Folder {
  #folder = mkdtempSync(path.join(tmpdir(), 'umbilic-faults-'));
  /** The whole new files. @type {string[]} */
  #whole;

  constructor() {
    this.#umbilic('cage cube -o cube.obj');
    const { status, stderr } = this.#umbilic(command);
    if (status !== 0) throw new Error(`without faults: ${status}, ${stderr}`);
    this.#whole = this.#contents();
  }

  /** Bytes of all results together. */
  get bytes() {
    return results.reduce((sum, name) => sum + statSync(path.join(this.#folder, name)).size, 0);
  }

  /**
   * Writes over old files.
   * @param {string} fault for the shim
   * @returns {{ status: number | null, killed: boolean, states: string[], left: string[] }} `states` of the files are
   * old, new or part
   */
  write(fault) {
    this.#clear();
    for (const name of results) writeFileSync(path.join(this.#folder, name), OLD);
    const { status, signal } = this.#umbilic(command, { LD_PRELOAD: shim, UMBILIC_FAULT: fault });
    const states = this.#contents().map((text, i) => (text === OLD ? 'old' : text === this.#whole[i] ? 'new' : 'part'));
    const left = readdirSync(this.#folder).filter((name) => ![...results, 'cube.obj'].includes(name));
    return { status, killed: signal === 'SIGKILL', states, left };
  }

  /** Whether the same folder can be written afterwards, whatever was left in it. */
  works() {
    return this.#umbilic(command).status === 0 && this.#contents().every((text, i) => text === this.#whole[i]);
  }

  dispose() {
    rmSync(this.#folder, { recursive: true, force: true });
  }

  #clear() {
    rmSync(this.#folder, { recursive: true, force: true });
    mkdirSync(this.#folder);
    this.#umbilic('cage cube -o cube.obj');
  }
  #contents() {
    return results.map((name) => timeless(readFileSync(path.join(this.#folder, name), 'utf8')));
  }
  /** @param {string} line @param {NodeJS.ProcessEnv} environment */
  #umbilic(line, environment = {}) {
    const env = { ...process.env, ...environment };
    return spawnSync(program, line.split(' '), { cwd: this.#folder, encoding: 'utf8', env, timeout: 60_000 });
  }
}

/**
 * Judges one fault and counts its outcome.
 * @param {Row} row
 * @param {Folder} folder
 * @param {string} fault
 */
function judge(row, folder, fault) {
  const { status, killed, states, left } = folder.write(fault);
  const kept = states.filter((state) => state === 'old').length;
  const kills = fault.endsWith('kill');
  const wrong = [];
  if (states.includes('part')) wrong.push(`a part of a file (${states})`);
  if (killed !== kills) wrong.push(kills ? 'not reached' : 'ended by a signal');
  if (!kills && status !== 4) wrong.push(`exit code ${status}`);
  if (!kills && kept === 0) wrong.push('a failure without a file that stayed as it was');
  if (!kills && left.length) wrong.push(`${left} left behind`);
  if (left.some((name) => !name.startsWith('.umbilic-'))) wrong.push(`${left} left behind`);
  if (!folder.works()) wrong.push('cannot be written afterwards');
  const files = `${kept} of 3 files as before, the others new`;
  count(
    row,
    kills ? `killed with ${files}` : `exit code ${status} with ${files}`,
    wrong.map((what) => `${what} at "${fault}"`).join('; '),
  );
}

/**
 * @param {number} positions among the bytes that are written
 * @returns {Row[]}
 */
export function failWrites(positions) {
  const folder = new Folder();
  try {
    const { bytes } = folder;
    /** @type {Row[]} */
    const rows = [];
    for (const action of ['fail', 'kill']) {
      /** @type {Row} */
      const row = { fault: `write, ${action} after some of ${bytes} bytes`, positions: 0, outcomes: {}, wrong: [] };
      for (let i = 0; i < positions; ++i) {
        judge(row, folder, `write ${Math.floor((bytes * i) / positions)} ${action}`);
      }
      rows.push(row);
      // Each result once; a draft is made before the run, before a result, and for it.
      for (const [call, times] of /** @type {const} */ ([
        ['openat', 9],
        ['fchmod', 9],
        ['fsync', 3],
        ['close', 3],
        ['renameat', 3],
      ])) {
        /** @type {Row} */
        const calls = { fault: `${call}, ${action}`, positions: 0, outcomes: {}, wrong: [] };
        for (let position = 1; position <= times; ++position) judge(calls, folder, `${call} ${position} ${action}`);
        rows.push(calls);
      }
    }
    return rows;
  } finally {
    folder.dispose();
  }
}
