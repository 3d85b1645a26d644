// What ADMesh, which compares corners exactly, would have to mend in an STL file (Debian: admesh).
import { spawnSync } from 'node:child_process';
import { StepError } from './run.mjs';

/** Rows of its table that must be 0; parts that touch are shells of their own. */
const FAULTS = [
  'Total disconnected facets',
  'Degenerate facets',
  'Edges fixed',
  'Facets removed',
  'Facets added',
  'Facets reversed',
  'Backwards edges',
];

/** @returns {string[]} the rows that are not 0. */
export function mendsOf(path) {
  const { error, stdout, status } = spawnSync(
    'admesh',
    // Nothing by nearness: that would mend in silence what an exact reader stumbles over.
    ['--exact', '--normal-directions', '--normal-values', '--fill-holes', path],
    { encoding: 'utf8', maxBuffer: 64 << 20 },
  );
  if (error || status !== 0) {
    throw new StepError('admesh is missing, or cannot read the file (Debian: admesh)');
  }
  const rows = stdout.split('\n').map((row) => row.trim());
  const counts = FAULTS.map((fault) => {
    const row = rows.find((text) => text.startsWith(fault));
    if (!row) {
      throw new StepError(`admesh says nothing of: ${fault}`);
    }
    return { row, count: Number(/:\s*(\d+)/.exec(row)?.[1]) };
  });
  return counts.filter(({ count }) => count !== 0).map(({ row }) => row);
}
