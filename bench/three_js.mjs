// Times three.js's TorusKnotGeometry.
//   node three_js.mjs FOLDER SEGMENTSxSIDES...
// FOLDER is where npm installed three. Prints one JSON object: three's revision, and for each grid
// its counts and the milliseconds of its runs after a warm-up.
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const kWarmUp = {milliseconds: 500, runs: 3};
const kMeasured = {milliseconds: 800, runs: 5};

const [folder, ...grids] = process.argv.slice(2);
const module = resolve(folder, 'node_modules/three/build/three.module.js');
const three = await import(pathToFileURL(module));

// The milliseconds of each run, until there are both enough of them and enough time.
function run(segments, sides, least) {
  const times = [];
  let geometry;
  for (const start = performance.now();
       times.length < least.runs || performance.now() - start < least.milliseconds;) {
    const before = performance.now();
    geometry = new three.TorusKnotGeometry(1, 0.4, segments, sides, 2, 3);
    times.push(performance.now() - before);
  }
  return {times, geometry};
}

function measure(grid) {
  const [segments, sides] = grid.split('x').map(Number);
  run(segments, sides, kWarmUp);
  const {times, geometry} = run(segments, sides, kMeasured);
  const triangles = geometry.index.count / 3;
  const sorted = [...times].sort((a, b) => a - b);
  return {
    triangles,
    vertices: geometry.attributes.position.count,
    median_ms: sorted[Math.floor(sorted.length / 2)],
    min_ms: sorted[0],
    runs: times.length,
  };
}

console.log(JSON.stringify({revision: three.REVISION, grids: grids.map(measure)}));
