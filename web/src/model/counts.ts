import type { Catalogue, PartClass } from './catalogue.ts';
import type { Model } from './model.ts';

/** So many of one part in one colour. */
export interface PartCount {
  readonly part: string;
  readonly color: number;
  readonly count: number;
}

/** Counts by part and colour, most frequent first, then by number and colour. */
export function countParts(model: Model): PartCount[] {
  const counts = new Map<string, { part: string; color: number; count: number }>();
  for (const placed of model.parts) {
    const key = `${placed.part}/${placed.color}`;
    const known = counts.get(key);
    if (known) {
      known.count += 1;
    } else {
      counts.set(key, { part: placed.part, color: placed.color, count: 1 });
    }
  }
  return [...counts.values()].sort(
    (a, b) => b.count - a.count || compareText(a.part, b.part) || a.color - b.color,
  );
}

/** How many parts of each class a model holds; unknown parts are not counted. */
export function countClasses(model: Model, catalogue: Catalogue): Map<PartClass, number> {
  const counts = new Map<PartClass, number>();
  for (const placed of model.parts) {
    const part = catalogue.find(placed.part);
    if (part) {
      counts.set(part.partClass, (counts.get(part.partClass) ?? 0) + 1);
    }
  }
  return counts;
}

/** Sum of the parts' masses in grams; unknown parts weigh nothing. */
export function modelMass(model: Model, catalogue: Catalogue): number {
  return model.parts.reduce((sum, placed) => sum + (catalogue.find(placed.part)?.mass ?? 0), 0);
}

function compareText(a: string, b: string): number {
  if (a === b) {
    return 0;
  }
  return a < b ? -1 : 1;
}
