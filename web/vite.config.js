// SPDX-License-Identifier: MIT
/**
 * @file How the page is built: every HTML file of this folder becomes a page of build/web, which works from any sub-path of any static host.
 */
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const web = path.dirname(fileURLToPath(import.meta.url));
const pages = readdirSync(web).filter((name) => name.endsWith('.html'));

export default defineConfig({
  root: web,
  base: './',
  build: {
    outDir: path.join(web, '../build/web'),
    emptyOutDir: true,
    chunkSizeWarningLimit: 1500, // kB; three.js is one chunk
    rolldownOptions: { input: pages.map((name) => path.join(web, name)) },
  },
  worker: { format: 'es' },
  server: { fs: { allow: [path.join(web, '..')] } }, // the module of build/wasm
});
