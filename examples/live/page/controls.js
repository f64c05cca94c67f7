// Buttons, keys, dragging and pulling: makes commands of them (Simulation::command()).
const kPush = 15;                    // of a key [N]
const kPull = 100, kMost = 40;       // of the mouse [N/m, N]
const kNearHand = 90;                // [pixels]
const kRate = 0.3;                   // of pouring [kg/s]
const kAside = 0.02;                 // of the centre of a weight [m]
const kBagMass = 1, kString = 0.25;  // [kg, m]
const kArrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};  // in the picture

export const kCupMass = 0.2;  // [kg]

/// The command that attaches a body below `below` others.
export function attaching(mass, below) {
  const aside = mass === kCupMass ? 0 : kAside;
  return `attach ${mass} ${aside} ${aside / 2} ${(0.1 + 0.07 * below).toFixed(2)}`;
}

/// @param page  act(command), get(field), say(text), view, held() with the objects in the hand, restart()
export function setUpControls(page) {
  const {act, view} = page;
  const buttons = [...document.querySelectorAll('#controls button')];
  const attach = (mass) => act(attaching(mass, page.held().length));
  let pose = 0;

  const clicked = {
    attach: (button) => attach(+button.dataset.attach),
    cup: () => attach(kCupMass),
    hang: () => act(`hang ${kBagMass} ${kString}`),
    command: (button) => act(button.dataset.command),
    pose: () => act(`pose ${pose = (pose + 1) % 4}`),
    restart: () => {
      pose = 0;
      for (const button of buttons) if (button.dataset.toggle) button.setAttribute('aria-pressed', false);
      page.restart();
    },
    toggle: (button) => {
      const on = button.getAttribute('aria-pressed') !== 'true';
      button.setAttribute('aria-pressed', on);
      act(`${button.dataset.toggle} ${on ? 1 : 0}`);
    },
  };
  const held = {
    pour: (on) => {
      if (on && !page.held().some(({kind}) => kind === 'cup')) attach(kCupMass);
      act(`pour ${on ? kRate : 0}`);
    },
    push: (on) => act(`push 0 ${on ? kPush : 0} 0`),
  };

  for (const button of buttons) {
    markKey(button);
    if (button.dataset.hold) {
      setUpHolding(button, held[button.dataset.hold]);
      continue;
    }
    const kind = Object.keys(clicked).find((name) => name in button.dataset);
    button.addEventListener('click', () => {
      clicked[kind](button);
      if (button.dataset.say && button.getAttribute('aria-pressed') !== 'false') page.say(button.dataset.say);
    });
    if (button.closest('.weights')) setUpDragging(button, page.say);
  }
  setUpKeys(buttons);
  if (!view) return;

  const push = (force) => act(`push ${force.toArray().map((x) => x.toFixed(3)).join(' ')}`);
  setUpArrows((x, y) => push(view.inArms(x, y).setLength(x || y ? kPush : 0)));
  setUpPulling(view, (x, y) => {
    push(view.inArms(x, y).multiplyScalar(kPull).clampLength(0, page.get('constrained')[0] ? kPush : kMost));
  });
}

/// Underlines the key in a button's text, or appends it.
function markKey(button) {
  const key = button.dataset.key, node = button.lastChild, at = node.data.toLowerCase().indexOf(key);
  const mark = document.createElement('u'), label = document.createElement('span');
  button.setAttribute('aria-keyshortcuts', key);
  mark.textContent = at < 0 ? key.toUpperCase() : node.data[at];
  label.append(...(at < 0 ? [node.data, ' ', mark] : [node.data.slice(0, at), mark, node.data.slice(at + 1)]));
  node.replaceWith(label);
}

/// A button that acts as long as it is held; keys hold it with the events "hold" and "release".
function setUpHolding(button, act) {
  const set = (on) => {
    if (button.classList.contains('held') === on) return;
    button.classList.toggle('held', on);
    act(on);
  };
  for (const begin of ['pointerdown', 'hold']) button.addEventListener(begin, () => set(true));
  for (const end of ['pointerup', 'pointerleave', 'pointercancel', 'blur', 'keyup', 'release'])
    button.addEventListener(end, () => set(false));
  button.addEventListener('keydown', ({key}) => {
    if (key === ' ' || key === 'Enter') set(true);
  });
}

/// A weight that is dragged follows the pointer, and is attached where it is let go over the arms.
function setUpDragging(button, say) {
  button.addEventListener('pointerdown', (down) => {
    const shown = document.createElement('div');
    shown.className = 'dragged';
    shown.append(button.querySelector('i').cloneNode());
    const move = ({clientX, clientY}) => {
      if (!shown.isConnected && Math.hypot(clientX - down.clientX, clientY - down.clientY) < 6) return;
      document.body.append(shown);
      shown.style.left = `${clientX}px`;
      shown.style.top = `${clientY}px`;
    };
    const end = ({type, clientX, clientY}) => {
      for (const [name, listener] of listeners) removeEventListener(name, listener);
      if (!shown.isConnected) return;
      shown.remove();
      if (type === 'pointercancel') return;
      if (document.elementFromPoint(clientX, clientY)?.closest('#stage')) button.click();
      else say('Let it go over one of the hands.');
    };
    const listeners = [['pointermove', move], ['pointerup', end], ['pointercancel', end]];
    for (const [name, listener] of listeners) addEventListener(name, listener);
  });
}

function setUpKeys(buttons) {
  const byKey = new Map(buttons.map((button) => [button.dataset.key, button]));
  addEventListener('keydown', ({altKey, ctrlKey, key, metaKey, repeat, target}) => {
    if (repeat || altKey || ctrlKey || metaKey || target.closest('input, select, pre')) return;
    const button = byKey.get(key.toLowerCase());
    if (button?.dataset.hold) button.dispatchEvent(new Event('hold'));
    else button?.click();
  });
  addEventListener('keyup', ({key}) => byKey.get(key.toLowerCase())?.dispatchEvent(new Event('release')));
}

/// Arrow keys, while the picture has the focus.
function setUpArrows(push) {
  const canvas = document.getElementById('scene'), down = new Set();
  const act = () => push(...[...down].reduce(([x, y], key) => [x + kArrows[key][0], y + kArrows[key][1]], [0, 0]));
  canvas.addEventListener('keydown', (event) => {
    if (!(event.key in kArrows)) return;
    event.preventDefault();
    if (event.repeat) return;
    down.add(event.key);
    act();
  });
  canvas.addEventListener('keyup', ({key}) => down.delete(key) && act());
  canvas.addEventListener('blur', () => {
    if (down.size === 0) return;
    down.clear();
    act();
  });
}

/// Pulls at a hand, or turns the picture.
function setUpPulling(view, pull) {
  const canvas = document.getElementById('scene');
  canvas.addEventListener('pointerdown', (down) => {
    const {left, top} = canvas.getBoundingClientRect();
    const near = ['without', 'with'].some((name) => {
      const {x, y} = view.handAt(name);
      return Math.hypot(down.clientX - left - x, down.clientY - top - y) < kNearHand;
    });
    let last = down;
    const move = (event) => {
      if (near) pull(event.clientX - down.clientX, event.clientY - down.clientY);
      else view.turn(event.clientX - last.clientX, event.clientY - last.clientY);
      last = event;
    };
    canvas.setPointerCapture(down.pointerId);
    canvas.addEventListener('pointermove', move);
    canvas.addEventListener('lostpointercapture', () => {
      canvas.removeEventListener('pointermove', move);
      if (near) pull(0, 0);
    }, {once: true});
  });
}
