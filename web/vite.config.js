// SPDX-License-Identifier: MIT
/**
 * @file How the pages are built: every HTML file of this folder becomes a page of build/web, which works from any sub-path of any static
 * host; all of them begin with the same header, and the catalog's data stand beside them under the names that they have here.
 */
import { cpSync, existsSync, readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const web = path.dirname(fileURLToPath(import.meta.url));
const outDir = path.join(web, '../build/web');
const pages = readdirSync(web).filter((name) => name.endsWith('.html'));

/** The common header, in which the page itself is marked. @returns {import('vite').Plugin} */
function header() {
  return {
    name: 'header',
    transformIndexHtml: {
      order: 'pre',
      handler(html, { filename }) {
        const text = readFileSync(path.join(web, 'pages/header.html'), 'utf8').replace(/<!--.*?-->\s*/gs, '');
        const nav = text.indexOf('<nav');
        const own = `href="./${path.basename(filename)}"`;
        const marked = text.slice(0, nav) + text.slice(nav).replace(own, `${own} aria-current="page"`);
        return html.replace('<header class="top"></header>', `<header class="top">${marked}</header>`);
      },
    },
  };
}

/** The catalog's data, which pages fetch and readers may link to. @returns {import('vite').Plugin} */
function catalog() {
  return {
    name: 'catalog',
    apply: 'build',
    writeBundle() {
      const folder = path.join(web, 'catalog');
      if (existsSync(folder)) cpSync(folder, path.join(outDir, 'catalog'), { recursive: true });
    },
  };
}

export default defineConfig({
  root: web,
  base: './',
  plugins: [header(), catalog()],
  build: {
    outDir,
    emptyOutDir: true,
    chunkSizeWarningLimit: 1500, // kB; three.js is one chunk
    rolldownOptions: { input: pages.map((name) => path.join(web, name)) },
  },
  worker: { format: 'es' },
  server: { fs: { allow: [path.join(web, '..')] } }, // the module of build/wasm
});
