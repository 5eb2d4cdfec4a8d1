// Checks glTF files with Khronos' validator (npm's gltf-validator).
//
//     LUMAKNOT_PEERS=FOLDER node validate_gltf.mjs FILE...
//
// FOLDER holds node_modules/gltf-validator. Prints each message. Exits with 1 when a file has
// an error or a warning, 2 on wrong use, 3 when the validator is missing.
import {readFile} from 'node:fs/promises';
import {createRequire} from 'node:module';
import path from 'node:path';

const SEVERITIES = ['error', 'warning', 'information', 'hint'];

function loadValidator() {
  const folder = process.env.LUMAKNOT_PEERS;
  if (!folder) throw new Error('LUMAKNOT_PEERS must name the folder with node_modules');
  return createRequire(path.resolve(folder, 'here.js'))('gltf-validator');
}

// The validator's report on `file`, with the files that it refers to.
async function reportOn(validator, file) {
  const referenced = (uri) => readFile(path.resolve(path.dirname(file), decodeURIComponent(uri)));
  return validator.validateBytes(new Uint8Array(await readFile(file)), {
    uri: path.basename(file),
    maxIssues: 100,
    externalResourceFunction: async (uri) => new Uint8Array(await referenced(uri)),
  });
}

// Whether `file` has neither errors nor warnings.
async function isGood(validator, file) {
  const {issues} = await reportOn(validator, file);
  for (const {severity, code, pointer, message} of issues.messages) {
    console.log(`${file}: ${SEVERITIES[severity]} ${code} at ${pointer}: ${message}`);
  }
  const {numErrors, numWarnings, numInfos, numHints} = issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ` +
              `${numInfos + numHints} remarks`);
  return numErrors + numWarnings === 0;
}

async function main(files) {
  if (files.length === 0) {
    console.error('usage: validate_gltf.mjs FILE...');
    return 2;
  }
  let validator;
  try {
    validator = loadValidator();
  } catch (error) {
    console.error(`gltf-validator is not installed: ${error.message}`);
    return 3;
  }
  let good = true;
  for (const file of files) {
    const verdict = await isGood(validator, file).catch((error) => {
      console.log(`${file}: ${error}`);
      return false;
    });
    good = good && verdict;
  }
  return good ? 0 : 1;
}

process.exitCode = await main(process.argv.slice(2));
