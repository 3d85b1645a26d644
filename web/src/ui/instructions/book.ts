import type { Vec3 } from '../../geometry/vec.ts';
import { type AssemblyPlan, readPlan } from '../../instructions/assembly-plan.ts';
import { type BuildStep, buildSteps } from '../../instructions/build-steps.ts';
import { withGuestsLast } from '../../instructions/guest-steps.ts';
import { countGuests } from '../../model/guests.ts';
import type { Model } from '../../model/model.ts';
import { ISO_OUT } from '../../view/drawing/drawing-camera.ts';
import type { MeshShelf } from '../../view/drawing/drawn-part.ts';
import { roomSolver } from '../share/room-solver.ts';
import { chooseDirection } from './step-camera.ts';

/** Everything that the instructions of one model show. */
export interface Book {
  readonly title: string;
  readonly model: Model;
  readonly shelf: MeshShelf;
  readonly plan: AssemblyPlan;
  readonly steps: readonly BuildStep[];
  /** For each step, from the model towards the eye. */
  readonly directions: readonly Vec3[];
  /** What a step asks for at most. */
  readonly most: number;
}

/** Whether the reader must turn the model before a step. */
export function isTurned(book: Book, index: number): boolean {
  const step = book.steps[index];
  const previous = book.steps[index - 1];
  return (
    step !== undefined &&
    previous !== undefined &&
    step.group.id === previous.group.id &&
    book.directions[index] !== book.directions[index - 1]
  );
}

/** Asks the core for the order of building. @throws Error with one sentence. */
export async function askPlan(source: {
  readonly json: string;
  readonly model: Model;
}): Promise<AssemblyPlan> {
  const reply = await roomSolver().exportModel(source.json, 'assembly.json');
  if (reply.outcome === 'refused') {
    throw new Error(reply.message);
  }
  const { model } = source;
  const plan = readPlan(reply.text, model.parts.length - countGuests(model));
  if (!plan.ok) {
    throw new Error(plan.message);
  }
  return withGuestsLast(plan.value, model);
}

/** What a book is made of. */
export interface BookSource {
  readonly title: string;
  readonly model: Model;
  readonly shelf: MeshShelf;
  readonly plan: AssemblyPlan;
}

/** @param most parts a step. */
export async function makeBook(source: BookSource, most: number): Promise<Book> {
  const { model, shelf } = source;
  const steps = buildSteps(source.plan, model, most);
  const last = new Map<number, Vec3>();
  const directions: Vec3[] = [];
  for (const step of steps) {
    const before = last.get(step.group.id) ?? ISO_OUT;
    const direction = chooseDirection(model, step, before, shelf);
    last.set(step.group.id, direction);
    directions.push(direction);
    // Pictures are looked at one by one: the page must stay alive between them.
    await new Promise((resolve) => setTimeout(resolve));
  }
  return { ...source, steps, directions, most };
}
