// Coverage-guided fuzzing of a function of bytes in Node, as a worker of scripts/fuzz-targets.mjs. V8's own block coverage
// says which input reaches a new place: the fuzzer of npm (Jazzer.js) needs a newer C library than Debian 12 has.
import { Session } from 'node:inspector';
import { createRequire } from 'node:module';
import { parentPort, workerData } from 'node:worker_threads';
import { random } from './random-sketches.mjs';

const { bundle, name, seeds, seconds, seed, maxBytes, current } = workerData;
const MOST_STEPS = 6; // mutations of one input
const TOGETHER = 200; // inputs after which V8 is asked
const TOKENS = {
  mpd: [
    '0 FILE a.ldr',
    '\n',
    '\r\n',
    '1 71 0 0 0 1 0 0 0 1 0 0 0 1 ',
    '32316.dat',
    '0 NOFILE',
    '0 !',
  ],
  obj: [
    'v 0 0 0',
    '\nv 8 0 0',
    '\nl 1 2',
    'l -1 -2',
    '\\\n',
    '# units',
    'curv 0 1 1 2',
    'deg 1',
    'cstype bezier',
  ],
  parts: [
    'Part,Color,Quantity',
    '\n',
    ';',
    '\t',
    '"',
    'sep=;',
    '<ITEM><ITEMID>',
    '</ITEMID>',
    '32316',
    'x',
  ],
  link: ['[', ']', ',', '"', 'null', '1e9', '[0,0,0,8,0,0,0]', '-1', '{"', '":', 's2.', '.0'],
  sketch: [
    ...['{', '}', '[', ']', ',', '"from":', '"to":', '[0,0,0]', '[8,0,0]', '"joints":[', '"axis":'],
    ...[
      '"holeAxis":"x"',
      '"keepOut":',
      '"symmetries":',
      '"range":',
      '"between":',
      '1e308',
      '-0',
      '\\u0000',
    ],
  ],
};

/** What a fuzzer that knows nothing yet begins with. */
const BEGINNINGS = {
  mpd: [
    '0 FILE a.ldr\n0 A\n1 71 0 0 0 0 0 -1 0 1 0 1 0 0 32316.dat\n1 16 0 0 0 1 0 0 0 1 0 0 0 1 b.ldr\n0 NOFILE\n' +
      '0 FILE b.ldr\n1 0x2FF00FF 0 -10 0 0 0 1 -1 0 0 0 0 0 2780.dat\n2 24 0 0 0 1 1 1\n0 STEP\n',
  ],
  obj: [
    '# mm\no f\nv 0 0 0\nv 64 0 0\nv 64 48 0 # c\nl 1 2 3 \\\n 1\ncstype bezier\ndeg 1\ncurv 0 1 1 2\nend\n',
  ],
  parts: [
    'Part,Color,Quantity\n32316,71,4\n"2780",0,8\n',
    'sep=;\nTeil;Anzahl\n32316;3\n',
    '<INVENTORY><ITEM><ITEMID>32316</ITEMID><MINQTY>2</MINQTY></ITEM></INVENTORY>',
    '4x 43857\n32524 8\n',
  ],
  link: [
    '\x01["a",1,"simple",[[0,0,0,8,0,0,0]],[[[0,0,0],[0,0,1],[[0],[1]]]],[[[0,0,0],[1,1,1]]],-1,[["r",1,0,0,3]]]',
    '\x03["a",1,"simple",[[0,0,0,8,0,0,1]],[],[],null,[],[1,[],{},""]]',
    '\x02s1.garbage.0',
  ],
  sketch: [
    '{"format":"technic-sketch","version":2,"name":"a","lines":[{"from":[0,0,0],"to":[8,0,0],"exact":true},' +
      '{"from":[0,0,0],"to":[0,6,0],"holeAxis":"z"}],"joints":[{"at":[0,0,0],"axis":[0,0,1],"kind":"hinge",' +
      '"between":[[0],[1]],"range":[-10,10]}],"symmetries":[{"kind":"reflection","normal":[1,0,0],"offset":3,' +
      '"lines":[0]},{"kind":"translation","vector":[0,4,0],"pairs":[[0,1]]}],"keepOut":[{"min":[2,1,1],' +
      '"max":[8,5,5]}],"ground":0,"colours":{"default":71,"lines":{"1":4}}}',
  ],
};

/** What two lists of stretches, both ascending, have in common. */
function common(a, b) {
  const both = [];
  for (let i = 0, k = 0; i < a.length && k < b.length; ) {
    const from = Math.max(a[i][0], b[k][0]);
    const to = Math.min(a[i][1], b[k][1]);
    if (from < to) {
      both.push([from, to]);
    }
    if (a[i][1] < b[k][1]) {
      i += 1;
    } else {
      k += 1;
    }
  }
  return both;
}

const lengthOf = (stretches) => stretches.reduce((sum, [from, to]) => sum + to - from, 0);

/** The stretches of the bundle's functions that nothing has run yet; V8 tells of one run those that it left out. */
class Coverage {
  #session = new Session();
  #left = new Map();
  /** Functions run, and stretches of them that were found later. */
  places = 0;

  constructor() {
    this.#session.connect();
    this.#session.post('Profiler.enable');
    this.#session.post('Profiler.startPreciseCoverage', { callCount: false, detailed: true });
  }

  /** @returns the functions that were run since it was asked last. */
  #take() {
    let run = [];
    this.#session.post('Profiler.takePreciseCoverage', (error, answer) => {
      if (error) {
        throw error;
      }
      run = answer.result
        .filter(({ url }) => url.includes('readers.cjs'))
        .flatMap(({ functions }) => functions)
        .filter(({ ranges }) => ranges[0].count > 0);
    });
    return run;
  }

  /** @returns whether anything has reached, since it was asked last, what nothing had before. */
  reachedNew() {
    let reached = false;
    for (const { ranges } of this.#take()) {
      const key = `${ranges[0].startOffset} ${ranges[0].endOffset}`;
      const missed = ranges
        .filter(({ count }) => count === 0)
        .map(({ startOffset, endOffset }) => [startOffset, endOffset])
        .sort((a, b) => a[0] - b[0]);
      const before = this.#left.get(key);
      const left = before ? common(before, missed) : missed;
      if (!before || lengthOf(left) < lengthOf(before)) {
        reached = true;
        this.places += 1;
        this.#left.set(key, left);
      }
    }
    return reached;
  }

  /** As it is now: restore() brings it back. */
  save() {
    return { left: new Map(this.#left), places: this.places };
  }

  restore({ left, places }) {
    this.#left = new Map(left);
    this.places = places;
  }
}

class Mutator {
  #r;
  #tokens;

  constructor(tokens) {
    this.#r = random(seed);
    this.#tokens = tokens.map((token) => Buffer.from(token));
  }

  pick(list) {
    return list[this.#r.whole(0, list.length - 1)];
  }

  mutate(bytes, corpus) {
    let made = bytes;
    for (let step = this.#r.whole(1, MOST_STEPS); step > 0; step--) {
      made = this.#step(made, corpus);
    }
    return made.subarray(0, maxBytes);
  }

  #step(bytes, corpus) {
    const at = this.#r.whole(0, bytes.length);
    const end = Math.min(bytes.length, at + this.#r.whole(0, this.#r.pick([1, 4, 40])));
    const put = (middle) => Buffer.concat([bytes.subarray(0, at), middle, bytes.subarray(end)]);
    switch (this.#r.whole(0, 6)) {
      case 0:
        return put(Buffer.from([this.#r.whole(0, 255)]));
      case 1:
        return put(Buffer.alloc(0));
      case 2:
        return put(Buffer.concat([bytes.subarray(at, end), bytes.subarray(at, end)]));
      case 3:
        return put(this.#piece(this.pick(corpus)));
      case 4:
        return put(Buffer.from(`${this.#r.pick([0, 1, -1, 0.5, 7, 255, 1e5, 2 ** 31, 1e300])}`));
      default:
        return put(this.pick(this.#tokens));
    }
  }

  #piece(bytes) {
    const at = this.#r.whole(0, bytes.length);
    return bytes.subarray(at, at + this.#r.whole(0, 80));
  }
}

/** Leaves an input where the parent finds it, should it hang or end the process. */
function note(bytes) {
  const shared = new Uint8Array(current, 8);
  shared.set(bytes);
  const head = new Int32Array(current, 0, 2);
  head[0] = bytes.length;
  Atomics.add(head, 1, 1);
}

const target = createRequire(import.meta.url)(bundle).READERS[name];
const coverage = new Coverage();
const mutator = new Mutator(TOKENS[name]);
const nothing = coverage.save();
const corpus = [];
let tried = 0;

async function attempt(bytes) {
  note(bytes);
  tried += 1;
  await target(new Uint8Array(bytes));
}

/** Those of some inputs that reach new places. Asking V8 takes longer than most inputs: first for all of them. */
async function newOnes(inputs) {
  const before = coverage.save();
  for (const bytes of inputs) {
    await attempt(bytes);
  }
  if (!coverage.reachedNew()) {
    return [];
  }
  coverage.restore(before);
  const found = [];
  for (const bytes of inputs) {
    await attempt(bytes);
    if (coverage.reachedNew()) {
      found.push(bytes);
    }
  }
  return found;
}

async function fuzz() {
  const kept = seeds.map((text) => Buffer.from(text, 'base64'));
  const first = BEGINNINGS[name].map((text) => Buffer.from(text));
  const inOrder = [Buffer.alloc(0), ...first, ...kept].sort((a, b) => a.length - b.length);
  corpus.push(...(await newOnes(inOrder)));
  const end = performance.now() + 1000 * seconds;
  while (performance.now() < end) {
    const inputs = Array.from({ length: TOGETHER }, () =>
      Buffer.from(mutator.mutate(mutator.pick(corpus), corpus)),
    );
    corpus.push(...(await newOnes(inputs)));
  }
}

/** Again from nothing, the short ones first: what a later one reaches already is let go. */
async function least() {
  coverage.restore(nothing);
  const kept = await newOnes(corpus.sort((a, b) => a.length - b.length));
  return kept.map((bytes) => bytes.toString('base64'));
}

let failure = null;
try {
  await fuzz();
} catch (error) {
  const [length] = new Int32Array(current, 0, 1);
  const input = Buffer.from(new Uint8Array(current, 8, length)).toString('base64');
  failure = { message: error.stack ?? String(error), input };
}
const { places } = coverage;
const count = tried;
parentPort.postMessage({ failure, tried: count, places, kept: failure ? null : await least() });
