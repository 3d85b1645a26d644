import { useRef, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { Segmented } from '../controls.tsx';
import { usePage } from '../page-context.ts';
import { roomSolver } from '../share/room-solver.ts';
import { inWords } from '../text/sentences.ts';
import {
  CELL,
  FEWEST,
  type GridBeam,
  type GridNode,
  holesBetween,
  isBeam,
  LAYERS,
  type PuzzleSize,
  puzzleSketch,
  scoreOf,
} from './grid-puzzle.ts';
import { lessonWords } from './lesson-words.ts';
import { Praise } from './praise.tsx';
import { PuzzleBoard } from './puzzle-board.tsx';

const words = lessonWords.puzzle;
const SIZES = [
  { value: '2', label: '2 × 2' },
  { value: '3', label: '3 × 3' },
  { value: '4', label: '4 × 4' },
] as const;

/** The grid puzzle: lay beams by hand, and see what the solver makes of it. */
export function PuzzleLesson() {
  const [size, setSize] = useState<PuzzleSize>(2);
  const [beams, setBeams] = useState<readonly GridBeam[]>([]);
  const [layer, setLayer] = useState('0');
  const [said, setSaid] = useState('');
  const [solver, setSolver] = useState<number | null>(null);
  const score = scoreOf(size, beams);
  const lay = (from: GridNode, to: GridNode) => {
    const holes = holesBetween(from, to);
    if (isBeam(holes)) {
      setBeams([...beams, { from, to, layer: Number(layer) }]);
      setSaid('');
    } else if (holes > 1) {
      setSaid(fillWords(words.noBeam, { n: holes }));
    }
  };
  const press = (index: number, off: boolean) => {
    setBeams(
      off
        ? beams.filter((_, i) => i !== index)
        : beams.map((beam, i) =>
            i === index ? { ...beam, layer: (beam.layer + 1) % LAYERS } : beam,
          ),
    );
  };
  const resize = (value: string) => {
    setSize(value === '4' ? 4 : value === '3' ? 3 : 2);
    setBeams([]);
    setSolver(null);
    setSaid('');
  };
  return (
    <>
      <div class="lesson-row">
        <Segmented
          name="puzzle-size"
          legend={words.size}
          choices={SIZES}
          value={`${size}`}
          onChange={resize}
        />
        <span>{words.layer}</span>
        <Segmented
          name="puzzle-layer"
          legend={words.layer}
          choices={Array.from({ length: LAYERS }, (_, i) => ({ value: `${i}`, label: `${i + 1}` }))}
          value={layer}
          onChange={setLayer}
        />
        <button type="button" class="button" onClick={() => setBeams(beams.slice(0, -1))}>
          {words.undo}
        </button>
        <button type="button" class="button" onClick={() => setBeams([])}>
          {words.clear}
        </button>
      </div>
      <div class="puzzle-play">
        <PuzzleBoard side={CELL * size} beams={beams} onLay={lay} onBeam={press} />
        <div class="puzzle-side">
          <p class="quiet">{words.layerNote}</p>
          <p role="status">{said}</p>
          <dl class="puzzle-score">
            <Figure name={words.beams} value={score.beams} id="beams" />
            <Figure name={words.uncovered} value={score.uncovered} id="uncovered" />
            <Figure name={words.collisions} value={score.collisions} id="collisions" />
            <Figure name={words.gaps} value={score.gaps} id="gaps" />
            <Figure name={words.pieces} value={score.pieces} id="pieces" />
          </dl>
          <p>{fillWords(words.best, { n: FEWEST[size] })}</p>
          <SolverPlay key={size} size={size} onCount={setSolver} />
          <Praise when={score.complete} words={verdict(score.beams, size, solver)} />
        </div>
      </div>
    </>
  );
}

function verdict(beams: number, size: PuzzleSize, solver: number | null): string {
  const parts = [fillWords(words.win, { n: beams })];
  if (solver !== null && beams < solver) {
    parts.push(words.beaten);
  }
  parts.push(beams <= FEWEST[size] ? words.equal : fillWords(words.worse, { n: FEWEST[size] }));
  return parts.join(' ');
}

function Figure(props: { readonly name: string; readonly value: number; readonly id: string }) {
  return (
    <div>
      <dt>{props.name}</dt>
      <dd data-testid={`puzzle-${props.id}`}>{props.value}</dd>
    </div>
  );
}

/** Lets the program lay the same beams on the same grid. */
function SolverPlay(props: {
  readonly size: PuzzleSize;
  readonly onCount: (beams: number) => void;
}) {
  const { preferences } = usePage();
  const [said, setSaid] = useState('');
  const running = useRef(false);
  const play = async (): Promise<void> => {
    if (running.current) {
      return;
    }
    running.current = true;
    setSaid(words.solving);
    const { seed } = preferences.value;
    const set = {
      lengths: '2,3,5,7,9',
      'search.corners': 0,
      'search.frames': 0,
      'search.axles': 0,
    };
    const sketch = JSON.stringify(puzzleSketch(props.size));
    const result = await roomSolver().solve(sketch, { seed, set });
    running.current = false;
    if (result.outcome !== 'solved') {
      setSaid(result.outcome === 'refused' ? inWords(result.message) : words.solverFailed);
      return;
    }
    const report = JSON.parse(result.reportJson) as { beams?: number; buildable?: boolean };
    const beams = report.beams ?? 0;
    setSaid(report.buildable ? fillWords(words.solver, { n: beams }) : words.solverFailed);
    props.onCount(beams);
  };
  return (
    <p>
      <button
        type="button"
        class="button primary"
        onClick={() => {
          play().catch(() => setSaid(words.solverFailed));
        }}
      >
        {words.solve}
      </button>{' '}
      <span role="status" data-testid="solver-says">
        {said}
      </span>
    </p>
  );
}
