// Runs check_arm and replay_log on the files that were dropped onto the page. They never leave the browser.
import createModule from 'built:logs.js';
import wasm from 'gzip:logs.wasm';
import {decompress} from './decompress.js';

const compiled = decompress(wasm);

// Each run has an instance of its own, as a program has.
async function run(files, program, options) {
  const output = [];
  const module = await createModule({
    wasmBinary: await compiled,
    print: (line) => output.push(line),
    printErr: (line) => output.push(line),
  });
  for (const {name, bytes} of files) module.FS.writeFile(name, bytes);
  return {code: module.callMain([program, ...options]), output};
}

onmessage = async ({data}) => {
  try {
    postMessage({id: data.id, ...await run(data.files, data.program, data.options)});
  } catch (error) {
    postMessage({id: data.id, code: 3, output: [`${data.program}: ${error.message}`]});
  }
};
