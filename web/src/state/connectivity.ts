import { cross, distance, length, normalize, subtract, type Vec3 } from '../geometry/vec.ts';
import { pointKey, type SketchDocument, type SketchLine, sketchNodes } from '../model/sketch.ts';
import { removeLines, replaceLines } from './edits.ts';

/** The lines that hang together with the given ones by shared nodes, these included. */
export function connectedLines(
  sketch: SketchDocument,
  from: ReadonlySet<number>,
): ReadonlySet<number> {
  const neighbours = new Map<number, Set<number>>();
  for (const node of sketchNodes(sketch.lines)) {
    for (const line of node.lines) {
      const known = neighbours.get(line) ?? new Set();
      for (const other of node.lines) {
        known.add(other);
      }
      neighbours.set(line, known);
    }
  }
  const reached = new Set(from);
  // A set that grows while it is walked through is walked to its end.
  for (const line of reached) {
    for (const other of neighbours.get(line) ?? []) {
      reached.add(other);
    }
  }
  return reached;
}

/** The lines that follow one another from the given ones, up to where more than two meet. */
export function chainedLines(
  sketch: SketchDocument,
  from: ReadonlySet<number>,
): ReadonlySet<number> {
  const links = sketchNodes(sketch.lines).filter((node) => node.lines.length === 2);
  const reached = new Set(from);
  // A set that grows while it is walked through is walked to its end.
  for (const line of reached) {
    for (const { at, lines } of links) {
      if (lines.includes(line) && lines.every((each) => endsAt(sketch.lines[each], at))) {
        for (const other of lines) {
          reached.add(other);
        }
      }
    }
  }
  return reached;
}

function endsAt(line: SketchLine | undefined, at: Vec3): boolean {
  return line !== undefined && [line.from, line.to].some((end) => pointKey(end) === pointKey(at));
}

/** Makes one line of two selected ones that lie in a row, again and again until none is left. */
export function joinLines(sketch: SketchDocument, indices: ReadonlySet<number>): SketchDocument {
  const chosen = [...indices];
  for (const a of chosen) {
    for (const b of chosen) {
      const first = sketch.lines[a];
      const second = sketch.lines[b];
      const whole = a < b && first && second ? joined(first, second) : null;
      if (whole) {
        const next = removeLines(replaceLines(sketch, new Map([[a, whole]])), new Set([b]));
        const left = chosen.filter((i) => i !== b).map((i) => (i > b ? i - 1 : i));
        return joinLines(next, new Set(left));
      }
    }
  }
  return sketch;
}

function joined(a: SketchLine, b: SketchLine): SketchLine | null {
  const [aFree, bFree] = freeEnds(a, b);
  if (!aFree || !bFree || a.exact !== b.exact || a.holeAxis !== b.holeAxis) {
    return null;
  }
  const u = normalize(subtract(a.to, a.from));
  const v = normalize(subtract(b.to, b.from));
  const sum = distance(a.from, a.to) + distance(b.from, b.to);
  const straight = length(cross(u, v)) < 1e-3 && Math.abs(distance(aFree, bFree) - sum) < 1e-3;
  return straight ? { ...a, from: aFree, to: bFree } : null;
}

/** The ends that two lines do not share, or nothing when they share none. */
function freeEnds(a: SketchLine, b: SketchLine) {
  const ends = [
    [a.from, a.to, b.from, b.to],
    [a.from, a.to, b.to, b.from],
    [a.to, a.from, b.from, b.to],
    [a.to, a.from, b.to, b.from],
  ] as const;
  const match = ends.find(([, aEnd, bEnd]) => pointKey(aEnd) === pointKey(bEnd));
  return match ? ([match[0], match[3]] as const) : [];
}
