// The figures of DESIGN 5b over many models: no packages, no files, so that they can be tested.

const sum = (values) => values.reduce((total, value) => total + value, 0);
const share = (part, whole) => (whole > 0 ? (100 * part) / whole : null);
const mean = (values) => (values.length > 0 ? sum(values) / values.length : null);

/** All figures of a report's `wellBuilt` in one object, each named as its item names it, beside which items hold. */
export function figuresOf(wellBuilt) {
  const figures = Object.assign({}, ...wellBuilt.items.map((item) => item.figures));
  const items = Object.fromEntries(
    wellBuilt.items.map(({ id, ok, applies }) => [id, { ok, applies }]),
  );
  return { passed: wellBuilt.passed, of: wellBuilt.of, items, ...figures };
}

/**
 * What "How it is judged" asks of all models together. Shares in per cent; null where no model has a say.
 * @param {{buildable: boolean, figures: Record<string, any>, beams: number, bound: number | null,
 *   seconds: number | null}[]} runs
 */
export function totals(runs) {
  const figures = runs.map((run) => run.figures);
  const over = (key) => sum(figures.map((figure) => figure[key] ?? 0));
  const where = (key) => figures.filter((figure) => figure[key] === 1);
  const bounded = runs.filter(({ bound }) => bound > 0);
  const symmetric = figures.filter(({ items }) => items.symmetric.applies);
  return {
    models: runs.length,
    buildable: share(runs.filter(({ buildable }) => buildable).length, runs.length),
    passed: mean(figures.map(({ passed }) => passed)),
    nakedHeads: share(over('nakedHeads'), over('heads')),
    nakedPinHeads: share(over('nakedPinHeads'), over('pinHeads')),
    idleArms: share(over('idleArms'), over('arms')),
    beamsOnOneAxis: share(over('beamsOnOneAxis'), sum(runs.map(({ beams }) => beams))),
    flatBases: where('flatBase').length,
    modelsBelowBase: figures.filter(({ belowBase }) => belowBase > 0).length,
    modelsOnUnevenFeet: figures.filter(({ liftedFeet }) => liftedFeet > 0).length,
    couldStand: where('couldStand').length,
    fallOver: where('fallsOver').length,
    noFreedom: share(
      figures.filter((figure) => figure.freedomsBeyondJoints === 0).length,
      runs.length,
    ),
    meanLayer: mean(figures.map((figure) => figure.meanLayer).filter(Number.isFinite)),
    symmetricDrawings: symmetric.length,
    symmetric: share(symmetric.filter(({ items }) => items.symmetric.ok).length, symmetric.length),
    kinds: mean(figures.map(({ kinds }) => kinds)),
    bricks: over('parts'),
    beams: sum(runs.map(({ beams }) => beams)),
    beamsOverBound: mean(bounded.map(({ beams, bound }) => (100 * (beams - bound)) / bound)),
    seconds: sum(runs.map(({ seconds }) => seconds ?? 0)),
    secondsMost: Math.max(0, ...runs.map(({ seconds }) => seconds ?? 0)),
  };
}

/** The acceptance list: what is asked, what is there. `null` figures hold: nothing is asked of such models. */
export function verdicts(all) {
  const rows = [
    ['buildable', all.buildable, '100 %', (v) => v === 100],
    ['heads that sit in nothing', all.nakedHeads, 'under 2 %', (v) => v < 2],
    ['beams on one axis outside joints', all.beamsOnOneAxis, '0 %', (v) => v === 0],
    ['models with parts below a flat base', all.modelsBelowBase, '0', (v) => v === 0],
    ['models with feet in the air', all.modelsOnUnevenFeet, '0', (v) => v === 0],
    ['models that fall over and need not', all.fallOver, '0', (v) => v === 0],
    ['no freedom beyond the joints', all.noFreedom, 'at least 90 %', (v) => v >= 90],
    ['mean layer deviation', all.meanLayer, 'under 0.35', (v) => v < 0.35],
    ['symmetric of symmetric drawings', all.symmetric, 'at least 95 %', (v) => v >= 95],
    ['beams over the bound, mean', all.beamsOverBound, 'at most 8 %', (v) => v <= 8],
  ];
  return rows.map(([title, value, asked, holds]) => ({
    title,
    value,
    asked,
    ok: value === null || holds(value),
  }));
}
