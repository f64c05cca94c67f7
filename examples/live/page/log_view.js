// A recording of one's own: reads the files, has them replayed and checked by the second worker, and shows what comes out.
import {drawRows} from './history.js';

const $ = (id) => document.getElementById(id);

let files = [];  // {name, bytes}
let worker, calls = 0;

/// The worker, from a script that is loaded when the first log comes.
function load() {
  worker ??= new Promise((resolve, reject) => {
    const script = document.createElement('script');
    script.src = 'logs.js';
    script.onload = () => resolve(new Worker(URL.createObjectURL(new Blob([globalThis.rmeLogWorker], {type: 'text/javascript'}))));
    script.onerror = () => reject(new Error('logs.js is missing beside the page'));
    document.head.append(script);
  });
  return worker;
}

async function run(program, options) {
  const made = await load(), id = ++calls;
  return new Promise((resolve) => {
    const listen = ({data}) => {
      if (data.id !== id) return;
      made.removeEventListener('message', listen);
      resolve(data);
    };
    made.addEventListener('message', listen);
    made.postMessage({id, files, program, options});
  });
}

async function read(file) {
  const gzip = file.name.endsWith('.gz');
  const stream = gzip ? file.stream().pipeThrough(new DecompressionStream('gzip')) : file.stream();
  return {name: gzip ? file.name.slice(0, -3) : file.name, bytes: new Uint8Array(await new Response(stream).arrayBuffer())};
}

const isUrdf = ({name}) => /\.(urdf|xml)$/i.test(name);
const logs = () => files.filter((file) => !isUrdf(file)).map(({name}) => name);

/// Offers the links of a URDF: the root as base, and a leaf as end effector, "tool0" or the like if there is one.
function offerLinks(urdf) {
  const xml = new DOMParser().parseFromString(new TextDecoder().decode(urdf.bytes), 'text/xml');
  const names = [...xml.querySelectorAll('robot > link')].map((link) => link.getAttribute('name'));
  const ends = (tag) => new Set([...xml.querySelectorAll(`robot > joint > ${tag}`)].map((end) => end.getAttribute('link')));
  const parents = ends('parent'), children = ends('child');
  const moving = [...xml.querySelectorAll('robot > joint')].find((joint) => /revolute|continuous/.test(joint.getAttribute('type')));
  const leaves = names.filter((name) => !parents.has(name));
  const base = moving?.querySelector('parent')?.getAttribute('link') ?? names.find((name) => !children.has(name));
  const tip = leaves.find((name) => /^(tool0|.*flange|.*link8|.*ee|.*tip)$/i.test(name)) ?? leaves.at(-1);
  for (const [id, chosen] of [['base', base], ['tip', tip]])
    $(id).replaceChildren(...names.map((name) => new Option(name, name, false, name === chosen)));
}

async function take(list) {
  for (const file of list) {
    const got = await read(file);
    files = files.filter((known) => known.name !== got.name && !(isUrdf(known) && isUrdf(got)));
    files.push(got);
  }
  const urdf = files.find(isUrdf);
  $('chosen').textContent = files.map(({name}) => name).join(', ');
  $('arm').hidden = !urdf;
  if (urdf && [...list].some(isUrdf)) offerLinks(urdf);
  $('replay').disabled = $('check').disabled = logs().length === 0;
  if (logs().length > 0 && [...list].some((file) => !isUrdf(file))) await replay();
}

function options() {
  const urdf = files.find(isUrdf), more = $('options').value.trim();
  return [...(urdf ? ['--urdf', urdf.name, '--base', $('base').value, '--tip', $('tip').value] : []),
          ...(more ? more.split(/\s+/) : [])];
}

function show(verdict, lines) {
  $('verdict').textContent = verdict;
  $('output').hidden = false;
  $('output').textContent = lines.join('\n');
}

async function busy(what, task) {
  $('verdict').textContent = what;
  for (const id of ['replay', 'check']) $(id).disabled = true;
  await task();
  for (const id of ['replay', 'check']) $(id).disabled = false;
}

const replay = () => busy('replaying ...', async () => {
  const log = logs().at(-1), {code, output} = await run('replay_log', [log, '--json', ...options()]);
  if (code !== 0) {
    $('replayed').hidden = true;
    show(`${log} could not be replayed`, output);
    return;
  }
  const rows = output.filter((line) => line.startsWith('{')).map((line) => JSON.parse(line));
  const estimates = rows.filter(({type}) => type === 'estimate');
  const events = rows.filter(({type, final}) => final || type === 'rejected');
  const summary = rows.find(({type}) => type === 'summary');
  $('replayed').hidden = false;
  $('replayed').rows = estimates.map(({t, mass, std, truth}) => ({t, mean: mass, deviation: std[0], truth: truth?.[0]}));
  drawReplayed();
  show(`${log}: ${summary.samples} samples, ${summary.estimates} changes of the payload, ${summary.rejected} pushes`,
       [...rows.filter(({type}) => type === 'note').map(({text}) => text),
        ...events.map(({t, kind, mass, std}) => `${t.toFixed(3)} s  ${kind}` + (mass === undefined ? '' : `  ${mass.toFixed(3)} +- ${std[0].toFixed(3)} kg`))]);
});

function drawReplayed() {
  const {rows} = $('replayed');
  if (rows?.length > 1) drawRows($('replayed'), rows, rows[0].t, rows.at(-1).t);
}

const check = () => busy('checking ...', async () => {
  const {code, output} = await run('check_arm', [...logs(), ...options()]);
  show(['The arm fits: sign, units and frames of its torque can be right.',
        'Sign, units or frames of the torque do not fit the arm.', 'check_arm does not take these options.',
        'check_arm cannot use these files.'][code], output);
});

export function setUpLogs() {
  $('files').addEventListener('change', ({target}) => take(target.files));
  $('replay').addEventListener('click', replay);
  $('check').addEventListener('click', check);
  addEventListener('resize', drawReplayed);
  const over = (on) => (event) => {
    if (!event.dataTransfer?.types.includes('Files')) return;
    event.preventDefault();
    $('own').classList.toggle('over', on);
    if (event.type === 'drop') take(event.dataTransfer.files);
  };
  for (const [type, on] of [['dragover', true], ['dragleave', false], ['drop', false]]) addEventListener(type, over(on));
}
