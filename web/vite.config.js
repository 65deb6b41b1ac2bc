// SPDX-License-Identifier: MIT
/**
 * @file How the pages are built. Every HTML file of this folder becomes a page of build/web, which works under any path
 * of a static host. All pages begin with the same head and header, and some have parts in files of their own. The catalog's
 * data keep their names.
 */
import { cpSync, existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { noticesFile, packageNotices } from '../tests/run/licences.js';
import { headers, policy } from './headers.js';
import { tablesHtml } from './pages/methods/tables.js';

const web = path.dirname(fileURLToPath(import.meta.url));
const outDir = path.join(web, '../build/web');
const serviceWorker = 'service_worker.js';
const pages = readdirSync(web).filter((name) => name.endsWith('.html'));

/** A file of pages/ that pages contain, without its comments. @param {string} name */
const shared = (name) => readFileSync(path.join(web, 'pages', name), 'utf8').replace(/<!--.*?-->\s*/gs, '');

/** Puts the policy before all that it is about. The development server needs scripts in the HTML. @returns {import('vite').Plugin} */
function securityPolicy() {
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy}" />`;
  return {
    name: 'security-policy',
    apply: 'build',
    transformIndexHtml: { order: 'pre', handler: (html) => html.replace('<head>', `<head>\n${meta}`) },
  };
}

/** Inserts what all pages begin with: the head, and the header with the current page marked. @returns {import('vite').Plugin} */
function beginnings() {
  return {
    name: 'beginnings',
    transformIndexHtml: {
      order: 'pre',
      handler(html, { filename }) {
        const text = shared('header.html');
        const nav = text.indexOf('<nav');
        const own = `href="./${path.basename(filename)}"`;
        const main = /<main\b[^>]*\bid="([^"]+)"/.exec(html)?.[1];
        if (!main) throw new Error(`${filename}: the main element has no id, so that no link leads to it`);
        const start = text.slice(0, nav).replace('href="#main"', `href="#${main}"`);
        const marked = start + text.slice(nav).replace(own, `${own} aria-current="page"`);
        return html
          .replace('<head>', `<head>\n${shared('head.html')}`)
          .replace('<header class="top"></header>', `<header class="top">${marked}</header>`);
      },
    },
  };
}

/** Inserts the parts of a page that are files of pages/, and the catalog's tables. @returns {import('vite').Plugin} */
function parts() {
  const tables = () => tablesHtml(JSON.parse(readFileSync(path.join(web, 'catalog/catalog.json'), 'utf8')));
  return {
    name: 'parts',
    transformIndexHtml: {
      order: 'pre',
      handler: (html) =>
        html.replace(/<!-- part: (\S+) -->/g, (_, name) => shared(name)).replace('<!-- tables -->', tables),
    },
  };
}

/** Preloads the studio's drawing code with everything else, although it runs only after the worker has started. @returns {import('vite').Plugin} */
function preloads() {
  const drawing = 'views/surface.js';
  return {
    name: 'preloads',
    transformIndexHtml: {
      order: 'post',
      handler(html, { bundle = {}, chunk }) {
        const chunks = Object.values(bundle).filter((output) => output.type === 'chunk');
        const later = chunks.find(({ facadeModuleId }) => facadeModuleId?.endsWith(drawing));
        if (!later || !chunk?.dynamicImports.includes(later.fileName)) return html;
        const names = new Set([later.fileName]);
        for (const name of names) {
          for (const { fileName, imports } of chunks) if (fileName === name) imports.forEach((one) => names.add(one));
        }
        return [...names]
          .filter((name) => !html.includes(name))
          .map((name) => ({
            tag: 'link',
            attrs: { rel: 'modulepreload', crossorigin: true, href: `./${name}` },
            injectTo: /** @type {const} */ ('head'),
          }));
      },
    },
  };
}

/** Copies the catalog's data, which pages fetch and readers may link to. @returns {import('vite').Plugin} */
function catalog() {
  return {
    name: 'catalog',
    apply: 'build',
    writeBundle() {
      const folder = path.join(web, 'catalog');
      const filter = (/** @type {string} */ name) => !name.endsWith('.md');
      if (existsSync(folder)) cpSync(folder, path.join(outDir, 'catalog'), { recursive: true, filter });
    },
  };
}

/** The modules of all bundles: workers have bundles of their own, which are ready before the page's. @type {Set<string>} */
const bundled = new Set();

/** Notes what a bundle contains. @returns {import('vite').Plugin} */
function contents() {
  return {
    name: 'contents',
    apply: 'build',
    generateBundle(_, bundle) {
      for (const output of Object.values(bundle)) {
        if (output.type === 'chunk') output.moduleIds.forEach((id) => bundled.add(id));
      }
    },
  };
}

/** Writes the notices of all that the page contains. @returns {import('vite').Plugin} */
function licences() {
  return {
    name: 'licences',
    apply: 'build',
    writeBundle() {
      const text = `${readFileSync(noticesFile, 'utf8')}\n${packageNotices(bundled)}`;
      writeFileSync(path.join(outDir, 'licences.txt'), text);
    },
  };
}

export default defineConfig({
  root: web,
  base: './',
  plugins: [beginnings(), parts(), securityPolicy(), preloads(), catalog(), contents(), licences()],
  build: {
    outDir,
    emptyOutDir: true,
    chunkSizeWarningLimit: 1500, // kB; three.js is one chunk
    rolldownOptions: {
      input: [...pages, serviceWorker].map((name) => path.join(web, name)),
      // Puts the code that pages share into one file, because each additional file takes time to load.
      output: {
        // A service worker keeps its address, and is about what lies below it.
        entryFileNames: ({ facadeModuleId }) =>
          facadeModuleId?.endsWith(serviceWorker) ? serviceWorker : 'assets/[name]-[hash].js',
        codeSplitting: {
          groups: [{ name: 'common', test: /web.(address|colour|files|plot|views|words)./, minShareCount: 2 }],
        },
      },
    },
  },
  worker: { format: 'es', plugins: () => [contents()] },
  preview: { headers },
  server: { fs: { allow: [path.join(web, '..')] } }, // the module of build/wasm
});
