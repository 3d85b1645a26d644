// Numbers of the evaluation: no packages, no files, so that they can be tested.

/** The middle of the finite numbers; null when there are none. */
export function median(values) {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
  if (sorted.length === 0) {
    return null;
  }
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/** The greatest finite number; null when there are none. */
export function greatest(values) {
  const finite = values.filter(Number.isFinite);
  return finite.length === 0 ? null : Math.max(...finite);
}

/** The least finite number; null when there are none. */
export function least(values) {
  const finite = values.filter(Number.isFinite);
  return finite.length === 0 ? null : Math.min(...finite);
}

/**
 * One row of the table from all runs of one sketch.
 * @param {string} sketch
 * @param {{ok: boolean, report: Record<string, any> | null, wallSeconds: number, failure: string}[]} runs
 */
export function summarise(sketch, runs) {
  const field = (key) => runs.map(({ report }) => report?.[key]);
  const seconds = runs.map(({ report }) => report?.seconds?.total);
  return {
    sketch,
    runs: runs.length,
    ok: runs.filter(({ ok }) => ok).length,
    beamsMin: least(field('beams')),
    beamsMedian: median(field('beams')),
    bound: greatest(field('beamsLowerBound')),
    bricks: median(field('bricks')),
    // The worst over the seeds: one bad seed must show.
    gaps: greatest(field('gaps')),
    collisions: greatest(field('collisions')),
    failed: greatest(field('failedConnections')),
    loose: greatest(field('freedomsBeyondJoints')),
    rigid: runs.filter(({ ok, report }) => ok && report?.freedomsBeyondJoints === 0).length,
    seconds: median(seconds),
    secondsMax: greatest(seconds),
    processorMax: greatest(runs.map(({ report }) => report?.seconds?.processor)),
    wallSeconds: median(runs.map(({ wallSeconds }) => wallSeconds)),
    failure: runs.find(({ ok }) => !ok)?.failure ?? '',
  };
}

/** How many per cent the median number of beams lies above the bound; null without a bound. */
export function beamsOverBound({ beamsMedian, bound }) {
  return beamsMedian === null || !bound ? null : (100 * (beamsMedian - bound)) / bound;
}

/** A report whose gaps are counted as the paper does: whether or not a spacer fills them. */
export function inPapersCount(report) {
  return { ...report, gaps: report.gaps + report.filledGaps };
}

/** A field of a CSV file (RFC 4180). */
export function csvField(value) {
  const text = value === null || value === undefined ? '' : String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
