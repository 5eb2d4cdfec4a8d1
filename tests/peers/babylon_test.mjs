// Compares `mesh --convention babylon` with Babylon.js's CreateTorusKnotVertexData: every vertex and
// index, in order.
//
//     node babylon_test.mjs LUMAKNOT
//
// LUMAKNOT is the program. Exit status 0: all agree; 1: the differences are printed; 3: no Babylon.js.
import {agree, allAgree, importPeer, ourKnot} from './knots.mjs';

const {CreateTorusKnotVertexData} =
    await importPeer('@babylonjs/core/Meshes/Builders/torusKnotBuilder.js');

// p, q and then, unless Babylon.js's defaults, radius, tube, segments along and around.
const KNOTS = [
  [2, 3],
  [3, 2],
  [1, 20, 2, 0.1, 400, 6],
  [2, 9, 2, 0.2, 300, 12],
  [4, 6],
  [-2, 3],
  [2, -3, 1, 0.2, 128, 24],
  [5, 3, 1, 0.2, 257, 13],
  [7, 4, 3, 0.25, 768, 40],
  [4, 5, 0.5, 0.05, 3, 3],
];

// Babylon.js computes in double, and so do we; the file is float32: half a step, 1.2e-7 of a
// coordinate up to 4.
const TOLERANCE = 1e-6;

// Babylon.js calls the segments along radialSegments.
function theirKnot([p, q, radius, tube, radialSegments, tubularSegments]) {
  return CreateTorusKnotVertexData({p, q, radius, tube, radialSegments, tubularSegments});
}

function ourFlags([p, q, radius, tube, along, around]) {
  const given = radius === undefined ?
      {} :
      {ring: radius, winding: radius / 2, tube, segments: along, sides: around};
  return {convention: 'babylon', p, q, ...given};
}

function agrees(knot) {
  return agree(`(${knot[0]},${knot[1]})`, ourKnot(process.argv[2], ourFlags(knot)), theirKnot(knot),
               {positions: TOLERANCE, normals: TOLERANCE, uvs: TOLERANCE, indices: 0});
}

process.exitCode = allAgree(KNOTS, agrees, '@babylonjs/core') ? 0 : 1;
