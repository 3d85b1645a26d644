import { add, type Mat3, multiply, rotate, scale, type Vec3 } from '../geometry/vec.ts';
import { type Catalogue, isMale, type Part } from './catalogue.ts';
import type { Model, PlacedPart } from './model.ts';
import type { Problem } from './report.ts';

// Mends of a model that nobody drew here: a pin that fits in place of one that does not (an axle pin where a round pin sits
// in a cross hole, a pin of three where one of two leaves a beam out). Which pin fits is not known beforehand: all that
// could be put in the place are tried, and the checks say which leaves fewer problems.

/** A part in place of another. */
export interface Mend {
  readonly index: number;
  readonly before: string;
  readonly after: string;
  /** Problems that are left. */
  readonly left: number;
  /** The model file with it. */
  readonly json: string;
}

/** Asks for the problems of a model file; null where it cannot be said. */
export type AskProblems = (json: string) => Promise<readonly Problem[] | null>;

interface Placed extends Pick<PlacedPart, 'part' | 'position' | 'rotation'> {}

interface MendTask {
  readonly json: string;
  readonly model: Model;
  readonly problems: readonly Problem[];
  readonly catalogue: Catalogue;
  readonly ask: AskProblems;
}

/** Pins that are looked at, and pins tried for each on the whole model. */
const MOST_PINS = 6;
const MOST_TRIED = 3;
/** How far from the parts of a problem a pin may be at fault. */
const NEAR = 0.3;
/** What lies round a pin that is judged with it. */
const AROUND = 1.2;
const SHIFTS = [0, 0.5, -0.5, 1, -1] as const;
const FLIP: Mat3 = [-1, 0, 0, 0, -1, 0, 0, 0, 1];

/** The first mend that leaves fewer problems, or null. */
export async function findMend(task: MendTask): Promise<Mend | null> {
  const { json, model, problems, catalogue, ask } = task;
  for (const index of suspects(model, problems, catalogue)) {
    const old = model.parts[index];
    const ranked = old ? await rank(task, index, old) : [];
    for (const placed of ranked.slice(0, MOST_TRIED)) {
      const mended = withPart(json, index, placed);
      const left = (await ask(mended))?.length ?? Number.POSITIVE_INFINITY;
      if (old && left < problems.length) {
        return { index, before: old.part, after: placed.part, left, json: mended };
      }
    }
  }
  return null;
}

/** Pins of the problems, then those beside their other parts. */
function suspects(
  model: Model,
  problems: readonly Problem[],
  catalogue: Catalogue,
): readonly number[] {
  const named = new Set(problems.flatMap(({ parts }) => parts ?? []));
  const pins = [...model.parts.keys()].filter((index) => {
    const part = catalogue.find(model.parts[index]?.part ?? '');
    return part && isStraightPin(part);
  });
  const boxes = [...named].flatMap((index) => boxOf(model.parts[index], catalogue, NEAR) ?? []);
  const beside = pins.filter((index) => {
    const box = named.has(index) ? null : boxOf(model.parts[index], catalogue, 0);
    return box && boxes.some((other) => meet(box, other));
  });
  return [...pins.filter((index) => named.has(index)), ...beside].slice(0, MOST_PINS);
}

/** A part that is put into holes along one line and is nothing else. */
function isStraightPin({ features, partClass, guest }: Part): boolean {
  const along = features.every(({ kind, axis }) => isMale(kind) && Math.abs(axis[0]) > 0.99);
  return !guest && partClass === 'pin' && along && features.length > 0;
}

/** What leaves fewer problems around the pin, the best first. */
async function rank(task: MendTask, index: number, old: PlacedPart): Promise<readonly Placed[]> {
  const { model, catalogue, ask } = task;
  const near = neighbours(model, index, catalogue);
  const fileOf = (placed: Placed) =>
    JSON.stringify({
      format: 'liftarm-model',
      version: 1,
      name: '',
      parts: near.map((i) => (i === index ? { ...old, ...placed } : model.parts[i])),
    });
  const now = (await ask(fileOf(old)))?.length ?? 0;
  const better: { readonly placed: Placed; readonly left: number }[] = [];
  for (const placed of candidates(old, catalogue)) {
    const left = (await ask(fileOf(placed)))?.length ?? now;
    if (left < now) {
      better.push({ placed, left });
    }
  }
  // Among equals the first: candidates begin with what is most like the pin that is there.
  return better.sort((a, b) => a.left - b.left).map(({ placed }) => placed);
}

function neighbours(model: Model, index: number, catalogue: Catalogue): number[] {
  const box = boxOf(model.parts[index], catalogue, AROUND);
  return [...model.parts.keys()].filter((i) => {
    const part = model.parts[i];
    const other = catalogue.find(part?.part ?? '')?.guest ? null : boxOf(part, catalogue, 0);
    return box && other && meet(box, other);
  });
}

/** All pins in the place of one: as they lie and turned round, and further to either side. */
function candidates(old: PlacedPart, catalogue: Catalogue): Placed[] {
  const part = catalogue.find(old.part);
  if (!part) {
    return [];
  }
  const others = catalogue.parts
    .filter((other) => other.id !== old.part && isStraightPin(other))
    .sort((a, b) => unlike(a, part) - unlike(b, part));
  const middle = add(old.position, rotate(old.rotation, middleOf(part)));
  return others.flatMap((other) =>
    SHIFTS.flatMap((shift) =>
      [old.rotation, multiply(old.rotation, FLIP)].map((rotation): Placed => {
        const along = scale(rotate(old.rotation, [1, 0, 0]), shift);
        const off = rotate(rotation, middleOf(other));
        const position = add(add(middle, along), scale(off, -1));
        return { part: other.id, position: rounded(position), rotation };
      }),
    ),
  );
}

/** Friction first, then whether it has the same kinds of heads, then length. */
function unlike(a: Part, b: Part): number {
  const heads = ({ features }: Part) => [...new Set(features.map(({ kind }) => kind))].join();
  const friction = a.friction === b.friction ? 0 : 100;
  return friction + (heads(a) === heads(b) ? 0 : 10) + Math.abs(lengthOf(a) - lengthOf(b));
}

function lengthOf({ features }: Part): number {
  return features.reduce((sum, { length }) => sum + length, 0);
}

function middleOf({ features }: Part): Vec3 {
  const ends = features.flatMap(({ center, length }) => [
    center[0] - length / 2,
    center[0] + length / 2,
  ]);
  return [(Math.min(...ends) + Math.max(...ends)) / 2, 0, 0];
}

function rounded(v: Vec3): Vec3 {
  return v.map((x) => Math.round(x * 1e6) / 1e6 + 0) as unknown as Vec3;
}

interface Box {
  readonly min: Vec3;
  readonly max: Vec3;
}

/** The box of a part in its place, wider by so much on each side. */
function boxOf(placed: PlacedPart | undefined, catalogue: Catalogue, wider: number): Box | null {
  const part = placed && catalogue.find(placed.part);
  if (!part) {
    return null;
  }
  const middle = scale(add(part.boundsMin, part.boundsMax), 0.5);
  const half = scale(add(part.boundsMax, scale(part.boundsMin, -1)), 0.5);
  const centre = add(placed.position, rotate(placed.rotation, middle));
  const r = placed.rotation.map(Math.abs) as unknown as Mat3;
  const reach = add(rotate(r, half), [wider, wider, wider]);
  return { min: add(centre, scale(reach, -1)), max: add(centre, reach) };
}

function meet(a: Box, b: Box): boolean {
  return ([0, 1, 2] as const).every((k) => a.min[k] <= b.max[k] && b.min[k] <= a.max[k]);
}

function withPart(json: string, index: number, placed: Placed): string {
  const file = JSON.parse(json) as { parts: object[] };
  const parts = file.parts.map((part, i) => (i === index ? { ...part, ...placed } : part));
  return JSON.stringify({ ...file, parts });
}
