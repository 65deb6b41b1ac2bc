// SPDX-License-Identifier: MIT
/**
 * @file Runs the program `umbilic` of the native build for tests, in a folder of their own.
 */
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
/** Of the native build, unless `npm run coverage` names another. */
export const program = process.env.UMBILIC_PROGRAM ?? path.join(root, 'build/native/umbilic');

/** @typedef {{ code: number | null, out: string, err: string }} Ended */

/**
 * Runs the program to its end.
 * @param {string[]} args
 * @param {{ input?: string, folder?: string, environment?: NodeJS.ProcessEnv }} [options] `input` is its standard input
 * @returns {Ended}
 */
export function umbilic(args, { input = '', folder, environment } = {}) {
  const result = spawnSync(program, args, {
    input,
    cwd: folder,
    encoding: 'utf8',
    env: { ...process.env, ...environment },
    maxBuffer: 1 << 28,
  });
  // A program that refuses its arguments need not have read its input.
  if (result.error && !/EPIPE/.test(result.error.message)) throw result.error;
  return { code: result.status, out: result.stdout, err: result.stderr };
}

/** @param {string[]} args @param {{ input?: string, folder?: string }} [options] @returns {string} standard output of a run that succeeds */
export function outputOf(args, options) {
  const { code, out, err } = umbilic(args, options);
  if (code !== 0) throw new Error(`umbilic ${args.join(' ')} ended with ${code}: ${err}`);
  return out;
}

/** @param {string[]} args @param {{ input?: string, folder?: string }} [options] @returns {any} */
export const jsonOf = (args, options) => JSON.parse(outputOf(args, options));

/** @param {string} command for the shell, where $UMBILIC is the program @param {string} folder @returns {Ended} */
export function shell(command, folder) {
  const { status, stdout, stderr } = spawnSync('sh', ['-c', command], {
    cwd: folder,
    encoding: 'utf8',
    env: { ...process.env, UMBILIC: program },
  });
  return { code: status, out: stdout, err: stderr };
}

/**
 * Starts the program and leaves it running.
 * @param {string[]} args
 * @param {string} folder
 */
export function start(args, folder) {
  const child = spawn(program, args, { cwd: folder });
  const ended = new Promise((resolve) => {
    child.on('close', (code, signal) => resolve({ code, signal }));
  });
  let err = '';
  child.stderr.on('data', (chunk) => (err += chunk));
  return {
    child,
    /** @type {Promise<{ code: number | null, signal: string | null }>} */
    ended,
    /** @param {RegExp} pattern @returns {Promise<void>} resolves when standard error has matched, rejects when the program ends first */
    says: (pattern) =>
      new Promise((resolve, reject) => {
        const look = () => pattern.test(err) && resolve();
        child.stderr.on('data', look);
        child.on('close', () => reject(new Error(`ended without ${pattern}: ${err}`)));
        look();
      }),
  };
}

/** A folder of its own for a test file; `dispose` removes it. */
export function scratchFolder() {
  const folder = mkdtempSync(path.join(tmpdir(), 'umbilic-'));
  return {
    folder,
    /** @param {string} name */
    path: (name) => path.join(folder, name),
    /** @param {string} name @param {string | Uint8Array} text @returns {string} the file's path */
    write(name, text) {
      const file = path.join(folder, name);
      writeFileSync(file, text);
      return file;
    },
    /** @param {string} name */
    read: (name) => readFileSync(path.join(folder, name), 'utf8'),
    dispose: () => rmSync(folder, { recursive: true, force: true }),
  };
}

/** Three of a tetrahedron's four faces. */
export const openTetrahedron = 'v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\n';

export const tetrahedron = `${openTetrahedron}f 2 4 3\n`;

/** The functionals, in the order in which tables and reports have them. */
export const functionals = [
  'bending',
  'willmore',
  'mvs',
  'mvs_cross',
  'mehlum_tarrou',
  'second_form_variation',
  'mean_curvature_variation',
  'curvedness_variation',
];
