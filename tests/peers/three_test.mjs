// Compares `mesh --convention three` with three.js's TorusKnotGeometry: every vertex and index, in
// order.
//
//     node three_test.mjs LUMAKNOT
//
// LUMAKNOT is the program. Exit status 0: all agree; 1: the differences are printed; 3: no three.js.
import {agree, allAgree, importPeer, ourKnot} from './knots.mjs';

const {TorusKnotGeometry} = await importPeer('three/src/geometries/TorusKnotGeometry.js');

// p, q and then, unless three.js's defaults, radius, tube, segments along and around.
const KNOTS = [
  [2, 3],
  [3, 2],
  [1, 1],
  [1, 20, 1, 0.05, 400, 6],
  [2, 9, 1, 0.1, 300, 12],
  [4, 6],
  [-2, 3],
  [2, -3],
  [-2, -3],
  [5, 3, 1, 0.2, 257, 13],
  [7, 4, 3, 0.25, 768, 40],
  [3, 0],
  [6, 4, 0.5, 0.1, 100, 3],
  [9, 2, 1, 0.1, 3, 3],
  [3, 7, 10, 1, 200, 16],
  [1, 5, 0.01, 0.001, 90, 9],
  [-3, 8, 2.5, 0.3, 128, 24],
  [10, 15, 1, 0.02, 500, 5],
  [2, 2, 1, 0.3, 65, 7],
  [13, 11, 1.7, 0.06, 1000, 10],
];

// Times the radius for positions. three.js narrows its result to float32 and so does the file,
// which is a step between neighbours, 1.2e-7 of 1 and 2.4e-7 of 2, where they disagree.
const TOLERANCE = 1e-6;

function theirKnot(arguments_) {
  const [p, q, radius = 1, tube = 0.4, along = 64, around = 8] = arguments_;
  const {attributes, index} = new TorusKnotGeometry(radius, tube, along, around, p, q);
  return {
    positions: attributes.position.array,
    normals: attributes.normal.array,
    uvs: attributes.uv.array,
    indices: index.array,
  };
}

function ourFlags([p, q, radius, tube, along, around]) {
  const given = radius === undefined ?
      {} :
      {ring: radius, winding: radius / 2, tube, segments: along, sides: around};
  return {convention: 'three', p, q, ...given};
}

function agrees(knot) {
  const radius = knot[2] ?? 1;
  const tolerances =
      {positions: TOLERANCE * radius, normals: TOLERANCE, uvs: TOLERANCE, indices: 0};
  return agree(`(${knot[0]},${knot[1]})`, ourKnot(process.argv[2], ourFlags(knot)), theirKnot(knot),
               tolerances);
}

process.exitCode = allAgree(KNOTS, agrees, 'three') ? 0 : 1;
