import { dot, length, normalize } from '../geometry/vec.ts';
import { countParts, type PartCount } from '../model/counts.ts';
import type { Model } from '../model/model.ts';
import { PARTS_A_STEP } from '../model/step-size.ts';
import type { Addition, AssemblyGroup, AssemblyPlan, AssemblyStep } from './assembly-plan.ts';

/** A finished subassembly that a step puts in, or several that are alike. */
export interface PutIn {
  readonly group: number;
  readonly count: number;
  /** Parts of the first. */
  readonly parts: readonly number[];
}

/** One page of the instructions. */
export interface BuildStep {
  /** From 1, through all groups in the order of building. */
  readonly number: number;
  readonly group: AssemblyGroup;
  /** From 1 within the group, and how many the group has. */
  readonly groupStep: number;
  readonly groupSteps: number;
  /** Parts that the group holds before this step. */
  readonly before: readonly number[];
  readonly adds: readonly Addition[];
  /** What to take from the heap for one building of this step. */
  readonly loose: readonly PartCount[];
  readonly putIns: readonly PutIn[];
  readonly stable: boolean;
}

/** How often a group is built: itself and its copies. */
export function timesOf(group: AssemblyGroup): number {
  return 1 + group.copies.length;
}

/** Steps of about one size: none asks for more than `most` at once, and neighbours that may be one step are. */
export function evenSteps(steps: readonly AssemblyStep[], most: number): AssemblyStep[] {
  return joinSteps(
    steps.flatMap((step) => splitStep(step, most)),
    most,
  );
}

/** Hands that hold: what was built apart counts as one. */
function sizeOf(adds: readonly Addition[]): number {
  return adds.reduce((sum, { subgroup, parts }) => sum + (subgroup === null ? parts.length : 1), 0);
}

/** A step in as many pages of like size as it takes, in its own order. What goes in as one stays so. */
function splitStep(step: AssemblyStep, most: number): AssemblyStep[] {
  const pages = Math.min(step.adds.length, Math.ceil(sizeOf(step.adds) / most));
  return pages <= 1
    ? [step]
    : Array.from({ length: pages }, (_, i) => {
        const at = (page: number) => Math.round((page * step.adds.length) / pages);
        return { ...step, adds: step.adds.slice(at(i), at(i + 1)) };
      });
}

/**
 * Joins neighbouring steps of one group into pages of a few parts: single parts that come from one side,
 * or the first part with what is put on it. The order of the plan stays.
 */
function joinSteps(steps: readonly AssemblyStep[], most: number): AssemblyStep[] {
  const joined: AssemblyStep[] = [];
  for (const step of steps) {
    const last = joined.at(-1);
    if (last && fitTogether([...last.adds, ...step.adds], most) && last.group === step.group) {
      joined[joined.length - 1] = { ...step, adds: [...last.adds, ...step.adds] };
    } else {
      joined.push(step);
    }
  }
  return joined;
}

function fitTogether(adds: readonly Addition[], most: number): boolean {
  const plain = adds.every(
    (add) => add.subgroup === null && !add.forced && add.via.length === 0 && add.parts.length === 1,
  );
  const moving = adds.filter((add) => length(add.travel) > 1e-6).map((add) => add.travel);
  const first = moving[0];
  const oneSide = moving.every(
    (travel) => first && dot(normalize(travel), normalize(first)) > 0.99,
  );
  return adds.length <= most && plain && oneSide;
}

/**
 * The steps of a plan with what each needs to be drawn.
 * @param most parts a step.
 */
export function buildSteps(
  plan: AssemblyPlan,
  model: Model,
  most: number = PARTS_A_STEP.usual,
): BuildStep[] {
  const groups = new Map(plan.groups.map((group) => [group.id, group]));
  const held = new Map<number, number[]>();
  const done = new Map<number, number>();
  const totals = new Map<number, number>();
  const steps = evenSteps(plan.steps, most);
  for (const { group } of steps) {
    totals.set(group, (totals.get(group) ?? 0) + 1);
  }
  return steps.map((step, i) => {
    const before = held.get(step.group) ?? [];
    const added = step.adds.flatMap((add) => add.parts);
    const loose = step.adds.filter((add) => add.subgroup === null).flatMap((add) => add.parts);
    held.set(step.group, [...before, ...added]);
    const groupStep = (done.get(step.group) ?? 0) + 1;
    done.set(step.group, groupStep);
    return {
      number: i + 1,
      group: groups.get(step.group) ?? { id: step.group, parts: [], copies: [], mirrored: [] },
      groupStep,
      groupSteps: totals.get(step.group) ?? 1,
      before,
      adds: step.adds,
      loose: countParts({
        name: '',
        parts: loose.flatMap((index) => model.parts[index] ?? []),
      }),
      putIns: putInsOf(step.adds),
      stable: step.stable,
    };
  });
}

function putInsOf(adds: readonly Addition[]): PutIn[] {
  const found = new Map<number, PutIn>();
  for (const { subgroup: group, parts } of adds) {
    if (group !== null) {
      const known = found.get(group);
      found.set(group, known ? { ...known, count: known.count + 1 } : { group, count: 1, parts });
    }
  }
  return [...found.values()];
}

/**
 * Plays the plan through. @returns what is wrong, one sentence each: a part that is missing or comes
 * twice, a subassembly that is used before it is built.
 */
export function replayFaults(plan: AssemblyPlan, count: number): string[] {
  const faults: string[] = [];
  const lastStep = new Map<number, number>();
  plan.steps.forEach((step, i) => {
    lastStep.set(step.group, i);
  });
  const whole = plan.groups.find((group) => group.id === 0);
  if (whole?.parts.length !== count) {
    faults.push(`the whole has ${whole?.parts.length ?? 0} of ${count} parts`);
  }
  for (const group of plan.groups) {
    const added = plan.steps
      .filter((step) => step.group === group.id)
      .flatMap((step) => step.adds.flatMap((add) => add.parts));
    const times = new Map<number, number>();
    for (const part of added) {
      times.set(part, (times.get(part) ?? 0) + 1);
    }
    for (const part of group.parts) {
      if (times.get(part) !== 1) {
        faults.push(`group ${group.id}: part ${part} comes ${times.get(part) ?? 0} times`);
      }
    }
    if (added.length !== group.parts.length) {
      faults.push(`group ${group.id}: ${added.length} parts are added to ${group.parts.length}`);
    }
  }
  plan.steps.forEach((step, i) => {
    for (const { subgroup } of step.adds) {
      const built = subgroup === null ? -1 : (lastStep.get(subgroup) ?? Number.POSITIVE_INFINITY);
      if (built >= i) {
        faults.push(`step ${i + 1}: group ${subgroup} is not built yet`);
      }
    }
  });
  return faults;
}
