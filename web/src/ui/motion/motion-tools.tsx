import { useEffect, useMemo, useState } from 'preact/hooks';
import type { MotionAnswer } from '../../model/motion.ts';
import {
  anglesOf,
  type Course,
  jointPairs,
  type Moment,
  momentsOf,
  nearestHole,
  shaftPairs,
  type TracePoint,
  traceOf,
} from '../../model/motion-curves.ts';
import { isFullTurn, spanOf } from '../../model/motion-span.ts';
import { MotionTraces, type Trace } from '../../view/overlays/motion-traces.ts';
import type { MotionStudy } from '../checks/motion-study.ts';
import { motionWords as words } from '../checks/motion-words.ts';
import { isSame, turnablesOf } from '../checks/turnables.ts';
import { Icon } from '../icon.tsx';
import { FilmFiles } from '../instructions/film-files.tsx';
import type { Page, ShownModel } from '../page.ts';
import { usePage } from '../page-context.ts';
import { safeName, saveFile } from '../share/save-file.ts';
import { formatNumber } from '../text/language.ts';
import { AnglePlot, type Curve } from './angle-plot.tsx';
import { DEGREES_PER_SECOND, type MotionBoard } from './motion-board.ts';
import { MotionStage } from './motion-stage.ts';
import { motionTable } from './motion-table.ts';
import { moverOfPart, useDragging } from './use-dragging.ts';
import './motion-tools.css';

const COLOURS = [0xd7342b, 0x1f6fd6, 0x1b9e4b, 0x8e44ad, 0xd98200, 0x0e8f9c] as const;
const MOST_TRACES = COLOURS.length;

export interface MotionToolsProps {
  readonly shown: ShownModel;
  readonly study: MotionStudy;
  readonly answer: MotionAnswer;
  readonly board: MotionBoard;
  /** Drives a joint by its place among those of the answer. */
  readonly onDrive: (joint: number) => void;
}

/** What can be done with a motion besides playing it: drag it, watch points and angles, take a film along. */
export function MotionTools(props: MotionToolsProps) {
  const { shown, board } = props;
  const page = usePage();
  const [points, setPoints] = useState<readonly TracePoint[]>([]);
  const [placing, setPlacing] = useState(false);
  const course = useCourse(board);
  const moments = useMemo(() => momentsOf(course), [course]);
  useDrag(props, placing ? (point) => place(point) : null);
  const place = ({ part, local }: TracePoint) => {
    const placed = shown.model.parts[part];
    const hole = placed && nearestHole(page.catalogue, placed, local);
    setPoints([...points, { part, local: hole ?? local }].slice(-MOST_TRACES));
    setPlacing(false);
  };
  const ways = useMemo(
    () => points.map((point) => traceOf(shown.model, point, moments)),
    [shown, points, moments],
  );
  const tracesAt = (moment: Moment): Trace[] =>
    points.map((point, i) => ({
      points: ways[i] ?? [],
      now: traceOf(shown.model, point, [moment])[0] ?? [0, 0, 0],
      colour: COLOURS[i] ?? 0,
    }));
  const now = { second: secondOf(board, course), driven: board.drivers.value };
  useTraces(page, tracesAt(now));
  const curves = useCurves(props, moments);
  const seconds = moments.map(({ second }) => second);
  const save = () => {
    const content = new Blob([motionTable(seconds, curves, ways)], { type: 'text/csv' });
    saveFile(safeName(`${shown.model.name} motion`, 'csv'), content);
  };
  return (
    <div class="motion-tools">
      <p class="quiet">{placing ? words.tracePlace : words.drag}</p>
      <TraceList
        count={points.length}
        placing={placing}
        onPlace={() => setPlacing(!placing)}
        onRemove={(i) => setPoints(points.filter((_, k) => k !== i))}
      />
      <AnglePlot seconds={seconds} curves={curves} now={now.second} />
      <div class="motion-files">
        <button type="button" class="button" onClick={save} disabled={seconds.length === 0}>
          {words.saveTable}
        </button>
        <FilmFiles
          open={() => stageOf(page, shown, { course, traces: tracesAt })}
          close={(stage) => (stage as MotionStage).dispose()}
          speed={1}
          title={`${shown.model.name} motion`}
          pictures={false}
        />
      </div>
    </div>
  );
}

function stageOf(
  page: Page,
  shown: ShownModel,
  film: Pick<ConstructorParameters<typeof MotionStage>[0], 'course' | 'traces'>,
): MotionStage {
  return new MotionStage({
    ...film,
    model: shown.model,
    catalogue: page.catalogue,
    looking: page.view()?.viewDirection() ?? [-1, 1, -1],
    colourBy: page.preferences.peek().colourBy,
    theme: 'light',
  });
}

function TraceList(props: {
  readonly count: number;
  readonly placing: boolean;
  readonly onPlace: () => void;
  readonly onRemove: (index: number) => void;
}) {
  return (
    <div class="motion-traces">
      <button type="button" class="button" aria-pressed={props.placing} onClick={props.onPlace}>
        {words.trace}
      </button>
      {Array.from({ length: props.count }, (_, i) => {
        const name = words.point(formatNumber(i + 1));
        return (
          <button
            key={name}
            type="button"
            class="chip"
            aria-label={words.traceRemove(name)}
            onClick={() => props.onRemove(i)}
          >
            <span class="swatch" style={{ background: hexOf(COLOURS[i] ?? 0) }} />
            {name} <Icon name="close" />
          </button>
        );
      })}
    </div>
  );
}

function hexOf(colour: number): string {
  return `#${colour.toString(16).padStart(6, '0')}`;
}

/** How the motion is gone through; the same object while only the first driver goes on. */
function useCourse(board: MotionBoard): Course {
  const drivers = board.drivers.value;
  const degreesPerSecond = DEGREES_PER_SECOND * board.speed.value;
  const mode = board.mode.value;
  const key = JSON.stringify(
    drivers.map(({ mover, degrees }, i) => [mover, i === 0 ? null : degrees]),
  );
  return useMemo(
    () => ({ driven: key ? drivers : [], mode, degreesPerSecond }),
    // The drivers change with every frame; the key says when that matters.
    [key, mode, degreesPerSecond],
  );
}

/** The second of its course at which the board stands; null where nothing moves. */
function secondOf(board: MotionBoard, { mode, degreesPerSecond }: Course): number {
  const [lead] = board.drivers.value;
  if (!lead) {
    return 0;
  }
  const span = spanOf(lead.path);
  const there = lead.degrees - span.from;
  const back = 2 * (span.to - span.from) - there;
  const round = mode === 'loop' && isFullTurn(span);
  return (round || lead.way > 0 ? there : back) / degreesPerSecond;
}

function movableParts({ motions, trains }: MotionAnswer): ReadonlySet<number> {
  const turning = trains.filter(({ turns }) => turns).flatMap(({ shafts }) => shafts);
  return new Set([...motions, ...turning].flatMap(({ parts }) => parts));
}

function useCurves(props: MotionToolsProps, moments: readonly Moment[]): readonly Curve[] {
  const { shown, answer } = props;
  const { catalogue } = usePage();
  const pairs = useMemo(() => {
    const { groups, trains } = answer;
    const joints = shown.sketch?.joints ?? [];
    return [
      ...jointPairs(shown.model, catalogue, { joints, groups }).map((pair) => ({
        name: words.joint(String(pair.joint + 1)),
        pair,
      })),
      ...shaftPairs(trains, groups).map((pair) => ({
        name: words.shaft(String(pair.shaft + 1)),
        pair,
      })),
    ];
  }, [shown, catalogue, answer]);
  return useMemo(
    () =>
      moments.length === 0
        ? []
        : pairs.map(({ name, pair }) => ({
            name,
            angles: anglesOf(shown.model, pair, moments),
          })),
    [shown, pairs, moments],
  );
}

function useTraces(page: Page, traces: readonly Trace[]): void {
  const some = traces.length > 0;
  const overlay = useMemo(() => (some ? new MotionTraces() : null), [some]);
  useEffect(() => (overlay ? page.view()?.addOverlay(overlay) : undefined), [page, overlay]);
  useEffect(() => overlay?.set(traces));
}

function useDrag(props: MotionToolsProps, instead: ((point: TracePoint) => void) | null): void {
  const { shown, study, answer, board, onDrive } = props;
  const movable = useMemo(() => movableParts(answer), [answer]);
  const drive = async (part: number) => {
    const all = turnablesOf(answer);
    // What turns on a shaft by itself is meant before what carries the shaft.
    const movers = all
      .filter(({ turns }) => turns)
      .map(({ mover }) => mover)
      .reverse();
    const mover = await moverOfPart(part, movers, async (each) => (await study.path(each)).parts);
    if (mover) {
      onDrive(all.findIndex((each) => isSame(each.mover, mover)));
    }
  };
  useDragging({ shown, board, movable, drive, instead });
}
