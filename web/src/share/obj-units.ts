import { distance, type Vec3 } from '../geometry/vec.ts';
import type { SketchLine } from '../model/sketch.ts';

// What the numbers of an .obj file mean, which the file does not say: the unit and which way is up.

interface Unit {
  readonly name: string;
  /** Modules. */
  readonly size: number;
}

const MILLIMETRES: Unit = { name: 'millimetres', size: 1 / 8 };
const METRES: Unit = { name: 'metres', size: 125 };

/** Units that a comment may name. */
const NAMED: readonly (readonly [RegExp, Unit])[] = [
  [/\b(mm|milli ?met(er|re)s?)\b/i, MILLIMETRES],
  [/\b(cm|centi ?met(er|re)s?)\b/i, { name: 'centimetres', size: 1.25 }],
  [/\b(ldu|ldraw units?)\b/i, { name: 'LDraw units', size: 1 / 20 }],
  [/\b(inch(es)?)\b/i, { name: 'inches', size: 25.4 / 8 }],
  [/\b(m|met(er|re)s?)\b/i, METRES],
];

/** All lines shorter than this are no modules, modules. */
const SMALL = 1;
/** One as long as this, with all of whole modules in millimetres, was measured in them. */
const LARGE = 40;
const CLOSE = 0.02;

/** The unit that the comments name, or that the lengths look like; null for modules. */
export function unitOf(comments: string, lines: readonly SketchLine[]): Unit | null {
  const named = NAMED.find(([words]) => words.test(comments));
  if (named) {
    return named[1];
  }
  const lengths = lines.map(({ from, to }) => distance(from, to));
  const longest = Math.max(...lengths);
  if (longest < SMALL) {
    return METRES;
  }
  const whole = (length: number) => Math.abs(length / 8 - Math.round(length / 8)) < CLOSE;
  return longest >= LARGE && lengths.every(whole) ? MILLIMETRES : null;
}

/** Whether Y is up: a comment says so, or all feet stand at the least y and not at the least z. */
export function isYUp(comments: string, lines: readonly SketchLine[]): boolean {
  if (/\by[ -]?(is )?up\b|\by up\b/i.test(comments)) {
    return true;
  }
  if (/\bz[ -]?(is )?up\b/i.test(comments)) {
    return false;
  }
  const ends = new Map<string, { point: Vec3; count: number }>();
  for (const point of lines.flatMap(({ from, to }) => [from, to])) {
    const key = point.map((x) => x.toFixed(3)).join(' ');
    ends.set(key, { point, count: (ends.get(key)?.count ?? 0) + 1 });
  }
  const all = [...ends.values()];
  const feet = all.filter(({ count }) => count === 1).map(({ point }) => point);
  const stand = (k: 1 | 2) => {
    const floor = Math.min(...all.map(({ point }) => point[k]));
    const top = Math.max(...all.map(({ point }) => point[k]));
    return top - floor > CLOSE && feet.every((point) => point[k] - floor < CLOSE);
  };
  return feet.length >= 3 && stand(1) && !stand(2);
}
