import { useRef } from 'preact/hooks';
import type { PlanePoint } from '../../model/linkage-answer.ts';
import { linePath } from './linkage-picture.tsx';
import { linkageWords as words } from './linkage-words.ts';

/** Modules from the middle to the edges. */
const HALF = { u: 16, v: 10 } as const;
/** A point for each so many modules of a stroke. */
const SPACING = 0.2;

/** Paper to draw a path on: a stroke is a path of its own, single clicks add points. */
export function PathCanvas(props: {
  readonly points: readonly PlanePoint[];
  readonly closed: boolean;
  /** While drawing. */
  readonly onDraw: (points: readonly PlanePoint[]) => void;
  /** A stroke, or a further point. */
  readonly onDone: (points: readonly PlanePoint[], stroke: boolean) => void;
}) {
  const { points, closed, onDraw, onDone } = props;
  const stroke = useRef<PlanePoint[] | null>(null);
  const svg = useRef<SVGSVGElement>(null);
  const at = (event: PointerEvent): PlanePoint => {
    const toPaper = svg.current?.getScreenCTM()?.inverse();
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(toPaper);
    return [Math.round(x * 100) / 100, Math.round(-y * 100) / 100];
  };
  const release = () => {
    const drawn = stroke.current;
    stroke.current = null;
    if (drawn && drawn.length > 2) {
      onDone(drawn, true);
    } else if (drawn?.[0]) {
      onDone([...points, drawn[0]], false);
    }
  };
  return (
    <svg
      ref={svg}
      class="path-canvas"
      viewBox={`${-HALF.u} ${-HALF.v} ${2 * HALF.u} ${2 * HALF.v}`}
      role="img"
      aria-label={words.canvas}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        stroke.current = [at(event)];
      }}
      onPointerMove={(event) => {
        const drawn = stroke.current;
        const last = drawn?.at(-1);
        const next = at(event);
        if (drawn && last && Math.hypot(next[0] - last[0], next[1] - last[1]) > SPACING) {
          drawn.push(next);
          if (drawn.length > 2) {
            onDraw([...drawn]);
          }
        }
      }}
      onPointerUp={release}
      onPointerCancel={() => {
        stroke.current = null;
      }}
    >
      <path class="path-grid" d={GRID} />
      <path class="linkage-drawn" d={linePath(points, closed)} />
      {points.length < 40
        ? points.map(([u, v]) => <circle key={`${u}/${v}`} cx={u} cy={-v} r={0.16} />)
        : null}
    </svg>
  );
}

const GRID = [
  ...Array.from({ length: 2 * HALF.u + 1 }, (_, i) => `M${i - HALF.u} ${-HALF.v}V${HALF.v}`),
  ...Array.from({ length: 2 * HALF.v + 1 }, (_, i) => `M${-HALF.u} ${i - HALF.v}H${HALF.u}`),
].join('');
