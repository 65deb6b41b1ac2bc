// SPDX-License-Identifier: MIT
/**
 * @file Runs other programs from the repository's root for the npm commands, showing or capturing their output.
 */
import { spawn, spawnSync } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** The repository's root. */
export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');

/**
 * @typedef {object} RunOptions
 * @property {NodeJS.ProcessEnv} [environment] added to the environment of this process
 * @property {number} [minutes] time limit after which the program is stopped
 */

/**
 * Runs a program and shows its output.
 * @param {string} program
 * @param {string[]} args
 * @param {RunOptions} [options]
 * @returns {Promise<number>} its exit code; 127 if it cannot be started, 128 if a signal or the time limit stopped it
 */
export async function run(program, args, options = {}) {
  return (await start(program, args, 'inherit', options)).code;
}

/**
 * Runs a program and collects its output.
 * @param {string} program
 * @param {string[]} args
 * @param {RunOptions} [options]
 * @returns {Promise<{code: number, text: string}>} `code` as from `run`; `text` has standard output and standard error
 */
export function capture(program, args, options = {}) {
  return start(program, args, 'pipe', options);
}

/**
 * The standard output of a program; undefined if it fails or does not exist.
 * @param {string} program
 * @param {string[]} args
 * @returns {string | undefined}
 */
export function output(program, args) {
  const result = spawnSync(program, args, { cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
  return result.status === 0 ? result.stdout : undefined;
}

/**
 * @param {string} program
 * @param {string[]} args
 * @param {'inherit' | 'pipe'} stdio
 * @param {RunOptions} options
 * @returns {Promise<{code: number, text: string}>}
 */
function start(program, args, stdio, { environment = {}, minutes }) {
  return new Promise((resolve) => {
    const child = spawn(program, args, {
      cwd: root,
      stdio: ['inherit', stdio, stdio],
      env: { ...process.env, ...environment },
      timeout: minutes === undefined ? undefined : minutes * 60_000,
      killSignal: 'SIGKILL',
    });
    let text = '';
    child.stdout?.setEncoding('utf8').on('data', (part) => (text += part));
    child.stderr?.setEncoding('utf8').on('data', (part) => (text += part));
    child.on('error', (error) => {
      console.error(`${program}: ${error.message}`);
      resolve({ code: 127, text });
    });
    child.on('close', (code, signal) => {
      if (signal) console.error(`${program}: ended by ${signal}`);
      resolve({ code: code ?? 128, text });
    });
  });
}
