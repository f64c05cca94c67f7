// The page: passes what somebody does to the worker, and shows the numbers that come back.
import text from 'worker:worker.js';
import {attaching, kCupMass, setUpControls} from './controls.js';
import {drawHistory, History} from './history.js';
import {setUpLogs} from './log_view.js';
import {View} from './scene.js';

const kModes = ['hand is empty', 'holds it steadily', 'is being filled', 'something pushes', 'payload is changing'];
const kEvents = ['', 'attached', 'exchanged', 'removed', 'filled', 'only a push'];
const kGiven = 300;  // tick at which the introduction attaches a weight
const kShown = 100;  // ticks between two of which the page shows the numbers

const $ = (id) => document.getElementById(id);
const worker = new Worker(URL.createObjectURL(new Blob([text], {type: 'text/javascript'})));
const history = new History();

let fields, values, view;
let ticks = 0, seed = 1;
let busy = 0;       // computing time of a simulated second [s]
let session = [];   // accepted commands: "TICK COMMAND"
let objects = [];   // in the hand
let intro = true;   // nobody has done anything yet
let given = false;  // whether the introduction has attached its weight
let events = 0;     // that have been spoken of
let shown = -1;     // tick whose numbers the page shows

const get = (name) => {
  const [offset, count] = fields[name];
  return values.subarray(offset, offset + count);
};
const send = (command) => worker.postMessage({command});

/// What somebody does; it ends the introduction.
function act(command) {
  intro = false;
  send(command);
}

worker.onmessage = ({data}) => {
  if (data.fields) {
    fields = data.fields;
    session = [];
    objects = [];
    events = 0;
    history.clear();
  }
  if (data.frames) {
    for (values of data.frames) history.add(get);
    ticks = data.ticks;
    if (data.busy) busy += (data.busy - busy) * 0.05;
    if (intro) introduce();
  }
  if (data.command) data.accepted ? happened(data.command, data.at) : say('A Panda is rated for 3 kg: that would be too much.');
  if (data.paused) paused();
};

function happened(command, at) {
  session.push(`${at} ${command}`);
  const [name, ...numbers] = command.split(' ');
  if (name === 'attach') objects.push({kind: +numbers[0] === kCupMass ? 'cup' : 'weight', mass: +numbers[0], com: numbers.slice(1).map(Number)});
  if (name === 'drop') objects = [];
}

/// The first seconds, for somebody who only looks.
function introduce() {
  if (!given && ticks >= kGiven) send(attaching(1.2, 0));
  given = ticks >= kGiven;
  if (ticks < kGiven) say('Both hands are empty.');
  else if (ticks < 4000) say('Both hands were given 1.2 kg. Nobody told the arms.');
  else say('Your turn: drag a weight onto a hand, or pull at a hand.');
}

function say(what) {
  if ($('caption').textContent !== what) $('caption').textContent = what;
}

/// Writes a number into an <output>; data-value keeps all its digits.
function show(id, value, digits, unit = '') {
  const element = $(id);
  element.dataset.value = value;
  const shown = value.toFixed(digits) + unit;
  if (element.textContent !== shown) element.textContent = shown;
}

function showNumbers() {
  const mean = get('with.mean'), deviation = get('with.deviation'), truth = get('with.payload');
  const length = (v) => Math.hypot(...v);
  show('error-without', 1e3 * length(get('without.error')), 1);
  show('error-with', 1e3 * length(get('with.error')), 1);
  show('mass', mean[0], 3);
  show('mass-deviation', deviation[0], 3);
  show('truth', truth[0], 3);
  for (let i = 0; i < 3; ++i) {
    show(`com-${i}`, 1e3 * mean[i + 1], 1);
    show(`com-deviation-${i}`, 1e3 * deviation[i + 1], 1);
    show(`com-truth-${i}`, 1e3 * truth[i + 1], 1);
  }
  const probability = get('with.probability'), likeliest = probability.indexOf(Math.max(...probability));
  kModes.forEach((_, i) => {
    const row = $('modes').children[i];
    row.classList.toggle('likeliest', i === likeliest);
    row.querySelector('i').style.width = `${100 * probability[i]}%`;
    show(`mode-${i}`, 100 * probability[i], 1, ' %');
  });
  const wrench = [...get('with.force'), ...get('with.moment')];
  wrench.forEach((value, i) => {
    const share = Math.max(-1, Math.min(1, value / (i < 3 ? 40 : 4))), bar = $('wrench').children[i].querySelector('i');
    bar.style.left = `${50 + 50 * Math.min(share, 0)}%`;
    bar.style.width = `${50 * Math.abs(share)}%`;
    show(`wrench-${i}`, value, i < 3 ? 1 : 2, i < 3 ? ' N' : ' N m');
  });
  const health = get('with.health')[0], [joint, room] = get('with.limit');
  show('health', health, 1);
  $('health-word').textContent = health < 3 ? 'good' : 'not explained';
  show('confidence', 100 * get('with.confidence')[0], 0, ' %');
  show('friction', 100 * get('with.friction_shows')[0], 0, ' %');
  show('wall', 1e3 * get('with.wall')[0], 0, ' mm');
  $('limit').textContent = `joint ${joint}, ${(room * 180 / Math.PI).toFixed(0)}° away`;
  if (busy > 0) show('speed', 1 / busy, 1);
  const [number, kind, onset, noticed] = get('with.event');
  if (get('with.changing')[0]) $('noticed').textContent = 'something is happening';
  else if (number > 0) $('noticed').textContent = `${kEvents[kind]}: noticed ${Math.round(1e3 * (noticed - onset))} ms after it began`;
  if (number > events && !intro) say(`rme: ${kEvents[kind]}, ${mean[0].toFixed(2)} kg.`);
  events = number;
}

function frame() {
  requestAnimationFrame(frame);
  if (!values) return;
  view?.draw(get, objects.map((object) => object.kind === 'cup' ? {...object, mass: get('poured')[0]} : object));
  if (shown >= 0 && ticks >= shown && ticks < shown + kShown) return;
  shown = ticks;
  showNumbers();
  drawHistory($('history'), history);
}

function addBars(list, names, id) {
  for (const [i, name] of names.entries())
    $(list).insertAdjacentHTML('beforeend', `<li><span>${name}</span><span class="bar"><i></i></span><output id="${id}-${i}"></output></li>`);
}

$('save').addEventListener('click', () => {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([session.join('\n') + '\n']));
  link.download = `session-seed-${seed}-until-${ticks}.txt`;
  link.click();
});

addBars('modes', kModes, 'mode');
addBars('wrench', ['force x', 'force y', 'force z', 'moment x', 'moment y', 'moment z'], 'wrench');
setUpLogs();
try {
  view = new View($('scene'));
} catch {
  say('This browser draws no three dimensions (WebGL). The numbers are those of the arms all the same.');
}
setUpControls({
  act, get, say, view,
  held: () => objects,
  restart: () => {
    intro = false;
    worker.postMessage({start: ++seed});
  },
});
requestAnimationFrame(frame);

// For tests: what has been done, and all numbers after it.
let paused;
globalThis.rme = {
  pause: () => new Promise((resolve) => {
    paused = () => {
      showNumbers();
      const numbers = Object.fromEntries(Object.keys(fields).map((name) => [name, [...get(name)]]));
      resolve({ticks, seed, session: session.join('\n'), numbers});
    };
    worker.postMessage({paused: true});
  }),
  resume: () => worker.postMessage({paused: false}),
  ticks: () => ticks,
  handAt: (name) => view.handAt(name),
};
