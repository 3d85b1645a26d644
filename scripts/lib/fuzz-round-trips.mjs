// What `npm run fuzz` takes out of the program and in again: a sketch by its link, a model by its .mpd file.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { loadTypeScript } from './load-typescript.mjs';
import { TOP } from './run.mjs';

const NEAR = 0.01; // modules
const OTHER_WAY = [-1, 0, 0, 0, -1, 0, 0, 0, -1]; // along the same axis

const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
const turned = (m, v) => [0, 3, 6].map((i) => m[i] * v[0] + m[i + 1] * v[1] + m[i + 2] * v[2]);

/** What a part fills and where it can be held, in its own place: alike in two places, it is the same to a builder. */
export function outlineOf({ id, solid, features }) {
  const prisms = solid.map(({ from, to, axis, radius, halfThickness }) => ({
    points: [from, to],
    axis,
    kind: `${radius} ${halfThickness}`,
  }));
  const ends = features.map(({ kind, center, axis, length, wing }) => ({
    points: [center],
    axis,
    kind: `${kind} ${length} ${wing ? 'wing' : ''}`,
  }));
  return { id, items: [...prisms, ...ends] };
}

/** Whether two turns of a part leave it where it is: half a turn of a beam about its middle does. */
export function looksAlike(outline, a, b) {
  const placed = (turn) =>
    outline.items.map(({ points, axis, kind }) => ({
      points: points.map((point) => turned(turn, point)),
      axis: turned(turn, axis),
      kind,
    }));
  const near = (p, q) => distance(p, q) < NEAR;
  const same = (one, other) =>
    one.kind === other.kind &&
    (near(one.axis, other.axis) || near(one.axis, turned(OTHER_WAY, other.axis))) &&
    (one.points.every((point, i) => near(point, other.points[i])) ||
      one.points.every((point, i) => near(point, other.points.at(-1 - i))));
  const others = placed(b);
  return placed(a).every((one) => others.some((other) => same(one, other)));
}

/** The page's readers and writers, bundled once. */
export async function loadReaders() {
  const { encodeShare, decodeShare } = await loadTypeScript('web/src/share/codec.ts');
  const { readMpd } = await loadTypeScript('web/src/share/read-mpd.ts');
  const { readCatalogue } = await loadTypeScript('web/src/model/catalogue.ts');
  const file = JSON.parse(readFileSync(resolve(TOP, 'core/parts/catalogue.json'), 'utf8'));
  const outlines = new Map(file.parts.map((part) => [part.id, outlineOf(part)]));
  return { encodeShare, decodeShare, readMpd, catalogue: readCatalogue(file), outlines };
}

/** @throws {Error} where the link of a sketch gives another one. */
export async function compareLink({ encodeShare, decodeShare }, sketch) {
  const link = await encodeShare({ sketch, preset: 'simple', seed: 1 });
  if (!link.ok) {
    throw new Error(`link: ${link.message}`);
  }
  const back = await decodeShare(link.value);
  if (!back?.ok) {
    throw new Error(`link of the sketch: ${back?.message ?? 'none of ours'}`);
  }
  const { lines, joints = [], symmetries = [], keepOut = [] } = back.value.sketch;
  const same = (a, b) =>
    distance(a.from, b.from) < NEAR &&
    distance(a.to, b.to) < NEAR &&
    (a.exact ?? false) === (b.exact ?? false) &&
    a.holeAxis === b.holeAxis;
  const counts = [lines, joints, symmetries, keepOut].map(({ length }) => length).join();
  const wanted = [sketch.lines, sketch.joints, sketch.symmetries, sketch.keepOut];
  if (
    counts !== wanted.map((list) => list?.length ?? 0).join() ||
    !lines.every((line, i) => same(line, sketch.lines[i]))
  ) {
    throw new Error(`its link holds another sketch: ${JSON.stringify(back.value.sketch)}`);
  }
}

/** @throws {Error} where the .mpd file of a model gives other parts, or the same elsewhere. */
export function compareMpd({ readMpd, catalogue, outlines }, model, mpd) {
  const read = readMpd(mpd, catalogue);
  if (!read.ok) {
    if (model.parts.length === 0) {
      return;
    }
    throw new Error(`.mpd: ${read.message}`);
  }
  const left = [...JSON.parse(read.value).parts];
  for (const part of model.parts) {
    const place = left.findIndex(
      (other) =>
        other.part === part.part &&
        other.color === part.color &&
        distance(other.position, part.position) < NEAR &&
        (distance(other.rotation, part.rotation) < NEAR ||
          looksAlike(outlines.get(part.part), other.rotation, part.rotation)),
    );
    if (place < 0) {
      throw new Error(`.mpd: ${part.part} at ${part.position} is not in it`);
    }
    left.splice(place, 1);
  }
  if (left.length > 0) {
    throw new Error(`.mpd: ${left.length} parts more than the model has`);
  }
}
