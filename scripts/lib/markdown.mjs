// Tables for docs/: no packages, no files, so that they can be tested.

/** A table of texts; all columns but the first are set right. */
export function markdownTable(titles, rows) {
  const line = (cells) => `| ${cells.join(' | ')} |`;
  const rule = titles.map((_, i) => (i === 0 ? '---' : '---:'));
  return [line(titles), line(rule), ...rows.map(line)].join('\n');
}

/** Beams, bricks, gaps, collisions and failed connections of one run, as in the design's section 8. */
export function figures({ beams, bricks, gaps, collisions, failedConnections }) {
  return [beams, bricks, gaps, collisions, failedConnections].join(' / ');
}

/** Seconds with as many digits as mean something. */
export function secondsText(seconds) {
  if (seconds === null || seconds === undefined) {
    return '-';
  }
  return seconds < 10 ? seconds.toFixed(2) : seconds.toFixed(0);
}

/** The mean of ratios; null without any. */
export function geometricMean(values) {
  const usable = values.filter((value) => Number.isFinite(value) && value > 0);
  if (usable.length === 0) {
    return null;
  }
  return Math.exp(usable.reduce((sum, value) => sum + Math.log(value), 0) / usable.length);
}
