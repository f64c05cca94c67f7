// The live page in a real browser, as somebody would use it: node test_live_page.mjs ROOT WORK RME_LIVE REPLAY_LOG CHECK_ARM LOGS.
// WORK has node_modules/playwright-core; LOGS writes the recordings of docs/your_arm.md. The numbers on the page are those
// of the native programs. Pictures go to WORK/pictures.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {createRequire} from 'node:module';
import {extname, join} from 'node:path';

const [root, work, rmeLive, replayLog, checkArm, makeLogs] = process.argv.slice(2);
const {chromium} = createRequire(join(work, 'package.json'))('playwright-core');
const pictures = join(work, 'pictures');
mkdirSync(pictures, {recursive: true});

const types = {'.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css'};
const server = createServer(({url}, answer) => {
  const name = url === '/' ? 'index.html' : url.slice(1);
  answer.writeHead(200, {'Content-Type': types[extname(name)]});
  answer.end(readFileSync(join(root, 'docs/live', name)));
});
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const address = `http://127.0.0.1:${server.address().port}/`;

const browser = await chromium.launch({executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--enable-unsafe-swiftshader']});
const complaints = [];
async function open(width, height, url = address) {
  const page = await browser.newPage({viewport: {width, height}});
  page.setDefaultTimeout(240000);  // a busy machine takes longer than Playwright's 30 s to prepare the second module
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  const own = [new URL('.', url).href, 'data:', 'blob:'];
  page.on('request', (request) => own.some((start) => request.url().startsWith(start)) || complaints.push(`loads ${request.url()}`));
  await page.goto(url);
  return page;
}
const number = (page, id) => page.$eval(`#${id}`, (element) => +element.dataset.value);
const until = (page, what, argument) => page.waitForFunction(what, argument, {timeout: 480000});
// Simulated seconds pass: on a busy machine they are longer than real ones.
const simulated = async (page, seconds) =>
  until(page, (end) => rme.ticks() >= end, await page.evaluate(() => rme.ticks()) + 1000 * seconds);
const untilMass = (page, mass) => until(page, (m) => Math.abs(document.querySelector('#mass').dataset.value - m) < 0.02, mass);
const handOf = async (page, name) => {
  const {x, y} = await page.locator('#scene').boundingBox();
  const at = await page.evaluate((hand) => rme.handAt(hand), name);
  return {x: x + at.x, y: y + at.y};
};

// Attach, pour, push, let go, drop, move: with mouse and keys.
const begin = performance.now();
const page = await open(1280, 900);
await until(page, () => document.querySelector('#mass')?.dataset.value > 0.5);
console.log(`first estimate after ${((performance.now() - begin) / 1000).toFixed(1)} s`);
await untilMass(page, 1.2);
assert.match(await page.textContent('#caption'), /1.2 kg/);

await page.keyboard.press('d');
await untilMass(page, 0);
const weight = await page.locator('[data-attach="1.2"]').boundingBox(), hand = await handOf(page, 'with');
await page.mouse.move(weight.x + 10, weight.y + 10);
await page.mouse.down();
await page.mouse.move(hand.x, hand.y - 60, {steps: 8});
await page.mouse.up();
await untilMass(page, 1.2);
await simulated(page, 1);
assert.ok(await number(page, 'error-without') > 50, 'without rme the arm sags');
assert.ok(await number(page, 'error-with') < 2, 'with rme it does not');
await page.screenshot({path: join(pictures, 'held-1280.png'), fullPage: true});

await page.keyboard.down('p');
await until(page, () => document.querySelector('#mode-2').dataset.value > 90);
await simulated(page, 1.5);
await page.screenshot({path: join(pictures, 'poured-1280.png'), fullPage: true});
await page.keyboard.up('p');
await simulated(page, 1.5);
assert.ok(Math.abs(await number(page, 'mass') - await number(page, 'truth')) < 0.03, 'what was poured in is known');

const pulled = await handOf(page, 'with');
await page.mouse.move(pulled.x, pulled.y);
await page.mouse.down();
const measured = page.evaluate(() => new Promise((resolve) => {
  const start = performance.now(), before = rme.ticks();
  let frames = 0;
  const count = (now) => {
    ++frames;
    if (now - start < 3000) requestAnimationFrame(count);
    else resolve({frames: 1000 * frames / (now - start), real: (rme.ticks() - before) / (now - start)});
  };
  requestAnimationFrame(count);
}));
for (let i = 0; i < 30; ++i) {
  await page.mouse.move(pulled.x + 3 * i, pulled.y - i);
  await simulated(page, 0.09);
}
const {frames, real} = await measured;
console.log(`while a hand is pulled: ${frames.toFixed(0)} pictures and ${real.toFixed(3)} simulated seconds in a second; ` +
            `${(await number(page, 'speed')).toFixed(1)} would be possible`);
assert.ok(await number(page, 'speed') > 0, 'the page says how fast it could simulate');
assert.ok(await number(page, 'mode-3') > 90, 'a push is a push');
assert.ok(Math.hypot(await number(page, 'wrench-0'), await number(page, 'wrench-1')) > 10, 'and its wrench is seen');
await page.screenshot({path: join(pictures, 'pulled-1280.png'), fullPage: true});
await page.mouse.up();
await simulated(page, 1);
await page.keyboard.press('m');
await simulated(page, 3);
await page.locator('[data-attach="0.5"]').focus();
await page.keyboard.press('Enter');
await page.keyboard.press('d');
await untilMass(page, 0);
await page.keyboard.press('w');
await page.locator('#scene').focus();
await page.keyboard.down('ArrowRight');
await simulated(page, 1.5);
await page.keyboard.up('ArrowRight');
for (const key of 'fntxlb') await page.keyboard.press(key);
await simulated(page, 1);
await page.screenshot({path: join(pictures, 'all-faults-1280.png'), fullPage: true});

// The same session, natively.
const end = await page.evaluate(() => rme.pause());
writeFileSync(join(work, 'session.txt'), end.session);
const native = execFileSync(rmeLive, [join(work, 'session.txt'), '--until', end.ticks, '--seed', end.seed], {encoding: 'utf8'});
let furthest = 0;
for (const line of native.trim().split('\n')) {
  const [name, ...values] = line.split(' ');
  values.forEach((value, i) => {
    const error = Math.abs(value - end.numbers[name][i]) / Math.max(1, Math.abs(value));
    furthest = Math.max(furthest, error);
    assert.ok(error < 1e-6, `${name}[${i}]: ${value} natively, ${end.numbers[name][i]} on the page`);
  });
}
console.log(`${end.session.split('\n').length} commands, ${end.ticks} ticks: at most ${furthest.toExponential(1)} from the native numbers`);
assert.equal(await number(page, 'mass'), end.numbers['with.mean'][0], 'what is shown is what is computed');

// A recording of one's own, with its URDF.
const urdf = join(root, 'tests/data/urdf/six_joints_5kg.urdf'), logs = join(work, 'logs');
mkdirSync(logs, {recursive: true});
execFileSync(makeLogs, [urdf, logs]);
await page.setInputFiles('#files', [join(logs, 'lifted.csv'), urdf]);
await page.selectOption('#base', 'base_link');
await page.selectOption('#tip', 'tool0');
await page.click('#replay:enabled');
await until(page, () => /samples/.test(document.querySelector('#verdict').textContent));
const arm = ['--urdf', urdf, '--base', 'base_link', '--tip', 'tool0'];
const events = execFileSync(replayLog, [join(logs, 'lifted.csv'), '--json', ...arm], {encoding: 'utf8'}).trim().split('\n')
  .map((line) => JSON.parse(line)).filter(({final}) => final);
const replayed = await page.textContent('#output');
assert.ok(events.length > 0);
for (const {kind, t, mass} of events) assert.ok(replayed.includes(`${t.toFixed(3)} s  ${kind}  ${mass.toFixed(3)}`), replayed);
await page.screenshot({path: join(pictures, 'replayed-1280.png'), fullPage: true});
await page.close();  // its pictures would take the time of the next one's sums

const other = await open(390, 844);
await until(other, () => document.querySelector('#mass')?.dataset.value > 0.5);
await other.screenshot({path: join(pictures, 'held-390.png'), fullPage: true});
await other.setInputFiles('#files', [join(logs, 'empty.csv'), urdf]);
await other.selectOption('#base', 'base_link');
await other.selectOption('#tip', 'tool0');
await other.click('#check:enabled');
await until(other, () => /torque/.test(document.querySelector('#verdict').textContent));
const checked = spawnSync(checkArm, ['empty.csv', ...arm], {cwd: logs, encoding: 'utf8'});
assert.equal(checked.status, 0);
assert.match(await other.textContent('#verdict'), /can be right/);
// Line by line the same words, and numbers up to their last digit.
const words = (text) => text.trim().split(/[\s,]+/);
const here = words(await other.textContent('#output')), there = words(checked.stdout);
const from = here.indexOf('noise');
assert.deepEqual(here.slice(from).filter((word) => isNaN(word)), there.slice(there.indexOf('noise')).filter((word) => isNaN(word)));
await other.screenshot({path: join(pictures, 'checked-390.png'), fullPage: true});

// What the page says of files that it cannot use; and it works from a folder.
await other.evaluate(() => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File(['t,q1\n0,hello\n'], 'bad.csv'));
  document.body.dispatchEvent(new DragEvent('drop', {bubbles: true, cancelable: true, dataTransfer}));
});
await until(other, () => /could not be replayed/.test(document.querySelector('#verdict').textContent));
const local = await open(1280, 900, `file://${join(root, 'docs/live/index.html')}`);
await until(local, () => document.querySelector('#mass')?.dataset.value > 0.5);
assert.deepEqual(complaints, []);
await browser.close();
server.close();
