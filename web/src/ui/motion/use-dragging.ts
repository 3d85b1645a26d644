import { useEffect, useRef } from 'preact/hooks';
import { dot } from '../../geometry/vec.ts';
import { gearingOf } from '../../model/gear-motion.ts';
import { holesOf, type TracePoint } from '../../model/motion-curves.ts';
import { localOf, nearestAngle, pointOf } from '../../model/motion-follow.ts';
import { mixedPose } from '../../model/motion-mix.ts';
import { spanOf } from '../../model/motion-span.ts';
import type { PointerInput } from '../../tools/tool.ts';
import type { Mover } from '../checks/motion-study.ts';
import type { Page, ShownModel } from '../page.ts';
import { usePage } from '../page-context.ts';
import type { Driver, MotionBoard } from './motion-board.ts';

export interface Dragging {
  readonly shown: ShownModel;
  readonly board: MotionBoard;
  /** Parts that some motion moves. */
  readonly movable: ReadonlySet<number>;
  /** Drives what moves a part, if that can be had. */
  readonly drive: (part: number) => Promise<void>;
  /** Takes the next press instead, where one is waited for. @returns whether it did. */
  readonly instead: ((point: TracePoint) => void) | null;
}

/** How far from the middle of a hole a press is in it, modules. */
const HOLE = 0.35;

/** A moving part that is dragged takes its linkage along. */
export function useDragging(dragging: Dragging): void {
  const page = usePage();
  const latest = useRef(dragging);
  latest.current = dragging;
  useEffect(() => {
    let held: TracePoint | null = null;
    page.pointerTaker.value = {
      pressed: (at) => {
        const now = latest.current;
        if (now.instead) {
          return placed(page, now, now.instead, at);
        }
        held = movableAt(page, now, at);
        if (held && !driverOf(now.board, held.part)) {
          now.drive(held.part).catch(() => undefined);
        }
        return held !== null;
      },
      moved: (at) => {
        if (held) {
          follow(page, latest.current, held, at);
        }
      },
      released: () => {
        held = null;
      },
    };
    return () => {
      page.pointerTaker.value = null;
    };
  }, [page]);
}

function poseNow({ shown, board }: Dragging, part: number) {
  const rest = shown.model.parts[part];
  return mixedPose(board.drivers.peek(), part) ?? rest ?? null;
}

/** Gives a point to whoever waits for one. @returns whether there was one. */
function placed(
  page: Page,
  dragging: Dragging,
  take: (point: TracePoint) => void,
  at: PointerInput,
): boolean {
  const point = holeAt(page, dragging, at, () => true) ?? surfaceAt(page, dragging, at);
  if (point) {
    take(point);
  }
  return point !== null;
}

/** Through a hole one sees what is behind: the beam around it is meant. */
function movableAt(page: Page, dragging: Dragging, at: PointerInput): TracePoint | null {
  const point = surfaceAt(page, dragging, at);
  const movable = (part: number) => dragging.movable.has(part);
  return point && movable(point.part) ? point : holeAt(page, dragging, at, movable);
}

/** The surface of a part under the pointer. */
function surfaceAt(page: Page, dragging: Dragging, { x, y }: PointerInput): TracePoint | null {
  const picked = page.view()?.pickPart(x, y);
  const pose = picked ? poseNow(dragging, picked.index) : null;
  return picked && pose ? { part: picked.index, local: localOf(pose, picked.point) } : null;
}

/** The hole under the pointer, of several the one in front. */
function holeAt(
  page: Page,
  dragging: Dragging,
  at: PointerInput,
  wanted: (part: number) => boolean,
): TracePoint | null {
  const view = page.view();
  if (!view) {
    return null;
  }
  const into = view.viewDirection();
  let best: { point: TracePoint; depth: number } | null = null;
  dragging.shown.model.parts.forEach(({ part: id }, part) => {
    const pose = wanted(part) ? poseNow(dragging, part) : null;
    for (const local of pose ? holesOf(page.catalogue, id) : []) {
      const middle = pose ? pointOf(pose, local) : local;
      const seen = view.project(middle);
      const depth = dot(middle, into);
      const near = Math.hypot(seen.x - at.x, seen.y - at.y) <= HOLE * view.pixelsPerModule();
      if (near && (!best || depth < best.depth)) {
        best = { point: { part, local }, depth };
      }
    }
  });
  return (best as { point: TracePoint } | null)?.point ?? null;
}

/** The driver that moves a part, of several the one that moves the least besides. */
function driverOf(board: MotionBoard, part: number): Driver | null {
  const moving = board.drivers.peek().filter(({ path }) => path.parts.includes(part));
  return moving.sort((a, b) => a.path.parts.length - b.path.parts.length)[0] ?? null;
}

function follow(page: Page, dragging: Dragging, held: TracePoint, at: PointerInput): void {
  const { board } = dragging;
  const driver = driverOf(board, held.part);
  const view = page.view();
  if (!driver || !view) {
    return;
  }
  const drivers = board.drivers.peek();
  const off = (degrees: number) => {
    const driven = drivers.map((each) => (each === driver ? { ...each, degrees } : each));
    const pose = mixedPose(driven, held.part);
    const seen = pose ? view.project(pointOf(pose, held.local)) : at;
    return Math.hypot(seen.x - at.x, seen.y - at.y);
  };
  const gearing = gearingOf(driver.path, held.part);
  board.put(driver.mover, nearestAngle(spanOf(driver.path), driver.degrees, off, gearing));
}

/** Looks for the joint that moves a part, one after the other. */
export async function moverOfPart(
  part: number,
  movers: readonly Mover[],
  partsOf: (mover: Mover) => Promise<readonly number[]>,
): Promise<Mover | null> {
  for (const mover of movers) {
    if ((await partsOf(mover)).includes(part)) {
      return mover;
    }
  }
  return null;
}
