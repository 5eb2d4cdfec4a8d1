// What the user does: the matrix of small pictures, the pointer and the keys.
'use strict';

const flickerPause = 500;  // ms; slower than what can cause a seizure

function move(down, right) {
  const row = Math.min(Math.max(view.row + down, 0), rows.length - 1);
  const column = Math.min(Math.max(view.column + right, 0), rows[row].length - 1);
  select(row, column, true);
}

function chooseGain(exponent) {
  view.ownGain = true;
  setGain(exponent);
}

function goToWorst() {
  if (view.pixels?.drawn) choosePixel(...worstPlace(view.pixels));
}

function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || byId('help').open) return;
  const arrows = {ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1]};
  const letters = {o: 'ours', t: 'theirs', d: 'difference', w: 'wipe', f: 'flicker', c: 'classes', p: 'flip'};
  const {key} = event;
  if (key in arrows) {
    if (event.target.matches('input')) return;  // a slider's own
    const [down, right] = arrows[key];
    if (event.shiftKey) choosePixel(view.x + right, view.y + down);
    else move(down, right);
  } else if (key in letters) {
    setMode(letters[key]);
  } else if (key === '+' || key === '=' || key === '-') {
    chooseGain(Number(gainInput.value) + (key === '-' ? -1 : 1));
  } else if (key === 'm') {
    goToWorst();
  } else if (key === '?') {
    byId('help').showModal();
  } else {
    return;
  }
  event.preventDefault();
}

/// The pixel under the pointer is chosen; with a button down, the wipe follows.
function onPointer(event) {
  const box = picture.getBoundingClientRect();
  const share = (event.clientX - box.left) / box.width;
  choosePixel(Math.floor(share * picture.width), Math.floor((event.clientY - box.top) / box.height * picture.height));
  if (view.mode !== 'wipe' || !event.buttons) return;
  wipeInput.value = 1000 * share;
  paint();
}

/// The matrix' pictures, one after another, so that the large one is not kept waiting.
async function drawMatrix() {
  draw(byId('cover'), paintCover(await coverPixels()));
  for (const [row, buttons] of rows.entries()) {
    for (const [column, button] of buttons.entries()) {
      const shot = column ? column - 1 : report.renderers[row].coverage.shot;
      const canvas = button.querySelector('canvas');
      const pixels = await cellPixels(row, shot);
      drawSmall(canvas, pixels.drawn ? column ? paintTheirs(pixels) : paintClasses(pixels, true) : null, pixels);
    }
  }
  document.body.dataset.ready = true;
}

/// The cell to begin with: the first that differs, or else the first final picture.
function firstCell() {
  for (const [row, renderer] of report.renderers.entries()) {
    if (renderer.coverage.outcome === 'differed') return [row, 0];
    const shot = renderer.cells.findIndex((cell) => !['agreed', 'skipped'].includes(cell.outcome));
    if (shot >= 0) return [row, shot + 1];
  }
  const final = report.shots.findIndex((shot) => shot.final);
  const row = report.renderers.findIndex((_, renderer) => isDrawn(renderer, final));
  return [Math.max(row, 0), final + 1];
}

function begin() {
  for (const [row, buttons] of rows.entries()) {
    buttons.forEach((button, column) => button.addEventListener('click', () => select(row, column, true)));
  }
  for (const button of document.querySelectorAll('[data-mode]')) {
    button.addEventListener('click', () => setMode(button.dataset.mode));
  }
  gainInput.addEventListener('input', () => chooseGain(gainInput.value));
  wipeInput.addEventListener('input', paint);
  byId('worst').addEventListener('click', goToWorst);
  byId('help-button').addEventListener('click', () => byId('help').showModal());
  picture.addEventListener('pointermove', onPointer);
  picture.addEventListener('pointerdown', onPointer);
  document.addEventListener('keydown', onKey);
  window.addEventListener('resize', fit);
  setInterval(() => {
    if (view.mode !== 'flicker') return;
    view.odd = !view.odd;
    paint();
  }, flickerPause);
  setGain(gainInput.value);
  if (rows.length) select(...firstCell(), false).then(drawMatrix);
}

begin();
