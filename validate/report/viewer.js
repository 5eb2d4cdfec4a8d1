// The selected cell of the matrix: its large picture in each mode, and the values of a pixel.
'use strict';

const byId = (id) => document.getElementById(id);
const picture = byId('picture'), gainInput = byId('gain'), wipeInput = byId('wipe');
const rows = report.renderers.map(
    (_, renderer) => [...document.querySelectorAll(`button.cell[data-renderer="${renderer}"]`)]);

// What is shown. `pixels` are the cell's, `images` what was painted of them, by mode; `ownGain`: the user chose one.
const view = {row: 0, column: 0, renderer: 0, shot: 0, mode: 'theirs', x: 0, y: 0, pixels: null, images: {}, odd: false,
              ownGain: false};

const gain = () => 2 ** Number(gainInput.value);
const shown = (value) => value.toFixed(3).replace(/^-0.000$/, '0.000');
const isDrawn = (renderer, shot) => Boolean(report.renderers[renderer].cells[shot].difference);

function imageOf(mode) {
  const painters = {ours: paintOurs, theirs: paintTheirs, classes: paintClasses, flip: paintFlip};
  if (mode === 'difference') return paintDifference(view.pixels, gain());
  return view.images[mode] ??= painters[mode](view.pixels, view.column === 0);
}

/// Where the wipe is, in the picture's pixels.
const wipeAt = () => Math.round(picture.width * Number(wipeInput.value) / 1000);

function paint() {
  const {mode} = view, context = picture.getContext('2d', {willReadFrequently: true});
  if (mode === 'wipe') {
    blit(context, imageOf('theirs'), 0, wipeAt());
    blit(context, imageOf('ours'), wipeAt());
    context.fillStyle = '#fff';
    context.fillRect(wipeAt() - 0.5, 0, 1, picture.height);
  } else if (mode === 'flicker') {
    blit(context, imageOf(view.odd ? 'ours' : 'theirs'));
  } else {
    blit(context, imageOf(mode));
  }
  byId('badge').textContent = mode === 'flicker' ? (view.odd ? 'ours' : 'theirs') : '';
  const {renderers, shots} = report;
  picture.setAttribute('aria-label', `${renderers[view.renderer].name}, ${shots[view.shot].title}: ${mode}`);
}

/// The picture as large as the window lets it be; a small one by a whole factor.
function fit() {
  const room = picture.closest('.viewer').clientWidth;
  const high = Math.max(window.innerHeight - picture.getBoundingClientRect().top - window.scrollY - 150, 240);
  const scale = Math.min(room / picture.width, high / picture.height);
  const whole = scale > 1 ? Math.floor(scale) : scale;
  picture.style.width = `${Math.floor(picture.width * whole)}px`;
  picture.style.imageRendering = whole > 1 ? 'pixelated' : 'auto';
  placePin();
}

function placePin() {
  const scale = picture.clientWidth / picture.width;
  byId('pin').style.left = `${(view.x + 0.5) * scale}px`;
  byId('pin').style.top = `${(view.y + 0.5) * scale}px`;
}

function setMode(mode) {
  if (!view.pixels?.drawn) mode = 'ours';
  view.mode = mode;
  for (const button of document.querySelectorAll('[data-mode]')) {
    button.setAttribute('aria-pressed', button.dataset.mode === mode);
    button.disabled = !view.pixels?.drawn && button.dataset.mode !== 'ours';
  }
  for (const part of document.querySelectorAll('[data-for]')) {
    part.classList.toggle('shown', part.dataset.for === mode);
  }
  paint();
}

function setGain(exponent) {
  gainInput.value = Math.min(Math.max(exponent, 0), 8);
  byId('gain-text').textContent = `\u00d7 ${gain()}`;
  if (view.mode === 'difference') paint();
  showPixel();
}

/// A row of the table under the matrix: one stage at the chosen pixel.
function readoutRow(shot, pixels) {
  const pixel = view.y * pixels.width + view.x, channels = [0, 1, 2];
  const row = document.createElement('tr');
  const add = (text, name) => {
    const cell = document.createElement('td');
    cell.textContent = text;
    if (name) cell.className = name;
    row.append(cell);
  };
  if (shot === view.shot) row.setAttribute('aria-current', true);
  row.dataset.shot = shot;
  add(report.shots[shot].title);
  if (!pixels.drawn) {
    add('not drawn');
    return row;
  }
  const error = pixels.error(pixel), mark = pixels.mark(pixel);
  add(channels.map((c) => shown(pixels.ours(pixel, c))).join(' '));
  const theirs = channels.map((c) => pixels.ours(pixel, c) + pixels.difference(pixel, c));
  add(theirs.map((value) => shown(pixels.limited ? Math.min(Math.max(value, 0), 1) : value)).join(' '));
  const tolerance = codeTolerance(pixels.step, error);
  add(error ? `${error.toPrecision(3)} \u00b1 ${tolerance.toPrecision(1)}` : `< ${tolerance.toPrecision(2)}`,
      pixels.limit && error > pixels.limit ? 'beyond' : '');
  add(pixels.limit ?? 'its own');
  add(pixels.cover(pixel) || mark ? report.markNames[mark] : 'background');
  return row;
}

/// The values of the chosen pixel, in every stage.
async function showPixel() {
  const {renderer, pixels} = view;
  if (!pixels) return;
  placePin();
  if (pixels.drawn) drawLoupe(byId('loupe'), pixels, view.x, view.y, gain());
  const all = await Promise.all(report.shots.map((_, shot) => cellPixels(renderer, shot)));
  if (renderer !== view.renderer) return;
  const block = report.block, silhouette = pixels.cover?.(view.y * pixels.width + view.x) === 2;
  byId('readout').hidden = false;
  byId('readout').tBodies[0].replaceChildren(...all.map((one, shot) => readoutRow(shot, one)));
  byId('readout').caption.textContent = `${report.renderers[renderer].name} at pixel ` +
      `${view.x * block}, ${view.y * block}` + (block > 1 ? `, means of ${block} \u00d7 ${block} pixels` : '') +
      (silhouette ? ', at a silhouette' : '') + ': ours to \u00b1 0.002';
}

function choosePixel(x, y) {
  if (!view.pixels) return;
  view.x = Math.min(Math.max(x, 0), view.pixels.width - 1);
  view.y = Math.min(Math.max(y, 0), view.pixels.height - 1);
  showPixel();
}

function showLegend() {
  const coverage = view.column === 0, counts = markCounts(view.pixels, coverage);
  const entries = report.markNames.map((name, mark) => {
    const entry = document.createElement('span');
    entry.style.setProperty('--swatch', cssColor(markColors[mark % markColors.length]));
    entry.textContent = `${name}: ${count(counts[mark])}`;
    return entry;
  });
  const used = entries.filter((_, mark) => mark && counts[mark]);
  const few = used.length && marksAreFew(view.pixels, coverage) ? ['(each drawn 3 pixels wide)'] : [];
  byId('legend').replaceChildren(...used.length ? used : [`every pixel ${coverage ? 'is covered by both or neither' : 'is within the limit'}`], ...few);
}

function showFlipText(cell) {
  byId('flip-text').textContent = cell.flip ?
      `mean ${cell.meanFlip.toPrecision(2)}; black 0, yellow 1` :
      `no channel differs by ${report.flipFrom.toPrecision(2)}: FLIP is below 0.04 everywhere`;
}

function showTitle(renderer, shot, coverage) {
  const cell = renderer.cells[shot], outcome = coverage ? renderer.coverage.outcome : cell.outcome;
  const word = document.createElement('span');
  word.className = word.textContent = outcome;
  byId('title').replaceChildren(`${renderer.name}, ${coverage ? 'coverage' : report.shots[shot].title}: `, word);
  const {step, block} = cell.difference ?? {};
  const precision = !step ? '' : `differences below ${(step / 2).toPrecision(2)} are shown as 0, others are right to ` +
      `4.5 %${block > 1 ? `; they are means of ${block} \u00d7 ${block} of the page's pixels, as so many differ` : ''}`;
  byId('note').textContent = [cell.why, cell.note, ...cell.exceeded ?? [], precision].filter(Boolean).join('; ');
}

/// Shows the cell of a row and column of the matrix; `focus` moves the keyboard's focus there.
async function select(row, column, focus) {
  const button = rows[row][column], coverage = column === 0;
  const renderer = report.renderers[row], shot = coverage ? renderer.coverage.shot : column - 1;
  const sameRenderer = view.renderer === row && view.pixels;
  const before = document.querySelector('button.cell[aria-current]');
  before?.removeAttribute('aria-current');
  before?.setAttribute('tabindex', -1);
  button.setAttribute('aria-current', true);
  button.tabIndex = 0;
  if (focus) button.focus();
  Object.assign(view, {row, column, renderer: row, shot});
  const pixels = await cellPixels(row, shot);
  if (view.row !== row || view.column !== column) return;
  Object.assign(view, {pixels, images: {}});
  byId('viewer').hidden = false;
  picture.width = pixels.width;
  picture.height = pixels.height;
  showTitle(renderer, shot, coverage);
  for (const id of ['loupe', 'histogram', 'worst']) byId(id).hidden = !pixels.drawn;
  if (pixels.drawn) {
    showLegend();
    showFlipText(renderer.cells[shot]);
    drawHistogram(byId('histogram'), pixels);
  }
  // Until the user chooses a gain: the largest at which nothing is too bright.
  if (!view.ownGain) setGain(-Math.ceil(Math.log2(renderer.cells[shot].max || 1)));
  setMode(coverage ? 'classes' : view.mode);
  fit();
  if (sameRenderer) showPixel();
  else if (pixels.drawn) choosePixel(...worstPlace(pixels));
  else choosePixel(view.x, view.y);
}
