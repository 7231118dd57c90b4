// Bundles the extension into out/extension.js and its page into out/page.js; with --tests its tests into out/test; with --release small, with the
// licences beside it.
import { copyFileSync, existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const release = process.argv.includes('--release');
const tests = process.argv.includes('--tests');

// The arms of models, for the picture in 3D: kinematics and outside, not drives and masses.
const arms = {
  name: 'arms',
  setup(plugins) {
    plugins.onResolve({ filter: /^pendant:arms$/ }, ({ path }) => ({ path, namespace: 'pendant' }));
    plugins.onLoad({ filter: /.*/, namespace: 'pendant' }, () => ({
      contents: `export const arms = ${JSON.stringify(readArms())};`,
    }));
  },
};

function readArms() {
  const folder = '../../models/src/main/resources/org/pendant/models/arm';
  const read = (file) => JSON.parse(readFileSync(`${folder}/${file}`, 'utf8'));
  const files = readdirSync(folder).filter((file) => file.endsWith('.json'));
  return Object.fromEntries(
    files.map((file) => {
      const { id, displayName: name, reachM, dh } = read(file);
      return [id, { name, reachM, dh, shape: read(`shape/${file}`) }];
    }),
  );
}

const common = {
  bundle: true,
  sourcemap: release ? false : 'inline',
  minify: release,
  metafile: true,
  logLevel: 'warning',
  plugins: [arms],
};
const node = { ...common, platform: 'node', format: 'cjs', target: 'node20', external: ['vscode'] };

rmSync('out', { recursive: true, force: true });
if (tests) {
  const entryPoints = readdirSync('test').map((file) => `test/${file}`);
  await build({ ...node, entryPoints, outdir: 'out/test' });
} else {
  const { metafile } = await build({ ...node, entryPoints: ['src/extension.ts'], outdir: 'out' });
  await build({
    ...common,
    platform: 'browser',
    format: 'iife',
    target: 'es2022',
    entryPoints: ['src/webview/page.ts', 'src/webview/page.css'],
    outdir: 'out',
  });
  if (release) {
    finish(metafile);
  }
}

function finish(metafile) {
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
