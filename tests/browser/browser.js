// SPDX-License-Identifier: MIT
/**
 * @file The system's Chromium for the browser tests, with its own network traffic disabled and WebGL in software. It is
 * the one without windows: the usual one draws its own windows unseen, which takes longer than most tests.
 */
import { chromium } from 'playwright-core';

/** Path of the system's headless Chromium, unless the environment variable CHROMIUM gives another. */
const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium-headless-shell';

/** @param {string[]} [more] arguments for it */
export function launchBrowser(more = []) {
  return chromium.launch({
    executablePath,
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--enable-unsafe-swiftshader',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      ...more,
    ],
  });
}
