// SPDX-License-Identifier: MIT
/**
 * @file Chromium for the browser tests: the system's own, without network traffic of its own, with WebGL in software.
 */
import { chromium } from 'playwright-core';

/** Where the system's Chromium is, unless the environment says so. */
const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';

export function launchBrowser() {
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
    ],
  });
}
