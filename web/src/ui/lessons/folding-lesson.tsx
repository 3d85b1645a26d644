import { useRef, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { Segmented } from '../controls.tsx';
import { lessonWords } from './lesson-words.ts';
import { Praise } from './praise.tsx';
import { FIGURE } from './svg-roles.ts';

const words = lessonWords.folding;
const WIDE = 8;
const HIGH = 6;
const BRACES = ['0', '9', '10', '11'] as const;
const LIMITS = { low: 15, high: 165 } as const;
const KEY_STEP = 3;

/** The angle in degrees between sides of 8 and 6 that a brace across them asks for. */
export function braceAngle(brace: number): number {
  const cosine = (WIDE * WIDE + HIGH * HIGH - brace * brace) / (2 * WIDE * HIGH);
  return (Math.acos(cosine) * 180) / Math.PI;
}

/** A frame of 8 by 6 that folds until a brace holds it. */
export function FoldingLesson() {
  const svg = useRef<SVGSVGElement>(null);
  const [angle, setAngle] = useState(90);
  const [moved, setMoved] = useState(false);
  const [brace, setBrace] = useState<(typeof BRACES)[number]>('0');
  const braced = brace !== '0';
  const shown = braced ? braceAngle(Number(brace)) : angle;
  const radians = (shown * Math.PI) / 180;
  const dx = HIGH * Math.cos(radians);
  const dy = -HIGH * Math.sin(radians);
  const turn = (value: number) => {
    setAngle(Math.min(LIMITS.high, Math.max(LIMITS.low, value)));
    setMoved(true);
  };
  const drag = (event: PointerEvent) => {
    const box = svg.current?.getBoundingClientRect();
    if (!box || braced || event.buttons === 0) {
      return;
    }
    const x = ((event.clientX - box.left) / box.width) * 24 - 8;
    const y = ((event.clientY - box.top) / box.height) * 9 - 8;
    turn((Math.atan2(-y, x) * 180) / Math.PI);
  };
  const degrees = Math.round(shown);
  const upright = braced && degrees === 90;
  const state = stateOf(braced, degrees);
  return (
    <>
      <svg
        ref={svg}
        class="lesson-figure"
        viewBox="-8 -8 24 9"
        {...FIGURE}
        aria-label={words.figure}
      >
        <Frame dx={dx} dy={dy} braced={braced} />
        <circle
          class="guide-node chosen"
          cx={dx}
          cy={dy}
          r={0.45}
          role="slider"
          tabindex={0}
          aria-label={words.corner}
          aria-valuemin={LIMITS.low}
          aria-valuemax={LIMITS.high}
          aria-valuenow={degrees}
          onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
          onPointerMove={drag}
          onKeyDown={(event) => {
            const step = { ArrowLeft: KEY_STEP, ArrowRight: -KEY_STEP }[event.key];
            if (step && !braced) {
              event.preventDefault();
              turn(angle + step);
            }
          }}
        />
      </svg>
      <div class="lesson-row">
        <span>{words.brace}</span>
        <Segmented
          name="brace"
          legend={words.brace}
          choices={BRACES.map((value) => ({ value, label: value === '0' ? words.none : value }))}
          value={brace}
          onChange={setBrace}
        />
      </div>
      <p role="status" data-testid="fold-state">
        {state}
      </p>
      <Praise when={upright && moved} words="6 · 8 · 10." />
    </>
  );
}

function stateOf(braced: boolean, degrees: number): string {
  if (!braced) {
    return fillWords(words.folds, { n: degrees });
  }
  return degrees === 90 ? words.rigid : fillWords(words.leans, { n: degrees });
}

function Frame(props: { readonly dx: number; readonly dy: number; readonly braced: boolean }) {
  const { dx, dy, braced } = props;
  const fixed = [
    [0, 0],
    [WIDE, 0],
    [WIDE + dx, dy],
  ];
  return (
    <>
      <path class="laid-beam" d={`M0 0H${WIDE}L${WIDE + dx} ${dy}L${dx} ${dy}Z`} />
      {braced ? <path class="laid-beam brace" d={`M${WIDE} 0L${dx} ${dy}`} /> : null}
      {fixed.map(([x, y]) => (
        <circle key={`${x},${y}`} class="guide-node" cx={x} cy={y} r={0.25} />
      ))}
    </>
  );
}
