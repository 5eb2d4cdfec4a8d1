// What the report draws: a cell's pixels in each mode, as images of canvas; the histogram as SVG.
'use strict';

// Colours that people with any kind of colour vision can tell apart (Okabe and Ito), .
const markColors = [[0, 0, 0], [86, 180, 233], [240, 228, 66], [0, 158, 115], [230, 159, 0], [204, 121, 167],
                    [255, 40, 40], [150, 150, 255], [255, 0, 255]];
// Matplotlib's "magma" at nine places, as FLIP's authors show it.
const magma = [[0, 0, 4], [28, 16, 68], [79, 18, 123], [129, 37, 129], [181, 54, 122], [229, 80, 100], [251, 135, 97],
               [254, 194, 135], [252, 253, 191]];

const cssColor = (rgb) => `rgb(${rgb.join(' ')})`;

/// An image with color(pixel, channel), in [0, 1], of each pixel.
function painted(pixels, color) {
  const image = new ImageData(pixels.width, pixels.height);
  for (let pixel = 0, at = 0; pixel < pixels.width * pixels.height; ++pixel, at += 4) {
    image.data[at] = 255 * color(pixel, 0);
    image.data[at + 1] = 255 * color(pixel, 1);
    image.data[at + 2] = 255 * color(pixel, 2);
    image.data[at + 3] = 255;
  }
  return image;
}

const paintOurs = (pixels) => new ImageData(new Uint8ClampedArray(pixels.data), pixels.width, pixels.height);

const paintTheirs = (pixels) =>
    painted(pixels, (pixel, c) => pixels.ours(pixel, c) + pixels.difference(pixel, c));

const paintDifference = (pixels, gain) =>
    painted(pixels, (pixel, c) => gain * Math.abs(pixels.difference(pixel, c)));

/// Ours as faint grey under the marks. Few marks are drawn three pixels wide, or nobody would see them.
function paintClasses(pixels, coverage) {
  const grey = (pixel) =>
      (pixels.data[4 * pixel] + pixels.data[4 * pixel + 1] + pixels.data[4 * pixel + 2]) / (3 * 255);
  const image = painted(pixels, (pixel) => pixels.cover(pixel) ? 0.12 + 0.3 * grey(pixel) : 0);
  const {width, height} = pixels;
  const reach = marksAreFew(pixels, coverage) ? 1 : 0;
  const set = (x, y, rgb) => {
    if (x >= 0 && x < width && y >= 0 && y < height) image.data.set(rgb, 4 * (y * width + x));
  };
  for (let pixel = 0; pixel < width * height; ++pixel) {
    const mark = shownMark(pixels, pixel, coverage);
    if (!mark) continue;
    const x = pixel % width, y = (pixel - x) / width;
    for (let dy = -reach; dy <= reach; ++dy) {
      for (let dx = -reach; dx <= reach; ++dx) set(x + dx, y + dy, markColors[mark % markColors.length]);
    }
  }
  return image;
}

function marksAreFew(pixels, coverage) {
  const all = pixels.width * pixels.height;
  return all > 40000 && all - markCounts(pixels, coverage)[0] < all / 200;
}

function magmaColor(value) {
  const at = Math.min(value, 1) * (magma.length - 1), i = Math.min(Math.floor(at), magma.length - 2);
  return magma[i].map((low, c) => low + (at - i) * (magma[i + 1][c] - low));
}

/// FLIP's map, which may be smaller than the picture.
function paintFlip(pixels) {
  const {flip, width} = pixels;
  const colors = Array.from({length: 256}, (_, i) => magmaColor(i / 255));
  const block = flip ? Math.round(width / flip.width) : 1;
  return painted(pixels, (pixel, c) => {
    if (!flip) return colors[0][c] / 255;
    const x = pixel % width, y = (pixel - x) / width;
    const at = Math.floor(y / block) * flip.width + Math.floor(x / block);
    return colors[flip.data[4 * at]][c] / 255;
  });
}

function paintCover(cover) {
  const levels = [0, 0.55, 0.8];
  return painted(cover, (pixel) => levels[cover.data[4 * pixel]]);
}

/// A part of `image`, [from, to) in its width, onto a canvas of the same size.
function blit(context, image, from = 0, to = image.width) {
  context.putImageData(image, 0, 0, from, 0, to - from, image.height);
}

function draw(canvas, image) {
  canvas.width = image.width;
  canvas.height = image.height;
  blit(canvas.getContext('2d'), image);
}

/// An image, or nothing, as small as a cell of the matrix but sharp on a fine display.
function drawSmall(canvas, image, {width, height}) {
  const scale = Math.min(1, 240 / Math.max(width, height));
  canvas.width = Math.max(1, Math.round(width * scale));
  canvas.height = Math.max(1, Math.round(height * scale));
  if (!image) return;
  const whole = document.createElement('canvas'), context = canvas.getContext('2d');
  draw(whole, image);
  context.imageSmoothingQuality = 'high';
  context.drawImage(whole, 0, 0, canvas.width, canvas.height);
}

/// Ours, theirs and the difference around a pixel, each 9 x 9 pixels.
function drawLoupe(canvas, pixels, x, y, gain) {
  const side = 9, half = 4;
  canvas.width = 3 * side;
  canvas.height = side;
  const image = new ImageData(3 * side, side);
  const views = [(p, c) => pixels.ours(p, c), (p, c) => pixels.ours(p, c) + pixels.difference(p, c),
                 (p, c) => gain * Math.abs(pixels.difference(p, c))];
  views.forEach((view, i) => {
    for (let at = 0; at < side * side; ++at) {
      const u = x + at % side - half, v = y + Math.floor(at / side) - half;
      const to = 4 * (Math.floor(at / side) * 3 * side + i * side + at % side);
      const inside = u >= 0 && v >= 0 && u < pixels.width && v < pixels.height;
      for (let c = 0; c < 3; ++c) image.data[to + c] = inside ? 255 * view(v * pixels.width + u, c) : 128;
      image.data[to + 3] = 255;
    }
  });
  blit(canvas.getContext('2d'), image);
}

const count = (number) => number.toLocaleString('en');

/// The histogram as SVG in a figure: heights are logarithmic, as one pixel matters among a million.
function drawHistogram(figure, pixels) {
  const {zeros, first, octaves} = histogramOf(pixels);
  const bars = [zeros, ...octaves], wide = 340, high = 90, left = 4, bar = (wide - left) / bars.length;
  const height = (n) => n ? 6 + (high - 6) * Math.log10(n) / Math.log10(Math.max(...bars, 10)) : 0;
  const place = (error) => left + bar * (1 + Math.log2(error) - first);
  const parts = bars.map((n, i) => {
    const from = i ? 2 ** (first + i - 1) : 0, to = 2 ** (first + i);
    const title = i ? `${from.toPrecision(2)} to ${to.toPrecision(2)}: ${count(n)} pixels`
                    : `below ${(pixels.step / 2).toPrecision(2)}: ${count(n)} pixels`;
    return `<rect x="${left + i * bar}" y="${high - height(n)}" width="${bar - 1}" height="${height(n)}">` +
        `<title>${title}</title></rect>`;
  });
  for (let decade = -5; decade <= 0; ++decade) {
    const x = place(10 ** decade);
    if (x < left + bar) continue;
    parts.push(`<path d="M${x} ${high}v4"/><text x="${x}" y="${high + 14}" text-anchor="middle">` +
               `${decade ? `10<tspan dy="-4" font-size="8">${decade}</tspan>` : 1}</text>`);
  }
  parts.push(`<text x="${left}" y="${high + 14}">0</text>`);
  if (pixels.limit) {
    const x = place(pixels.limit);
    parts.push(`<line x1="${x}" x2="${x}" y1="0" y2="${high}"/><text x="${x + 3}" y="9">limit</text>`);
  }
  figure.innerHTML = `<svg viewBox="0 0 ${wide} ${high + 18}" role="img" aria-label="Histogram of errors">` +
      `${parts.join('')}</svg><figcaption>errors of ${count(bars.reduce((a, b) => a + b))} covered pixels, ` +
      `${count(zeros)} below ${(pixels.step / 2).toPrecision(2)}; heights are logarithmic</figcaption>`;
}
