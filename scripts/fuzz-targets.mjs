// `npm run fuzz:targets -- [NAME...] [--seconds S]`: coverage-guided fuzzing, so many seconds for each target. The core's
// readers (tests/fuzz/*.cpp, clang's libFuzzer): core-model, core-settings, core-sketch. The page's (tests/web/fuzz/
// readers.ts, scripts/lib/reader-fuzzer.mjs): link, mpd, obj, parts, sketch. What reaches new places is kept, least bytes
// first, in tests/fuzz/corpora/NAME.json; what fails, in build/fuzz-finds/. Ends with 1 where anything did.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { Worker } from 'node:worker_threads';
import { build } from 'vite';
import { capture, exitWith, run, StepError, TOP, timed } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';

const CORE = ['core-model', 'core-settings', 'core-sketch'];
const PAGE = ['link', 'mpd', 'obj', 'parts', 'sketch'];
const WORK = resolve(TOP, 'build/fuzz-targets');
const FINDS = resolve(TOP, 'build/fuzz-finds');
const CORPORA = resolve(TOP, 'tests/fuzz/corpora');
const MOST_BYTES = 4096;
/** A kept corpus is part of the repository. */
const MOST_KEPT_BYTES = 150_000;
const HANG_SECONDS = 20;
const MOST_MEGABYTES = 2048;

const { values: options, positionals } = parseArgs({
  options: { seconds: { type: 'string', default: '60' } },
  allowPositionals: true,
});

/** Bundles the page's readers for Node. @returns the file. */
async function bundleReaders() {
  const folder = resolve(WORK, 'readers');
  await build({
    configFile: false,
    root: TOP,
    publicDir: false,
    logLevel: 'error',
    build: {
      ssr: resolve(TOP, 'tests/web/fuzz/readers.ts'),
      outDir: folder,
      emptyOutDir: true,
      target: 'node20',
      rollupOptions: { output: { format: 'cjs', entryFileNames: 'readers.cjs' } },
    },
    ssr: { noExternal: true },
  });
  return resolve(folder, 'readers.cjs');
}

async function readyCore(names) {
  await run('cmake', ['--preset', 'fuzz']);
  const targets = names.map((name) => name.replace('core-', 'fuzz_'));
  await run('cmake', ['--build', '--preset', 'fuzz', '--target', ...targets]);
}

function keptInputs(name) {
  const file = resolve(CORPORA, `${name}.json`);
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : [];
}

function unpack(name, folder) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const kept = keptInputs(name);
  for (const text of kept) {
    const bytes = Buffer.from(text, 'base64');
    writeFileSync(resolve(folder, createHash('sha1').update(bytes).digest('hex')), bytes);
  }
  return kept.length;
}

/** @returns how many are kept. */
function pack(name, inputs) {
  const inOrder = inputs.sort((a, b) => a.length - b.length || Buffer.compare(a, b));
  const texts = [];
  let left = MOST_KEPT_BYTES;
  for (const bytes of inOrder) {
    const text = bytes.toString('base64');
    left -= text.length + 6;
    if (left < 0) {
      break;
    }
    texts.push(text);
  }
  mkdirSync(CORPORA, { recursive: true });
  const rows = texts.map((text) => `  "${text}"`).join(',\n');
  writeFileSync(resolve(CORPORA, `${name}.json`), `[\n${rows}\n]\n`);
  return texts.length;
}

/** What libFuzzer prints at its end: inputs tried, and places reached. */
function figuresOf(output) {
  const tried = /stat::number_of_executed_units:\s*(\d+)/.exec(output)?.[1];
  const places = [...output.matchAll(/\bcov: (\d+)/g)].at(-1)?.[1];
  return `${tried ?? 'unknown'} inputs tried, ${places ?? 'unknown'} places reached`;
}

function keep(name, kind, bytes, message) {
  mkdirSync(FINDS, { recursive: true });
  writeFileSync(resolve(FINDS, `${name}-${kind}`), bytes);
  writeFileSync(resolve(FINDS, `${name}.txt`), message);
  console.error(message.split('\n').slice(-30).join('\n'));
}

/** @returns whether nothing failed. */
async function fuzzCore(name, seconds) {
  const command = resolve(TOP, 'build/fuzz/tests', name.replace('core-', 'fuzz_'));
  const corpus = resolve(WORK, 'corpora', name);
  const before = unpack(name, corpus);
  mkdirSync(FINDS, { recursive: true });
  const limits = [`-max_len=${MOST_BYTES}`, `-timeout=${HANG_SECONDS}`];
  const { code, stdout, stderr } = capture(command, [
    corpus,
    ...limits,
    `-rss_limit_mb=${MOST_MEGABYTES}`,
    `-max_total_time=${seconds}`,
    '-print_final_stats=1',
    `-artifact_prefix=${FINDS}/${name}-`,
  ]);
  const output = `${stdout}${stderr}`;
  const failed = code !== 0;
  if (failed) {
    keep(name, 'log', '', output);
  }
  const least = resolve(WORK, 'corpora', `${name}-least`);
  rmSync(least, { recursive: true, force: true });
  mkdirSync(least, { recursive: true });
  capture(command, [least, corpus, ...limits, '-merge=1']);
  const files = readdirSync(least).map((file) => readFileSync(resolve(least, file)));
  const kept = failed ? before : pack(name, files);
  console.log(`${name}: ${figuresOf(output)}; kept inputs: ${before} before, ${kept} now`);
  return !failed;
}

/** A worker that fuzzes; ended where one input takes too long. */
function inWorker(data) {
  const current = new SharedArrayBuffer(8 + MOST_BYTES);
  const worker = new Worker(resolve(TOP, 'scripts/lib/reader-fuzzer.mjs'), {
    workerData: { ...data, current, maxBytes: MOST_BYTES },
    resourceLimits: { maxOldGenerationSizeMb: MOST_MEGABYTES },
  });
  const head = new Int32Array(current, 0, 2);
  const input = () => Buffer.from(new Uint8Array(current, 8, head[0])).toString('base64');
  return new Promise((done) => {
    let last = -1;
    const watch = setInterval(() => {
      if (Atomics.load(head, 1) === last) {
        end({ failure: { message: `hangs for ${HANG_SECONDS} s`, input: input() }, tried: last });
      }
      last = Atomics.load(head, 1);
    }, 1000 * HANG_SECONDS);
    const end = (answer) => {
      clearInterval(watch);
      worker.terminate();
      done(answer);
    };
    worker.on('message', end);
    worker.on('error', (error) =>
      end({ failure: { message: error.stack, input: input() }, tried: last }),
    );
  });
}

/** @returns whether nothing failed. */
async function fuzzPage(name, seconds, bundle) {
  const seeds = keptInputs(name);
  const seed = (Date.now() % 1e9) + 1;
  const { failure, tried, places, kept } = await inWorker({ bundle, name, seeds, seconds, seed });
  if (failure) {
    keep(name, 'input', Buffer.from(failure.input, 'base64'), failure.message);
  }
  const now = kept
    ? pack(
        name,
        kept.map((text) => Buffer.from(text, 'base64')),
      )
    : seeds.length;
  console.log(
    `${name}: ${tried} inputs tried, ${places ?? 'unknown'} places reached; ` +
      `kept inputs: ${seeds.length} before, ${now} now`,
  );
  return !failure;
}

async function main() {
  const seconds = wholeNumber('seconds', options.seconds);
  const names = positionals.length > 0 ? positionals : [...CORE, ...PAGE];
  const unknown = names.find((name) => ![...CORE, ...PAGE].includes(name));
  if (unknown !== undefined) {
    throw new StepError(`no target '${unknown}'; there are: ${[...CORE, ...PAGE].join(', ')}`);
  }
  const core = names.filter((name) => CORE.includes(name));
  if (core.length > 0) {
    await timed('build of the core’s targets', () => readyCore(core));
  }
  const bundle = core.length < names.length ? await bundleReaders() : '';
  const failed = [];
  for (const name of names) {
    const work = CORE.includes(name) ? fuzzCore(name, seconds) : fuzzPage(name, seconds, bundle);
    if (!(await work)) {
      failed.push(name);
    }
  }
  if (failed.length > 0) {
    throw new StepError(`failed: ${failed.join(', ')}; inputs are in build/fuzz-finds/`);
  }
}

main().catch(exitWith);
