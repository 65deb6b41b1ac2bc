// SPDX-License-Identifier: MIT
/**
 * @file `npm start`: installs what is missing, builds the WebAssembly module and the page, and serves it on the port PORT, or 4173 or the
 * next free one.
 */
import { build } from './build.js';
import { installPackages, installTools } from './install.js';

if (!(await installTools('wasm')) || !(await installPackages())) process.exit(1);
if (!(await build('wasm')) || !(await build('web'))) process.exit(1);

const { preview } = await import('vite'); // imported here because it may just have been installed
const port = process.env.PORT ? { port: Number(process.env.PORT), strictPort: true } : {};
const server = await preview({ configFile: 'web/vite.config.js', preview: port });
console.log('The page is served at');
server.printUrls();
