// Shared by the tests of other libraries' knots: our mesh, theirs, and the differences.
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

function peersFolder() {
  const cache = process.env.XDG_CACHE_HOME || path.join(os.homedir(), '.cache');
  return process.env.LUMAKNOT_PEERS || path.join(cache, 'lumaknot/peers');
}

// The module in the file `name` of a package of scripts/install-peers. Exits with 3 if absent.
export async function importPeer(name) {
  const file = path.join(peersFolder(), 'node_modules', name);
  if (!existsSync(file)) {
    console.error(`${file} not found; install with scripts/install-peers`);
    process.exit(3);
  }
  return import(pathToFileURL(file));
}

function peerVersion(name) {
  const file = path.join(peersFolder(), 'node_modules', name, 'package.json');
  return JSON.parse(readFileSync(file, 'utf8')).version;
}

const PROPERTIES = ['x', 'y', 'z', 'nx', 'ny', 'nz', 's', 't'];

// The lines of a PLY file's header, and where the data begins.
function headerOf(bytes) {
  const mark = 'end_header\n';
  const end = bytes.indexOf(mark);
  if (end < 0) throw new Error('no end_header in the .ply file');
  return {lines: bytes.toString('latin1', 0, end).split('\n'), begin: end + mark.length};
}

function countOf(lines, element) {
  const line = lines.find((each) => each.startsWith(`element ${element} `));
  return Number(line.split(' ')[2]);
}

// The triangles after the vertices: a byte, which is 3, and three indices each.
function trianglesOf(bytes, begin, count) {
  const indices = new Uint32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const at = begin + 13 * i;
    if (bytes[at] !== 3) throw new Error(`face ${i} has ${bytes[at]} corners`);
    for (let k = 0; k < 3; ++k) indices[3 * i + k] = bytes.readUInt32LE(at + 1 + 4 * k);
  }
  if (bytes.length !== begin + 13 * count) throw new Error('bytes are left over');
  return indices;
}

// {positions, normals, uvs, indices} of a binary PLY file, as typed arrays.
function readPly(file) {
  const bytes = readFileSync(file);
  const {lines, begin} = headerOf(bytes);
  const names = lines.filter((line) => line.startsWith('property float '))
                    .map((line) => line.split(' ')[2]);
  if (!lines.includes('format binary_little_endian 1.0') || `${names}` !== `${PROPERTIES}`) {
    throw new Error(`not the .ply file that lumaknot writes: ${lines}`);
  }
  const count = countOf(lines, 'vertex');
  const column = (first, width) => Float32Array.from(
      {length: width * count},
      (_, i) => bytes.readFloatLE(begin + 32 * Math.floor(i / width) + 4 * (first + i % width)));
  return {
    positions: column(0, 3),
    normals: column(3, 3),
    uvs: column(6, 2),
    indices: trianglesOf(bytes, begin + 32 * count, countOf(lines, 'face')),
  };
}

// The mesh that `program` builds with these arguments.
export function ourKnot(program, options) {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'lumaknot-'));
  try {
    const file = path.join(folder, 'knot.ply');
    const flags = Object.entries(options).flatMap(([key, value]) => [`--${key}=${value}`]);
    execFileSync(program, ['mesh', ...flags, '--quiet', '-o', file], {stdio: 'pipe'});
    return readPly(file);
  } finally {
    rmSync(folder, {recursive: true});
  }
}

// The largest difference of two arrays, and where: infinite unless their lengths agree and all
// numbers are finite.
function worst(ours, theirs) {
  if (ours.length !== theirs.length) return {at: -1, size: Infinity};
  let at = 0, size = 0;
  for (let i = 0; i < ours.length; ++i) {
    const difference = Math.abs(ours[i] - theirs[i]);
    if (Number.isNaN(difference)) return {at: i, size: Infinity};
    if (difference > size) [at, size] = [i, difference];
  }
  return {at, size};
}

// Compares attribute by attribute and prints; whether all are within `tolerances`, by name.
export function agree(label, ours, theirs, tolerances) {
  let good = true;
  const sizes = [];
  for (const [name, tolerance] of Object.entries(tolerances)) {
    const {at, size} = worst(ours[name], theirs[name]);
    sizes.push(`${name} ${size.toExponential(1)}`);
    if (size <= tolerance) continue;
    good = false;
    console.log(`${label}: ${name}[${at}] of ${ours[name].length}, ${theirs[name].length}: ours ` +
                `${ours[name][at]}, theirs ${theirs[name][at]}, beyond ${tolerance}`);
  }
  console.log(`${label}: ${ours.positions.length / 3} vertices, ${ours.indices.length / 3} ` +
              `triangles; largest differences: ${sizes.join(', ')}`);
  return good;
}

// Whether `agrees(knot)` for all knots; prints errors and the count.
export function allAgree(knots, agrees, name) {
  const good = knots.filter((knot) => {
    try {
      return agrees(knot);
    } catch (error) {
      console.log(`(${knot[0]},${knot[1]}): ${error.message}`);
      return false;
    }
  });
  console.log(`${good.length} of ${knots.length} knots are those of ${name} ${peerVersion(name)}`);
  return good.length === knots.length;
}
