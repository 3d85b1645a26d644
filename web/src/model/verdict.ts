import type { CheckItem, Problem, WellBuiltItem } from './report.ts';

/** How one lamp shines: `none` where there is nothing to judge, `busy` while it is being found out. */
export type LampState = 'ok' | 'warn' | 'bad' | 'none' | 'busy';

/** What a person asks of a model, in the order in which it is asked. */
export type LampId = 'buildable' | 'wellBuilt' | 'stands' | 'moves';

export interface Lamp {
  readonly id: LampId;
  readonly state: LampState;
}

/** What is wrong first; one thing, so that one sentence can say it and one place can be lit. */
export type FirstWrong =
  | { readonly kind: 'fault' }
  | { readonly kind: 'problem'; readonly index: number; readonly problem: Problem }
  | { readonly kind: 'item'; readonly item: CheckItem }
  | { readonly kind: 'missing'; readonly count: number }
  | { readonly kind: 'guests'; readonly count: number }
  | { readonly kind: 'pieces'; readonly count: number }
  | { readonly kind: 'falls' }
  | { readonly kind: 'wellBuilt'; readonly item: WellBuiltItem };

/** One verdict on a drawing and its model: never better than the worst that is known of them. */
export interface Verdict {
  readonly tone: LampState;
  readonly lamps: readonly Lamp[];
  readonly first: FirstWrong | null;
}

/** All that the verdict is made of. What is not known yet is left out. */
export interface VerdictInput {
  /** Places of the drawing that are most likely not meant: lines that look joined and are not. */
  readonly faults: number;
  readonly buildable: boolean;
  readonly items: readonly CheckItem[];
  readonly problems: readonly Problem[];
  /** Connected pieces that the drawing consists of. */
  readonly pieces: number;
  /** Parts of the model that the person does not have. */
  readonly missing: number;
  /** Parts that were not judged because they are not known. */
  readonly guests?: number;
  readonly stands?: boolean | undefined;
  /** Joints that were drawn. */
  readonly joints: number;
  readonly wellBuilt?: readonly WellBuiltItem[] | undefined;
}

const JOINTS = 'joints';

/** The verdict on a model that is finished and made for the drawing on screen. */
export function verdictOf(input: VerdictInput): Verdict {
  const lamps = lampsOf(input);
  const first = firstWrong(input);
  return { tone: first === null ? worst(lamps) : toneOf(first, input), lamps, first };
}

function lampsOf(input: VerdictInput): Lamp[] {
  const { faults, buildable, pieces, missing, guests = 0 } = input;
  const made: LampState = faults > 0 || pieces > 1 || missing > 0 || guests > 0 ? 'warn' : 'ok';
  const rest = [...wellBuiltLamp(input), standsLamp(input), movesLamp(input)];
  if (buildable) {
    return [{ id: 'buildable', state: made }, ...rest];
  }
  // Whatever else may be said of it, nothing is green under a red verdict.
  const unlit = rest.map(
    (lamp): Lamp => (lamp.state === 'ok' ? { id: lamp.id, state: 'none' } : lamp),
  );
  return [{ id: 'buildable', state: 'bad' }, ...unlit];
}

function wellBuiltLamp({ wellBuilt }: VerdictInput): Lamp[] {
  const asked = wellBuilt?.filter(({ applies }) => applies !== false);
  return asked ? [{ id: 'wellBuilt', state: asked.every(({ ok }) => ok) ? 'ok' : 'warn' }] : [];
}

function standsLamp({ stands, guests = 0 }: VerdictInput): Lamp {
  // Nobody knows what parts that are not known weigh.
  return {
    id: 'stands',
    state: stands === undefined || guests > 0 ? 'none' : stands ? 'ok' : 'warn',
  };
}

function movesLamp({ joints, items }: VerdictInput): Lamp {
  const turns = items.find(({ id }) => id === JOINTS)?.ok;
  return { id: 'moves', state: joints === 0 ? 'none' : turns === false ? 'bad' : 'ok' };
}

/** In the order of what must be mended before the rest can be: drawing, parts, then how it is built. */
function firstWrong(input: VerdictInput): FirstWrong | null {
  if (input.faults > 0) {
    return { kind: 'fault' };
  }
  if (!input.buildable) {
    const [problem] = input.problems;
    const item = input.items.find(({ ok }) => !ok);
    return problem
      ? { kind: 'problem', index: 0, problem }
      : { kind: 'item', item: item ?? { id: '', title: '', ok: false, detail: '' } };
  }
  if (input.guests) {
    return { kind: 'guests', count: input.guests };
  }
  if (input.missing > 0) {
    return { kind: 'missing', count: input.missing };
  }
  if (input.pieces > 1) {
    return { kind: 'pieces', count: input.pieces };
  }
  if (input.stands === false) {
    return { kind: 'falls' };
  }
  const item = input.wellBuilt?.find(({ ok, applies }) => !ok && applies !== false);
  return item ? { kind: 'wellBuilt', item } : null;
}

function toneOf({ kind }: FirstWrong, { buildable }: VerdictInput): LampState {
  return !buildable || kind === 'problem' || kind === 'item' ? 'bad' : 'warn';
}

function worst(lamps: readonly Lamp[]): LampState {
  const states = lamps.map(({ state }) => state);
  return (['bad', 'warn', 'busy'] as const).find((state) => states.includes(state)) ?? 'ok';
}
