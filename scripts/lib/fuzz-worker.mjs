// A worker of `npm run fuzz -- --module`: tries the seeds it is told, and says what came of each. A trap in WebAssembly
// leaves its memory as it is, so the next seed gets a module of its own.
import { parentPort, workerData } from 'node:worker_threads';
import { tryCase } from './fuzz-case.mjs';
import { moduleDoor } from './fuzz-doors.mjs';
import { loadReaders } from './fuzz-round-trips.mjs';

const readers = await loadReaders();
let door = await moduleDoor();

parentPort.on('message', async (seed) => {
  try {
    parentPort.postMessage({ seed, what: await tryCase({ ...workerData, door, readers }, seed) });
  } catch (error) {
    door = await moduleDoor();
    parentPort.postMessage({ seed, what: 'failed', message: error.message ?? `${error}` });
  }
});
parentPort.postMessage({});
