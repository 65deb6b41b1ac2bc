// SPDX-License-Identifier: MIT
/**
 * @file The system's Chromium for the browser tests, with its own network traffic disabled and WebGL in software.
 */
import { chromium } from 'playwright-core';

/** Path of the system's Chromium, unless the environment variable CHROMIUM gives another. */
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
