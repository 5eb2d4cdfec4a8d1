// The report's pictures as numbers. A renderer's picture is ours plus a coded difference
// (validate/compare/difference_code.h); ours is a PNG of 8 bits plus what limiting to [0, 1] took away.
'use strict';

const report = JSON.parse(document.getElementById('data').textContent);
const displayStep = 1 / 255;

/// The difference that each byte of a coded picture means.
function differenceTable(step) {
  return Float64Array.from({length: 256}, (_, byte) => {
    const code = byte < 128 ? byte : byte - 256;
    return step * Math.sinh(report.bend * code) / report.bend;
  });
}

/// The largest error of a decoded difference: half the way to the code beyond it.
function codeTolerance(step, difference) {
  const code = Math.asinh(report.bend * Math.abs(difference) / step) / report.bend;
  return step * Math.cosh(report.bend * (code + 0.5)) / 2;
}

/// The bytes of an image element or of a URL: r, g, b, a per pixel.
async function bytesOf(source) {
  let image = source;
  if (typeof source === 'string') {
    image = new Image();
    image.src = source;
  }
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = image.naturalWidth;
  canvas.height = image.naturalHeight;
  const context = canvas.getContext('2d', {willReadFrequently: true});
  context.drawImage(image, 0, 0);
  const data = context.getImageData(0, 0, canvas.width, canvas.height).data;
  return {width: canvas.width, height: canvas.height, data};
}

/// The bytes of a picture whose pixels stand for blocks of a larger one, spread to its size.
function spread(image, block, width, height) {
  if (block === 1) return image.data;
  const from = new Uint32Array(image.data.buffer), to = new Uint32Array(width * height);
  for (let y = 0, at = 0; y < height; ++y) {
    const row = Math.floor(y / block) * image.width;
    for (let x = 0; x < width; ++x) to[at++] = from[row + Math.floor(x / block)];
  }
  return new Uint8ClampedArray(to.buffer);
}

/// A coded picture of the size of `own`, or null.
async function codedOf(coded, own) {
  if (!coded) return null;
  const data = spread(await bytesOf(coded.url), coded.block, own.width, own.height);
  return {data, step: coded.step, table: differenceTable(coded.step)};
}

/// `load(key)`, kept for the `count` keys used last.
function kept(count, load) {
  const all = new Map();
  return (...key) => {
    const name = key.join();
    const found = all.get(name) ?? load(...key);
    all.delete(name);
    all.set(name, found);
    if (all.size > count) all.delete(all.keys().next().value);
    return found;
  };
}

const coverPixels = kept(1, () => bytesOf(report.cover));

const ownPixels = kept(report.shots.length, async (shot) => {
  const display = await bytesOf(document.getElementById(`ours-${shot}`));
  return {...display, excess: await codedOf(report.shots[shot].excess, display)};
});

/// Ours of the shot that was drawn in place of the one requested.
async function insteadPixels(cell, own) {
  const change = await bytesOf(cell.instead);
  const data = own.data.map((byte, i) => i % 4 === 3 ? 255 : byte + change.data[i] & 255);
  return {...own, data, excess: await codedOf(cell.insteadExcess, own)};
}

/// Everything known of a cell's pixels. `value` functions take a pixel's number and a channel, 0 to 2.
async function loadCell(renderer, shot) {
  const {limited, limit, cells} = report.renderers[renderer];
  const cell = cells[shot];
  let own = await ownPixels(shot);
  if (!cell.difference) return {drawn: false, ...own};
  if (cell.instead) own = await insteadPixels(cell, own);
  const [difference, marks, cover, flip] = await Promise.all([
    codedOf(cell.difference, own), bytesOf(cell.marks), coverPixels(), cell.flip ? bytesOf(cell.flip) : null]);
  const excess = limited ? null : own.excess;
  const error = (pixel) => {
    const [r, g, b] = [0, 1, 2].map((c) => Math.abs(difference.table[difference.data[4 * pixel + c]]));
    return Math.max(r, g, b);
  };
  return {
    ...own, drawn: true, limit, limited, step: difference.step, flip, error,
    ours: (pixel, c) => own.data[4 * pixel + c] * displayStep +
        (excess ? excess.table[excess.data[4 * pixel + c]] : 0),
    difference: (pixel, c) => difference.table[difference.data[4 * pixel + c]],
    mark: (pixel) => marks.data[4 * pixel],
    cover: (pixel) => cover.data[4 * pixel],
  };
}

const cellPixels = kept(2 * report.shots.length, loadCell);

/// A histogram of the errors of the covered pixels: how many are 0 to the code's step, then in each
/// octave [2^n, 2^(n + 1)), from n = `first` on.
function histogramOf(pixels) {
  const first = Math.floor(Math.log2(pixels.step));
  const octaves = new Array(4 - first).fill(0);
  let zeros = 0;
  for (let pixel = 0; pixel < pixels.width * pixels.height; ++pixel) {
    if (!pixels.cover(pixel)) continue;
    const error = pixels.error(pixel);
    if (error === 0) ++zeros;
    else ++octaves[Math.min(Math.max(Math.floor(Math.log2(error) + 1e-9) - first, 0), octaves.length - 1)];
  }
  return {zeros, first, octaves};
}

/// Where the error is largest, of all pixels: x and y.
function worstPlace(pixels) {
  let worst = 0, largest = -1;
  for (let pixel = 0; pixel < pixels.width * pixels.height; ++pixel) {
    const error = pixels.error(pixel);
    if (error > largest) [worst, largest] = [pixel, error];
  }
  return [worst % pixels.width, Math.floor(worst / pixels.width)];
}

/// A pixel's mark; of coverage alone only the last two are.
const shownMark = (pixels, pixel, coverage) => {
  const mark = pixels.mark(pixel);
  return coverage && mark < report.markNames.length - 2 ? 0 : mark;
};

/// The pixels of each mark, by its number.
function markCounts(pixels, coverage) {
  const counts = new Array(report.markNames.length).fill(0);
  for (let pixel = 0; pixel < pixels.width * pixels.height; ++pixel) ++counts[shownMark(pixels, pixel, coverage)];
  return counts;
}
