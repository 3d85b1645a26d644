import { bad, good, type Outcome } from '../base/outcome.ts';
import type { Vec3 } from '../geometry/vec.ts';

/** Parts that are put in place together; mirrors planAssemblyJson in core/design/design_session.h. */
export interface Addition {
  /** Indices into the model's parts. */
  readonly parts: readonly number[];
  /** The last straight move, which ends in the place; modules. */
  readonly travel: Vec3;
  /** Moves before it. */
  readonly via: readonly Vec3[];
  /** The subassembly that is put in whole, or null for single parts. */
  readonly subgroup: number | null;
  /** Something is in the way. */
  readonly forced: boolean;
}

export interface AssemblyStep {
  readonly group: number;
  readonly adds: readonly Addition[];
  readonly stable: boolean;
}

/** Parts that are built apart; group 0 is the whole model. */
export interface AssemblyGroup {
  readonly id: number;
  readonly parts: readonly number[];
  /** Parts of each further copy, in the same order. */
  readonly copies: readonly (readonly number[])[];
  /** Whether each copy is a mirror image. */
  readonly mirrored: readonly boolean[];
}

export interface AssemblyPlan {
  readonly assemblable: boolean;
  readonly groups: readonly AssemblyGroup[];
  readonly steps: readonly AssemblyStep[];
  readonly stuck: readonly { readonly message: string }[];
}

/** Thrown inside this file alone. */
class Refusal extends Error {}

/** Reads the building sequence that the core answers. @param count parts of the model. */
export function readPlan(json: string, count: number): Outcome<AssemblyPlan> {
  try {
    const root = record(JSON.parse(json), 'plan');
    return good({
      assemblable: root['assemblable'] === true,
      groups: list(root['groups'], 'groups').map((value, i) => readGroup(value, i, count)),
      steps: list(root['steps'], 'steps').map((value, i) => readStep(value, `steps[${i}]`, count)),
      stuck: list(root['stuck'] ?? [], 'stuck').map((value) => {
        const { message } = record(value, 'stuck');
        return { message: typeof message === 'string' ? message : '' };
      }),
    });
  } catch (error) {
    return bad(error instanceof Error ? error.message : 'the building sequence is unreadable');
  }
}

function readGroup(value: unknown, index: number, count: number): AssemblyGroup {
  const place = `groups[${index}]`;
  const group = record(value, place);
  const copies = list(group['copies'] ?? [], `${place}.copies`);
  const mirrored = list(group['mirrored'] ?? [], `${place}.mirrored`);
  return {
    id: typeof group['id'] === 'number' ? group['id'] : index,
    parts: indices(group['parts'], `${place}.parts`, count),
    copies: copies.map((copy, i) => indices(copy, `${place}.copies[${i}]`, count)),
    mirrored: copies.map((_, i) => mirrored[i] === true),
  };
}

function readStep(value: unknown, place: string, count: number): AssemblyStep {
  const step = record(value, place);
  const group = step['group'];
  return {
    group: typeof group === 'number' ? group : 0,
    stable: step['stable'] !== false,
    adds: list(step['adds'], `${place}.adds`).map((add, i) =>
      readAddition(add, `${place}.adds[${i}]`, count),
    ),
  };
}

function readAddition(value: unknown, place: string, count: number): Addition {
  const add = record(value, place);
  const subgroup = add['subgroup'];
  return {
    parts: indices(add['parts'], `${place}.parts`, count),
    travel: vector(add['travel'], `${place}.travel`),
    via: list(add['via'] ?? [], `${place}.via`).map((move, i) =>
      vector(move, `${place}.via[${i}]`),
    ),
    subgroup: typeof subgroup === 'number' ? subgroup : null,
    forced: add['forced'] === true,
  };
}

function record(value: unknown, place: string): Record<string, unknown> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    throw new Refusal(`${place}: should be an object`);
  }
  return value as Record<string, unknown>;
}

function list(value: unknown, place: string): unknown[] {
  if (!Array.isArray(value)) {
    throw new Refusal(`${place}: should be a list`);
  }
  return value;
}

function indices(value: unknown, place: string, count: number): number[] {
  return list(value, place).map((n, i) => {
    if (typeof n !== 'number' || !Number.isInteger(n) || n < 0 || n >= count) {
      throw new Refusal(`${place}[${i}]: should be the number of a part, 0 to ${count - 1}`);
    }
    return n;
  });
}

function vector(value: unknown, place: string): Vec3 {
  const numbers = list(value, place);
  const [x, y, z] = numbers;
  if (typeof x !== 'number' || typeof y !== 'number' || typeof z !== 'number') {
    throw new Refusal(`${place}: should be three numbers`);
  }
  return [x, y, z];
}
