// `node scripts/check-certificate.mjs PLACEMENTS CERTIFICATE`: checks a proof of `npm run prove` against what
// `liftarm placements` lists. Shares nothing with what made the proof; whole numbers only (docs/lower-bound.md).
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

/** Covers as columns with a factor by row, and what the row's sum is at most; rows without that: 1 at least. */
function programmeOf({ edges, runs, covers, rivals, limits }) {
  const most = new Map(rivals.map((_, i) => [edges.length + runs.length + i, 1n]));
  const firstLimit = edges.length + runs.length + rivals.length;
  limits.forEach(({ owned }, i) => {
    most.set(firstLimit + i, BigInt(owned));
  });
  const columns = covers.map(({ parts, edges: covered, runs: on }) => ({
    cost: BigInt(parts),
    factors: new Map([...covered, ...on.map((run) => edges.length + run)].map((row) => [row, 1n])),
  }));
  rivals.forEach((list, i) => {
    for (const c of list) columns[c].factors.set(edges.length + runs.length + i, 1n);
  });
  limits.forEach(({ part }, i) => {
    covers.forEach((cover, c) => {
      if (cover.part === part) columns[c].factors.set(firstLimit + i, BigInt(cover.parts));
    });
  });
  return { columns, most, rows: firstLimit + limits.length };
}

/** What a leaf proves, in units; a text where it has no sense. */
function sumOfLeaf({ columns, most, rows }, { prices, branchPrices }, branches, mayPay) {
  const all = [...prices.map(([, price]) => price), ...branchPrices];
  if (
    branchPrices.length !== branches.length ||
    !all.every((p) => Number.isSafeInteger(p) && p >= 0)
  )
    return 'a leaf has a price that is none';
  const signed = new Map(
    prices.map(([row, price]) => [row, BigInt(most.has(row) ? -price : price)]),
  );
  if (signed.size !== prices.length || prices.some(([row]) => !(row >= 0 && row < rows)))
    return 'a leaf has a row that is none';
  const marks = branches.map(({ sign }, i) => sign * BigInt(branchPrices[i]));
  let sum = 0n;
  for (const [row, price] of signed) sum += price * (most.get(row) ?? 1n);
  branches.forEach(({ limit }, i) => {
    sum += marks[i] * BigInt(limit);
  });
  for (const [c, { cost, factors }] of columns.entries()) {
    let left = cost;
    for (const [row, factor] of factors) left -= factor * (signed.get(row) ?? 0n);
    branches.forEach((branch, i) => {
      if (branch.rows.every((row) => factors.has(row))) left -= marks[i];
    });
    if (left !== cost && !mayPay(c)) return `cover ${c} pays in two pieces`;
    if (left < 0n) sum += left; // a cover is there once at most
  }
  return sum;
}

function faultOfTree(programme, node, branches, piece) {
  if (node?.prices !== undefined) {
    const sum = sumOfLeaf(programme, node, branches, piece.mayPay);
    const proved = typeof sum === 'bigint' && sum > programme.unit * (BigInt(piece.bound) - 1n);
    return typeof sum === 'string' ? sum : proved ? null : `a leaf does not prove ${piece.bound}`;
  }
  const { rows, most, fewer, more } = node ?? {};
  if (!(Array.isArray(rows) && Number.isSafeInteger(most))) return 'a branch is incomplete';
  const below = (child, sign, limit) =>
    faultOfTree(programme, child, [...branches, { rows, sign, limit }], piece);
  return below(fewer, -1n, most) ?? below(more, 1n, most + 1);
}

/** What is wrong with a certificate, in one line; null when its bound holds for the placements. */
export function faultOf(placements, certificate) {
  const programme = { ...programmeOf(placements), unit: BigInt(certificate.unit) };
  if (
    certificate.format !== 'liftarm-certificate' ||
    certificate.version !== 1 ||
    programme.unit < 1n
  )
    return 'this is no certificate, or of another version';
  for (const column of programme.columns) column.cost *= programme.unit;
  const owner = new Map();
  let total = 0;
  for (const [i, { tree, bound }] of certificate.pieces.entries()) {
    const mayPay = (c) => owner.set(c, owner.get(c) ?? i).get(c) === i;
    const fault = faultOfTree(programme, tree, [], { bound, mayPay });
    if (fault !== null) return `piece ${i}: ${fault}`;
    total += bound;
  }
  return total === certificate.bound ? null : `the pieces prove ${total}, not ${certificate.bound}`;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const [placements, certificate] = process.argv
    .slice(2, 4)
    .map((file) => JSON.parse(readFileSync(file, 'utf8')));
  const fault = faultOf(placements, certificate);
  const said = `${certificate.name}: at least ${certificate.bound} beams and axles along lines`;
  console.log(fault ?? said);
  process.exitCode = fault === null ? 0 : 1;
}
