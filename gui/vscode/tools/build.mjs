// Bundles the extension into out/extension.js; with --tests its tests into out/test; with --release small, with the
// licences beside it.
import { copyFileSync, existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const release = process.argv.includes('--release');
const tests = process.argv.includes('--tests');

rmSync('out', { recursive: true, force: true });
const { metafile } = await build({
  entryPoints: tests
    ? readdirSync('test').map((file) => `test/${file}`)
    : { extension: 'src/extension.ts' },
  outdir: tests ? 'out/test' : 'out',
  bundle: true,
  platform: 'node',
  format: 'cjs',
  target: 'node20',
  external: ['vscode'],
  sourcemap: release ? false : 'inline',
  minify: release,
  metafile: true,
  logLevel: 'warning',
});
if (release) {
  copyFileSync('../../LICENSE', 'LICENSE');
  writeFileSync('out/licences-of-libraries.txt', licences(Object.keys(metafile.inputs)));
}

/** The licences of the libraries that files of the bundle come from. */
function licences(files) {
  const libraries = new Set(
    files.flatMap((file) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(file)?.[0] ?? []),
  );
  return [...libraries]
    .sort()
    .map((folder) => {
      const { name, version, license } = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
      const text = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
      if (text === undefined || !existsSync(`${folder}/${text}`)) {
        throw new Error(`${name} has no text of its licence`);
      }
      return `${name} ${version} (${license})\n\n${readFileSync(`${folder}/${text}`, 'utf8').trim()}\n`;
    })
    .join(`\n${'-'.repeat(80)}\n\n`);
}
