// Joins the page's sources and what they import into one file:  node build.mjs FOLDER
// FOLDER holds node_modules; run.js, sweep.js and notices.txt are written into it.
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = path.resolve(process.argv[2]);
const here = path.dirname(fileURLToPath(import.meta.url));
const fromFolder = createRequire(path.join(folder, 'package.json'));
const esbuild = fromFolder('esbuild');
const bundled = ['uplot'];

await esbuild.build({
  entryPoints: ['run.js', 'sweep.js'].map((name) => path.join(here, 'src', name)),
  outdir: folder,
  nodePaths: [path.join(folder, 'node_modules')],
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['chrome100', 'firefox113', 'safari16.4'],
  charset: 'ascii',
  legalComments: 'none', // the notices stand in the page's head
  logLevel: 'warning',
});

const notices = bundled.map((name) => {
  const root = path.join(folder, 'node_modules', name);
  const { version } = JSON.parse(readFileSync(path.join(root, 'package.json'), 'utf8'));
  return `This page's script holds ${name} ${version}:\n\n${readFileSync(path.join(root, 'LICENSE'), 'utf8').trim()}\n`;
});
writeFileSync(path.join(folder, 'notices.txt'), notices.join('\n'));
