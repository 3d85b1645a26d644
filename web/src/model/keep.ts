import type { AxisName } from '../geometry/vec.ts';

// What a sketch of version 2 keeps of its model (docs/keep.md); core/sketch/keep_json.h is the authority.

/** Nodes of a line, counted from its first end point; a part may reach past either end. */
export interface Stretch {
  readonly from: number;
  readonly to: number;
}

/** A part as it lies on a line, its round holes at the nodes of the stretch. */
export interface KeptPart extends Stretch {
  /** LDraw number. */
  readonly part: string;
  /** Modules off the line along the hole axis. */
  readonly layer: number;
  readonly holeAxis: AxisName;
  /** Stretches of its other bars, for parts that have several. */
  readonly with?: readonly (Stretch & { readonly line: number })[];
}

/** A part that may not lie on a stretch, on whichever layer. */
export interface BarredPart extends Stretch {
  readonly part: string;
}

/** What is wanted of the parts on one line. */
export interface Keep {
  readonly line: number;
  readonly parts?: readonly KeptPart[];
  readonly barred?: readonly BarredPart[];
  /** On which its beams may lie; any when left out. */
  readonly layers?: readonly number[];
  /** Nodes past which a beam reaches by one at most, on one side or the other. */
  readonly splits?: readonly number[];
}

/** A part with the line that its place is told on. */
export interface Place {
  readonly line: number;
  readonly part: KeptPart;
}

export const MAX_KEPT_LAYER = 2;
const MOST = 20000;
const MOST_REACH = 200;
const PART_NUMBER = /^[0-9a-z.-]{1,20}$/;

export function isPartNumber(value: unknown): value is string {
  return typeof value === 'string' && PART_NUMBER.test(value);
}

/** What is wrong with the member `keep` of a file: the place and what would be right; null: nothing. */
export function keepFault(value: unknown, lengths: readonly number[]): string | null {
  const seen = new Set<unknown>();
  return listFault(value, 'keep', (item, place) => {
    const fault =
      objectFault(item, place, ['line', 'parts', 'barred', 'layers', 'splits']) ??
      lineFault(field(item, 'line'), `${place}.line`, lengths);
    if (fault !== null) {
      return fault;
    }
    const line = Number(field(item, 'line'));
    if (seen.has(line)) {
      return `${place}.line: line ${line} has an element already`;
    }
    seen.add(line);
    if (Object.keys(item as object).length < 2) {
      return `${place}: says nothing; expected parts, barred, layers or splits`;
    }
    return oneFault(item, place, { line, lengths });
  });
}

interface OnLine {
  readonly line: number;
  readonly lengths: readonly number[];
}

function oneFault(item: unknown, place: string, on: OnLine): string | null {
  const length = on.lengths[on.line] ?? 0;
  const optional = (key: string, fault: (each: unknown, where: string) => string | null) => {
    const list = field(item, key);
    return list === undefined ? null : listFault(list, `${place}.${key}`, fault);
  };
  const layers = field(item, 'layers');
  return (
    optional('parts', (part, where) => partFault(part, where, on)) ??
    optional(
      'barred',
      (part, where) =>
        objectFault(part, where, ['part', 'from', 'to']) ??
        numberedFault(part, where) ??
        stretchFault(part, where, length),
    ) ??
    optional('layers', layerFault) ??
    optional('splits', (node, where) => wholeFault(node, where, 0, length)) ??
    (Array.isArray(layers) && new Set(layers).size < layers.length
      ? `${place}.layers: a layer is named twice`
      : null)
  );
}

function partFault(part: unknown, place: string, { line, lengths }: OnLine): string | null {
  const bars = field(part, 'with');
  const axis = field(part, 'holeAxis');
  return (
    objectFault(part, place, ['part', 'from', 'to', 'layer', 'holeAxis', 'with']) ??
    numberedFault(part, place) ??
    stretchFault(part, place, lengths[line] ?? 0) ??
    layerFault(field(part, 'layer'), `${place}.layer`) ??
    (axis === 'x' || axis === 'y' || axis === 'z'
      ? null
      : `${place}.holeAxis: should be "x", "y" or "z"`) ??
    (bars === undefined
      ? null
      : listFault(
          bars,
          `${place}.with`,
          (bar, where) =>
            objectFault(bar, where, ['line', 'from', 'to']) ??
            lineFault(field(bar, 'line'), `${where}.line`, lengths) ??
            stretchFault(bar, where, lengths[Number(field(bar, 'line'))] ?? 0),
        ))
  );
}

function numberedFault(part: unknown, place: string): string | null {
  return isPartNumber(field(part, 'part'))
    ? null
    : `${place}.part: expected an LDraw part number, such as "32524"`;
}

function stretchFault(value: unknown, place: string, length: number): string | null {
  const from = field(value, 'from');
  const to = field(value, 'to');
  return (
    wholeFault(from, `${place}.from`, -MOST_REACH, length) ??
    wholeFault(to, `${place}.to`, 0, length + MOST_REACH) ??
    (Number(from) > Number(to) ? `${place}.from: should be at most to` : null)
  );
}

function layerFault(value: unknown, place: string): string | null {
  return wholeFault(value, place, -MAX_KEPT_LAYER, MAX_KEPT_LAYER);
}

function lineFault(value: unknown, place: string, lengths: readonly number[]): string | null {
  return wholeFault(value, place, 0, lengths.length - 1);
}

function wholeFault(value: unknown, place: string, least: number, most: number): string | null {
  return Number.isInteger(value) && Number(value) >= least && Number(value) <= most
    ? null
    : `${place}: should be a whole number from ${least} to ${most}`;
}

function objectFault(value: unknown, place: string, keys: readonly string[]): string | null {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    return `${place}: should be an object`;
  }
  const stray = Object.keys(value).find((key) => !keys.includes(key));
  return stray === undefined ? null : `${place}: ${stray.slice(0, 20)} is not known`;
}

function listFault(
  value: unknown,
  place: string,
  each: (item: unknown, place: string) => string | null,
): string | null {
  if (!Array.isArray(value) || value.length === 0 || value.length > MOST) {
    return `${place}: should be a list of 1 to ${MOST}`;
  }
  for (const [i, item] of value.entries()) {
    const fault = each(item, `${place}[${i}]`);
    if (fault !== null) {
      return fault;
    }
  }
  return null;
}

function field(value: unknown, key: string): unknown {
  return typeof value === 'object' && value !== null ? Reflect.get(value, key) : undefined;
}

/** Whether two parts are the same part in the same place. */
export function samePart(a: KeptPart, b: KeptPart): boolean {
  return (
    a.part === b.part &&
    a.from === b.from &&
    a.to === b.to &&
    a.layer === b.layer &&
    a.holeAxis === b.holeAxis
  );
}

/** Whether two stretches of one line have an edge in common. */
export function overlaps(a: Stretch, b: Stretch): boolean {
  return a.from < b.to && b.from < a.to;
}
