import { useRef, useState } from 'preact/hooks';
import { CELL, type GridBeam, type GridNode, holesBetween } from './grid-puzzle.ts';
import { lessonWords } from './lesson-words.ts';
import { BOARD } from './svg-roles.ts';

const LAYER_CLASS = ['layer-a', 'layer-b', 'layer-c'] as const;

interface BoardProps {
  /** Units along a side. */
  readonly side: number;
  readonly beams: readonly GridBeam[];
  readonly onLay: (from: GridNode, to: GridNode) => void;
  readonly onBeam: (index: number, off: boolean) => void;
}

/** The grid with its beams; y grows upwards in the puzzle and downwards on screen. */
export function PuzzleBoard({ side, beams, onLay, onBeam }: BoardProps) {
  const svg = useRef<SVGSVGElement>(null);
  const [start, setStart] = useState<GridNode | null>(null);
  const [cursor, setCursor] = useState<GridNode>({ x: 0, y: 0 });
  const [keyed, setKeyed] = useState(false);
  const nodeAt = (event: PointerEvent) => nodeUnder(event, svg.current, side);
  const finish = (end: GridNode) => {
    if (start) {
      onLay(start, end);
    }
    setStart(null);
  };
  const onKey = (event: KeyboardEvent) => {
    const move = ARROWS[event.key];
    if (move) {
      event.preventDefault();
      setKeyed(true);
      setCursor({
        x: Math.min(side, Math.max(0, cursor.x + move[0])),
        y: Math.min(side, Math.max(0, cursor.y + move[1])),
      });
    } else if (event.key === 'Enter' && event.target === svg.current) {
      event.preventDefault();
      if (start) {
        finish(cursor);
      } else {
        setStart(cursor);
      }
    } else if (event.key === 'Escape') {
      setStart(null);
    }
  };
  return (
    <svg
      ref={svg}
      class="puzzle-board"
      viewBox={`-1 ${-side - 1} ${side + 2} ${side + 2}`}
      {...BOARD}
      aria-label={lessonWords.puzzle.board}
      onKeyDown={onKey}
      onPointerDown={(event) => {
        setKeyed(false);
        const node = nodeAt(event);
        setCursor(node);
        setStart(node);
        svg.current?.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => start && !keyed && setCursor(nodeAt(event))}
      onPointerUp={(event) => {
        const end = nodeAt(event);
        if (start && start.x === end.x && start.y === end.y) {
          setStart(null);
          const hit = topBeamAt(beams, end);
          if (hit >= 0) {
            onBeam(hit, event.shiftKey);
          }
        } else if (!keyed) {
          finish(end);
        }
      }}
    >
      <Grid side={side} />
      {beams.map((beam, i) => (
        <BeamShape key={i} beam={beam} />
      ))}
      {start && holesBetween(start, cursor) > 1 ? (
        <path class="puzzle-preview" d={lineOf(start, cursor)} />
      ) : null}
      {keyed ? <circle class="puzzle-cursor" cx={cursor.x} cy={-cursor.y} r={0.4} /> : null}
    </svg>
  );
}

/** The node of the grid that is nearest to a pointer. */
function nodeUnder(event: PointerEvent, board: SVGSVGElement | null, side: number): GridNode {
  const box = board?.getBoundingClientRect();
  const scale = (side + 2) / (box?.width || 1);
  const clamp = (value: number) => Math.min(side, Math.max(0, Math.round(value)));
  return {
    x: clamp((event.clientX - (box?.left ?? 0)) * scale - 1),
    y: clamp(side + 1 - (event.clientY - (box?.top ?? 0)) * scale),
  };
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

function lineOf(a: GridNode, b: GridNode): string {
  return `M${a.x} ${-a.y}L${b.x} ${-b.y}`;
}

/** The highest beam over a node, or -1. */
function topBeamAt(beams: readonly GridBeam[], node: GridNode): number {
  let best = -1;
  beams.forEach((beam, i) => {
    const on =
      holesBetween(beam.from, node) > 0 &&
      holesBetween(beam.from, node) + holesBetween(node, beam.to) - 1 ===
        holesBetween(beam.from, beam.to);
    if (on && (best < 0 || beam.layer >= (beams[best]?.layer ?? 0))) {
      best = i;
    }
  });
  return best;
}

function Grid({ side }: { readonly side: number }) {
  const lines = Array.from({ length: side / CELL + 1 }, (_, i) => i * CELL);
  return (
    <>
      {lines.map((at) => (
        <path key={at} class="guide-line" d={`M0 ${-at}H${side}M${at} 0V${-side}`} />
      ))}
      {lines.flatMap((at) =>
        Array.from({ length: side + 1 }, (_, i) => (
          <g key={`${at}/${i}`}>
            <circle class="puzzle-node" cx={i} cy={-at} r={0.13} />
            <circle class="puzzle-node" cx={at} cy={-i} r={0.13} />
          </g>
        )),
      )}
    </>
  );
}

/** Layers are shown by colour, and a little beside each other, so that overlaps can be seen. */
function BeamShape({ beam }: { readonly beam: GridBeam }) {
  const { from, to, layer } = beam;
  const shift = (layer - 1) * 0.13;
  const moved = (node: GridNode) => ({ x: node.x + shift, y: node.y + shift });
  return (
    <path
      class={`puzzle-beam ${LAYER_CLASS[layer] ?? ''}`}
      data-layer={layer}
      d={lineOf(moved(from), moved(to))}
    />
  );
}
