import { useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { isBeam } from './grid-puzzle.ts';
import { lessonWords as words } from './lesson-words.ts';
import { Praise } from './praise.tsx';
import { FIGURE, pressable } from './svg-roles.ts';

/** A triangle of 6, 8 and 10: ends in figure units, and edges. */
const LINES = [
  { x1: 0, y1: 0, x2: 8, y2: 0, edges: 8 },
  { x1: 8, y1: 0, x2: 8, y2: -6, edges: 6 },
  { x1: 0, y1: 0, x2: 8, y2: -6, edges: 10 },
] as const;
/** 8 is one beam of 9 holes, 6 one of 7; 10 edges need two beams of up to 9 holes. */
const BOUND = 4;

interface Laid {
  readonly line: number;
  readonly from: number;
  readonly to: number;
}

function pointOn(line: number, node: number): { readonly x: number; readonly y: number } {
  const { x1, y1, x2, y2, edges } = LINES[line] ?? LINES[0];
  return { x: x1 + ((x2 - x1) * node) / edges, y: y1 + ((y2 - y1) * node) / edges };
}

/** Edges that no beam covers. */
function openEdges(laid: readonly Laid[]): number {
  return LINES.reduce((sum, { edges }, line) => {
    const open = Array.from({ length: edges }, (_, edge) =>
      laid.some((beam) => beam.line === line && beam.from <= edge && edge < beam.to) ? 0 : 1,
    );
    return sum + open.reduce<number>((total, value) => total + value, 0);
  }, 0);
}

/** Nodes on lines, and beams that cover edges. */
export function GraphLesson() {
  const [laid, setLaid] = useState<readonly Laid[]>([]);
  const [start, setStart] = useState<{ readonly line: number; readonly node: number } | null>(null);
  const [said, setSaid] = useState('');
  const all = LINES.reduce((sum, line) => sum + line.edges, 0);
  const covered = all - openEdges(laid);
  const press = (line: number, node: number) => {
    if (!start || start.line !== line || start.node === node) {
      setStart({ line, node });
      setSaid(words.graph.first);
      return;
    }
    const [from, to] = [Math.min(start.node, node), Math.max(start.node, node)];
    setStart(null);
    if (isBeam(to - from + 1)) {
      setLaid([...laid, { line, from, to }]);
      setSaid('');
    } else {
      setSaid(fillWords(words.graph.wrong, { n: to - from + 1 }));
    }
  };
  return (
    <>
      <svg class="lesson-figure" viewBox="-1 -7 10 8" {...FIGURE} aria-label={words.graph.figure}>
        {LINES.map((line, i) => (
          <path key={i} class="guide-line" d={`M${line.x1} ${line.y1}L${line.x2} ${line.y2}`} />
        ))}
        {laid.map((beam, i) => {
          const a = pointOn(beam.line, beam.from);
          const b = pointOn(beam.line, beam.to);
          return <path key={i} class="laid-beam" d={`M${a.x} ${a.y}L${b.x} ${b.y}`} />;
        })}
        {LINES.map((line, i) =>
          Array.from({ length: line.edges + 1 }, (_, node) => {
            const { x, y } = pointOn(i, node);
            const chosen = start?.line === i && start.node === node;
            return (
              <circle
                key={`${i}/${node}`}
                class={`guide-node ${chosen ? 'chosen' : ''}`}
                cx={x}
                cy={y}
                r={0.19}
                {...pressable(`${i + 1}/${node + 1}`, () => press(i, node))}
              />
            );
          }),
        )}
      </svg>
      <p role="status">{said}</p>
      <p>
        <strong data-testid="covered">{fillWords(words.graph.covered, { n: covered, all })}</strong>{' '}
        · {fillWords(words.graph.beams, { n: laid.length })} ·{' '}
        {fillWords(words.graph.bound, { n: BOUND })}
      </p>
      <button type="button" class="button" onClick={() => setLaid([])}>
        {words.reset}
      </button>
      <Praise when={covered === all} words={fillWords(words.graph.beams, { n: laid.length })} />
    </>
  );
}
