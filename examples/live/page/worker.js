// Runs the simulation in real time, and tells the page what it draws.
import createModule from 'built:live.js';
import wasm from 'gzip:live.wasm';
import {decompress} from './decompress.js';

const kFrame = 20;    // ticks between two sets of numbers, 1 ms each
const kLongest = 200; // ticks that are made up for at most, after the browser has not let the worker run

let module, fields, ticks, paused, lag, from;

function read() {
  const at = module._live_values() / 8;
  return module.HEAPF64.slice(at, at + fields.length);
}

function start(seed) {
  module._live_start(seed);
  const lines = module.ccall('live_layout', 'string').trim().split('\n').map((line) => line.split(' '));
  fields = {names: {}, length: 0};
  for (const [name, offset, count] of lines) {
    fields.names[name] = [+offset, +count];
    fields.length = +offset + +count;
  }
  ticks = lag = 0;
  from = performance.now();
  paused = false;
  postMessage({fields: fields.names, seed});
  postMessage({frames: [read()], ticks});
}

function advance() {
  const now = performance.now();
  lag = Math.min(lag + now - from, kLongest);
  from = now;
  if (paused) return;
  const frames = [];
  for (; lag >= kFrame; lag -= kFrame) {
    module._live_step(kFrame);
    ticks += kFrame;
    frames.push(read());
  }
  if (frames.length > 0) postMessage({frames, ticks, busy: (performance.now() - now) / (frames.length * kFrame)});
}

onmessage = ({data}) => {
  if (data.start !== undefined) start(data.start);
  if (data.paused !== undefined) {
    paused = data.paused;
    lag = 0;
    if (paused) postMessage({paused});
  }
  if (data.command) {
    const accepted = module.ccall('live_command', 'number', ['string'], [data.command]) !== 0;
    postMessage({command: data.command, accepted, at: ticks});
  }
};

decompress(wasm)
  .then((wasmBinary) => createModule({wasmBinary}))
  .then((made) => {
    module = made;
    start(1);
    setInterval(advance, kFrame / 2);
  });
