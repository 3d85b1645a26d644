import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test } from 'vitest';
import { byUse } from '../../scripts/experiments/brick-sets.mjs';
import { writeExperiment, writeIndex } from '../../scripts/experiments/documents.mjs';
import { EXPERIMENTS } from '../../scripts/experiments/list.mjs';
import { barPlot, linePlot, svgOf } from '../../scripts/experiments/plots.mjs';

let folder = '';

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'liftarm-experiments-'));
});

afterEach(() => rmSync(folder, { recursive: true }));

const POINTS = [
  { x: 1, y: 2, series: 'ours' },
  { x: 2, y: 3, series: 'ours' },
  { x: 1, y: 4, series: 'paper' },
];
const ONE = { name: 'one', title: 'One', shows: 'Something.', differs: 'Nothing.' };
const FOUND = {
  tables: [{ titles: ['a', 'b'], rows: [['x', 1]] }],
  csv: { titles: ['a', 'b'], rows: [['x, y', 1]] },
  plots: [{ key: 'p', caption: 'P', spec: linePlot(POINTS, { x: 'n', y: 'beams' }) }],
};

async function write(seconds) {
  const clocked = { times: [{ run: 'a', seconds }] };
  await writeExperiment(folder, ONE, { found: FOUND, clocked, how: 'npm run experiments one' });
  return ['one.md', 'one.csv', 'one-p.svg'].map((name) => readFileSync(join(folder, name), 'utf8'));
}

test('a plot is the same each time and has a mark for each series', async () => {
  const spec = () => linePlot(POINTS, { x: 'n', y: 'beams' });
  const svg = await svgOf(spec());
  expect(await svgOf(spec())).toBe(svg);
  for (const text of ['ours', 'paper', 'beams']) {
    expect(svg).toContain(`>${text}<`);
  }
});

test('a plot of bars has a bar for each figure', async () => {
  const svg = await svgOf(barPlot(POINTS, { x: 'n', y: 'beams' }));
  expect(svg.match(/aria-roledescription="bar"/g)).toHaveLength(POINTS.length);
});

test('results are the same whatever time they took; times stand apart', async () => {
  const first = await write(4711);
  const times = readFileSync(join(folder, 'times/one.md'), 'utf8');
  expect(await write(77)).toEqual(first);
  expect(first.join()).not.toContain('4711');
  expect(times).toContain('4711');
  expect(times).toContain('commit');
});

test('a comma in a figure does not part it in the CSV file', async () => {
  const [, csv] = await write(1);
  expect(csv).toBe('a,b\n"x, y",1\n');
});

test('every experiment says what it shows and where it differs, under a name of its own', () => {
  for (const { shows, differs, run } of EXPERIMENTS) {
    expect(shows.length).toBeGreaterThan(40);
    expect(differs.length).toBeGreaterThan(20);
    expect(run).toBeTypeOf('function');
  }
  expect(new Set(EXPERIMENTS.map(({ name }) => name)).size).toBe(EXPERIMENTS.length);
});

test('the index leads to every experiment that was made, and names the others', async () => {
  await write(1);
  writeIndex(folder, [ONE, ...EXPERIMENTS]);
  expect(existsSync(join(folder, 'README.md'))).toBe(true);
  const text = readFileSync(join(folder, 'README.md'), 'utf8');
  expect(text).toContain('[One](one.md)');
  for (const { name, title } of EXPERIMENTS) {
    expect(text).toContain(title);
    expect(text).not.toContain(`(${name}.md)`);
  }
});

test('the beam used most comes first, of equals the lower number', () => {
  expect(byUse(['b', 'a', 'c', 'b', 'a'])).toEqual([
    ['a', 2],
    ['b', 2],
    ['c', 1],
  ]);
});
