// SPDX-License-Identifier: MIT
/**
 * @file Runs other programs from the repository's root for the npm commands, with their output shown or captured.
 */
import { spawn, spawnSync } from 'node:child_process';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** The repository's root. */
export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');

/**
 * @typedef {object} RunOptions
 * @property {NodeJS.ProcessEnv} [environment] added to this process's
 * @property {number} [minutes] the program is ended after so many
 */

/**
 * Runs a program with its output shown.
 * @param {string} program
 * @param {string[]} args
 * @param {RunOptions} [options]
 * @returns {Promise<number>} its exit code; 127 when it cannot be started, 128 when a signal or the time limit ended it
 */
export async function run(program, args, options = {}) {
  return (await start(program, args, 'inherit', options)).code;
}

/**
 * Runs a program and collects all that it prints.
 * @param {string} program
 * @param {string[]} args
 * @param {RunOptions} [options]
 * @returns {Promise<{code: number, text: string}>} as `run`, and standard output and error together
 */
export function capture(program, args, options = {}) {
  return start(program, args, 'pipe', options);
}

/**
 * What a program prints on standard output, or undefined when it fails or is absent.
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
