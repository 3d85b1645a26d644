import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import type { JointRange, MotionPath, MovedPart } from '../../model/motion.ts';
import { canMix, mixedPoses } from '../../model/motion-mix.ts';
import { isFullTurn, type Span, spanOf, within } from '../../model/motion-span.ts';
import type { MotionStudy, Mover } from '../checks/motion-study.ts';

/** Something that turns, and how far it has. */
export interface Driver {
  readonly mover: Mover;
  readonly range: JointRange | null;
  readonly path: MotionPath;
  readonly degrees: number;
  /** Which way it goes when it is played. */
  readonly way: 1 | -1;
}

/** Round and round, or there and back. */
export type PlayMode = 'loop' | 'swing';

export const SPEEDS = [0.25, 0.5, 1, 2, 4] as const;
/** At speed 1, slower than the eye. */
export const DEGREES_PER_SECOND = 45;
/** A stop is reached within this, degrees. */
const AT_STOP = 0.3;

/** All motion of one model: what drives it, where it stands, how it is played. */
export class MotionBoard {
  readonly #study: MotionStudy;
  readonly #drivers = signal<readonly Driver[]>([]);
  readonly drivers: ReadonlySignal<readonly Driver[]> = this.#drivers;
  readonly playing = signal(false);
  readonly mode = signal<PlayMode>('loop');
  readonly speed = signal<number>(1);
  /** One sentence of the core about what does not turn; of the solver, where it failed. */
  readonly message = signal('');
  readonly failure = signal('');
  #asked = 0;

  /** Where the moving parts stand. */
  readonly poses: ReadonlySignal<ReadonlyMap<number, MovedPart>> = computed(() =>
    mixedPoses(this.#drivers.value),
  );
  /** The parts that stop a joint where it stands now. */
  readonly stops: ReadonlySignal<readonly number[]> = computed(() =>
    this.#drivers.value.flatMap(stopAt),
  );
  /** The driver that was chosen first. */
  readonly lead: ReadonlySignal<Driver | null> = computed(() => this.#drivers.value[0] ?? null);

  constructor(study: MotionStudy) {
    this.#study = study;
  }

  /** Drives this alone. Never rejects. */
  async choose(mover: Mover, range: JointRange | null): Promise<void> {
    const asked = ++this.#asked;
    const path = await this.#pathOf(mover, asked);
    if (path) {
      this.#drivers.value = [{ mover, range, path, degrees: 0, way: 1 }];
    }
  }

  /** Drives this beside what is driven, where both can be had; drives it no more if it was. Never rejects. */
  async toggle(mover: Mover, range: JointRange | null): Promise<'done' | 'not together'> {
    const others = this.#drivers.value.filter((driver) => !isOf(driver, mover));
    if (others.length < this.#drivers.value.length) {
      this.#drivers.value = others;
      return 'done';
    }
    const path = await this.#pathOf(mover, ++this.#asked);
    if (!path) {
      return 'done';
    }
    const now = this.#drivers.value;
    if (!canMix([...now.map((driver) => driver.path), path])) {
      return 'not together';
    }
    this.#drivers.value = [...now, { mover, range, path, degrees: 0, way: 1 }];
    return 'done';
  }

  drives(mover: Mover): boolean {
    return this.#drivers.value.some((driver) => isOf(driver, mover));
  }

  /** Puts a driver somewhere by hand; what plays stops. */
  put(mover: Mover, degrees: number): void {
    batch(() => {
      this.playing.value = false;
      this.#drivers.value = this.#drivers.value.map((driver) =>
        isOf(driver, mover)
          ? { ...driver, degrees: clamped(spanOf(driver.path), degrees) }
          : driver,
      );
    });
  }

  /** Goes on by so many seconds. */
  advance(seconds: number): void {
    const step = seconds * DEGREES_PER_SECOND * this.speed.value;
    this.#drivers.value = this.#drivers.value.map((driver) =>
      moved(driver, step * (driver.path.pace ?? 1), this.mode.value),
    );
  }

  async #pathOf(mover: Mover, asked: number): Promise<MotionPath | null> {
    try {
      const path = await this.#study.path(mover);
      if (asked !== this.#asked) {
        return null;
      }
      batch(() => {
        this.failure.value = '';
        this.message.value = path.turns ? '' : path.message;
      });
      return path.turns ? path : null;
    } catch (error) {
      if (asked === this.#asked) {
        this.failure.value = error instanceof Error ? error.message : String(error);
      }
      return null;
    }
  }
}

function clamped({ from, to }: Span, degrees: number): number {
  return Math.min(to, Math.max(from, degrees));
}

function isOf(driver: Driver, { of, index }: Mover): boolean {
  return driver.mover.of === of && driver.mover.index === index;
}

/**
 * Where a driver is after so many degrees: round where there is a full turn to go round, else from end to end and
 * back.
 */
export function moved(driver: Driver, by: number, mode: PlayMode): Driver {
  const span = spanOf(driver.path);
  if (mode === 'loop' && isFullTurn(span)) {
    return { ...driver, degrees: within(span, driver.degrees + driver.way * by) };
  }
  const size = span.to - span.from;
  const there = driver.degrees - span.from;
  const gone = ((driver.way > 0 ? there : 2 * size - there) + by) % (2 * size);
  return gone < size
    ? { ...driver, degrees: span.from + gone, way: 1 }
    : { ...driver, degrees: span.from + 2 * size - gone, way: -1 };
}

function stopAt({ range, degrees }: Driver): readonly number[] {
  if (!range) {
    return [];
  }
  if (degrees <= range.from + AT_STOP) {
    return range.stoppedBy.from;
  }
  return degrees >= range.to - AT_STOP ? range.stoppedBy.to : [];
}
