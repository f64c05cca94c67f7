// Puts the page together: node bundle.mjs NODE_MODULES WASM_FOLDER OUTPUT. Each worker becomes text in a script, each module
// base64 text of a gzip file in its worker; the output needs no server.
import {createRequire} from 'node:module';
import {copyFileSync, readFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';

const [modules, wasm, output] = process.argv.slice(2).map((path) => resolve(path));
const page = join(dirname(fileURLToPath(import.meta.url)), 'page');
const {build} = createRequire(join(modules, 'package.json'))('esbuild');

function bundle(entry, more) {
  return build({
    entryPoints: [join(page, entry)],
    bundle: true,
    minify: true,
    legalComments: 'eof',
    nodePaths: [modules],
    target: 'es2022',
    plugins: [built],
    ...more,
  });
}

// built:NAME, gzip:NAME: what emscripten has made. worker:NAME: a worker as text.
const built = {
  name: 'built',
  setup({onLoad, onResolve}) {
    onResolve({filter: /^(built|gzip|worker):/}, ({path}) => {
      const [kind, name] = path.split(':');
      return {path: join(kind === 'worker' ? page : wasm, name), namespace: kind};
    });
    onLoad({filter: /./, namespace: 'built'}, ({path}) => ({contents: readFileSync(path), loader: 'js'}));
    onLoad({filter: /./, namespace: 'gzip'}, ({path}) => ({
      contents: gzipSync(readFileSync(path), {level: 9}).toString('base64'), loader: 'text'}));
    onLoad({filter: /./, namespace: 'worker'}, async ({path}) => {
      const {outputFiles} = await build({entryPoints: [path], bundle: true, minify: true, target: 'es2022', plugins: [built],
                                         write: false});
      return {contents: outputFiles[0].text, loader: 'text'};
    });
  },
};

await bundle('main.js', {outfile: join(output, 'page.js')});
await bundle('logs.js', {outfile: join(output, 'logs.js')});
for (const file of ['index.html', 'style.css']) copyFileSync(join(page, file), join(output, file));
