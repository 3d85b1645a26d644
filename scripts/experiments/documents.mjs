// Writes what an experiment found: a page, its table as CSV and its plots, which are the same on every machine; and in
// times/ what is not: seconds, with machine and commit.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { markdownTable, secondsText } from '../lib/markdown.mjs';
import { TOP } from '../lib/run.mjs';
import { machine } from '../lib/solve.mjs';
import { csvField } from '../lib/statistics.mjs';
import { svgOf } from './plots.mjs';

function csvOf({ titles, rows }) {
  return `${[titles, ...rows].map((row) => row.map(csvField).join(',')).join('\n')}\n`;
}

function tableText({ caption, titles, rows }) {
  return `${caption ? `**${caption}**\n\n` : ''}${markdownTable(titles, rows)}`;
}

/** The commit measured, with a mark where files differ from it. */
export function commit() {
  const git = (...args) =>
    execFileSync('git', args, { cwd: TOP, encoding: 'utf8', stdio: 'pipe' }).trim();
  try {
    const dirty = git('status', '--porcelain', '--', 'core', 'scripts') !== '';
    return `${git('rev-parse', '--short=10', 'HEAD')}${dirty ? ' with changes' : ''}`;
  } catch {
    return 'unknown';
  }
}

async function writePlots(folder, name, plots) {
  const links = [];
  for (const { key, caption, spec } of plots) {
    const file = `${name}-${key}.svg`;
    writeFileSync(resolve(folder, file), await svgOf(spec));
    links.push(`![${caption}](${file})`);
  }
  return links;
}

async function writeTimes(folder, { name, title }, { times, timePlots = [], own = true }) {
  const into = resolve(folder, 'times');
  mkdirSync(into, { recursive: true });
  const rows = times.map(({ run, seconds }) => [run, secondsText(seconds)]);
  const plots = await writePlots(into, name, timePlots);
  const sum = times.reduce((total, { seconds }) => total + seconds, 0);
  writeFileSync(
    resolve(into, `${name}.md`),
    `${[
      `# ${title}: seconds`,
      `${machine()}; ${own ? `commit ${commit()}` : 'a command built elsewhere'}. Seconds of the processor, one thread, the search alone: ${secondsText(sum)} in all.`,
      ...plots,
      markdownTable(['run', 'seconds'], rows),
    ].join('\n\n')}\n`,
  );
  writeFileSync(resolve(into, `${name}.csv`), csvOf({ titles: ['run', 'seconds'], rows }));
}

/**
 * @param {string} folder
 * @param {{name: string, title: string, shows: string, differs: string}} experiment
 * @param {{tables: object[], csv: object, plots?: object[], text?: string[]}} found
 * @param {{times: object[], timePlots?: object[], own?: boolean}} clocked whose command: our own, of this commit
 * @param {string} how the command that makes it
 */
export async function writeExperiment(folder, experiment, { found, clocked, how }) {
  mkdirSync(folder, { recursive: true });
  const { name, title, shows, differs } = experiment;
  const plots = await writePlots(folder, name, found.plots ?? []);
  const page = [
    `# ${title}`,
    `Made by \`${how}\`; do not edit. Seconds, machine and commit: [times/${name}.md](times/${name}.md); all figures: [${name}.csv](${name}.csv).`,
    `**What it shows.** ${shows}`,
    `**Where this differs from the paper.** ${differs}`,
    ...plots,
    ...found.tables.map(tableText),
    ...(found.text ?? []),
  ];
  writeFileSync(resolve(folder, `${name}.md`), `${page.join('\n\n')}\n`);
  writeFileSync(resolve(folder, `${name}.csv`), csvOf(found.csv));
  await writeTimes(folder, experiment, clocked);
}

/** The list of all experiments, for docs/experiments/README.md. */
export function writeIndex(folder, experiments) {
  const rows = experiments.map(({ name, title, shows }) => {
    const made = existsSync(resolve(folder, `${name}.md`));
    return made ? `- [${title}](${name}.md): ${shows}` : `- ${title} (not made yet): ${shows}`;
  });
  const text = `# Experiments

The evaluation of Xu, Hui, Fu and Zhang, "Computational LEGO Technic Design" (ACM TOG 38(6), 2019), figure by figure, with
our search beside their method and its rivals. \`npm run experiments\` makes all of it, \`npm run experiments NAME\` one page,
\`--quick\` a small part of each in two minutes. Seeds are fixed, so that every file here is the same on any machine;
what is not, seconds, stands in [times/](times/) with machine and commit.

${rows.join('\n')}
`;
  writeFileSync(resolve(folder, 'README.md'), text);
}
