// `npm run locks -- [options]`: locks a random third of the beams of models, solves the sketches again with another
// seed, as a link does, and once more as the page does when a person forbids a beam: whether every lock is kept, whether
// the models are buildable, and how long it takes.
import { parseArgs } from 'node:util';
import { dice } from './lib/dice.mjs';
import { loadCore } from './lib/load-core.mjs';
import { randomSketch } from './lib/random-sketches.mjs';
import { exitWith, StepError } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';
import { median } from './lib/statistics.mjs';

const USAGE = `npm run locks -- [options]
  --count N    sketches (default 30)
  --first N    number of the first one (default 1); a number is always the same sketch
  --seed N     of the search and of what is locked (default 1)`;

function textOf({ status, text }) {
  if (status !== 'ok') {
    throw new StepError(text);
  }
  return text;
}

/** One search: model, report, layout, and where each beam lies. */
function solve(core, sketch, settings) {
  const begun = performance.now();
  const session = new core.SolverSession(JSON.stringify(sketch), JSON.stringify(settings));
  try {
    textOf(session.opened());
    while (!session.advance(100_000)) {}
    const [model, layout] = [session.modelJson(), session.layoutJson()];
    const ms = performance.now() - begun;
    const { places } = JSON.parse(
      textOf(core.partPlacesJson(model, layout, JSON.stringify(settings))),
    );
    const beams = new Map(places.filter(Boolean).map((place) => [JSON.stringify(place), place]));
    return { ms, layout, beams, report: JSON.parse(session.reportJson()) };
  } finally {
    session.delete();
  }
}

/** `keep` of a sketch from places of parts. */
function keepOf(kept, barred = []) {
  const lines = new Map();
  const onLine = (line) => {
    lines.set(line, lines.get(line) ?? { line });
    return lines.get(line);
  };
  for (const { line, part } of kept) {
    const keep = onLine(line);
    keep.parts = [...(keep.parts ?? []), part];
  }
  for (const { line, part } of barred) {
    const keep = onLine(line);
    const { from, to } = part;
    keep.barred = [...(keep.barred ?? []), { part: part.part, from, to }];
  }
  return [...lines.values()];
}

function shuffled(list, random) {
  const all = [...list];
  for (let i = all.length; i > 1; --i) {
    const j = Math.floor(random() * i);
    [all[i - 1], all[j]] = [all[j], all[i - 1]];
  }
  return all;
}

/** What becomes of one sketch. */
function judge(core, number, seed) {
  const { name, sketch } = randomSketch(number);
  const settings = { seed };
  const first = solve(core, sketch, settings);
  const beams = shuffled(first.beams.values(), dice(1000 * seed + number));
  const locked = beams.slice(0, Math.max(1, Math.round(beams.length / 3)));
  const [other] = beams.slice(locked.length);
  const lost = ({ beams: now }) => locked.filter((place) => !now.has(JSON.stringify(place))).length;
  const wanted = { ...sketch, version: 2, keep: keepOf(locked) };
  const afresh = solve(core, wanted, { seed: seed + 1 });
  const touched = other
    ? solve(
        core,
        { ...wanted, keep: keepOf(locked, [other]) },
        { ...settings, earlier: JSON.parse(first.layout) },
      )
    : null;
  return {
    name,
    beams: first.beams.size,
    locked: locked.length,
    before: first.report.buildable,
    afresh: { lost: lost(afresh), ok: afresh.report.buildable, ms: afresh.ms },
    touched: touched && {
      lost: lost(touched),
      ok: touched.report.buildable,
      ms: touched.ms,
      gone: !touched.beams.has(JSON.stringify(other)),
      grown: touched.report.grown,
    },
  };
}

function print({ name, beams, locked, afresh, touched }) {
  const said = (one) =>
    one ? `${one.lost} lost ${one.ok ? 'buildable' : 'NOT      '} ${Math.round(one.ms)} ms` : '-';
  console.log(
    `${name.padEnd(28)} ${String(locked).padStart(3)} of ${String(beams).padStart(3)}  again: ${said(afresh).padEnd(30)} forbid: ${said(touched)}${touched?.grown ? ' grown' : ''}`,
  );
}

function summary(title, all) {
  const lost = all.reduce((sum, one) => sum + one.lost, 0);
  const ok = all.filter(({ ok: good }) => good).length;
  const times = all.map(({ ms }) => ms);
  const quick = times.filter((ms) => ms <= 200).length;
  console.log(
    `${title}: ${lost} locks lost; ${ok} of ${all.length} buildable (${((100 * ok) / all.length).toFixed(1)} %); median ${Math.round(median(times))} ms, slowest ${Math.round(Math.max(...times))} ms, ${quick} within 200 ms`,
  );
}

async function main() {
  const { values } = parseArgs({
    options: {
      count: { type: 'string', default: '30' },
      first: { type: 'string', default: '1' },
      seed: { type: 'string', default: '1' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  const [count, first] = [wholeNumber('count', values.count), wholeNumber('first', values.first)];
  const seed = wholeNumber('seed', values.seed);
  const core = await loadCore();
  const all = [];
  for (let number = first; number < first + count; ++number) {
    const one = judge(core, number, seed);
    all.push(one);
    print(one);
  }
  summary(
    'solved again with another seed',
    all.map(({ afresh }) => afresh),
  );
  const touched = all.flatMap((one) => (one.touched ? [one.touched] : []));
  summary('one beam forbidden, the rest solved around the locks', touched);
  console.log(`forbidden beams that are gone: ${touched.filter(({ gone }) => gone).length}`);
}

try {
  await main();
} catch (error) {
  exitWith(error);
}
