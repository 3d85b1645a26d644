import { useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { Segmented } from '../controls.tsx';
import { lessonWords } from './lesson-words.ts';
import { Praise } from './praise.tsx';
import { FIGURE, pressable } from './svg-roles.ts';
import { ASSEMBLIES, blockerOf, DIRECTIONS, type Direction, type PartCells } from './take-apart.ts';

const words = lessonWords.apart;
const COLOURS = ['#8a929c', '#4477aa', '#ee6677', '#ccbb44'] as const;
const ORDER: readonly Direction[] = ['left', 'up', 'right'];

/** Take parts off by straight moves until nothing is left. */
export function ApartLesson() {
  const [level, setLevel] = useState('0');
  return (
    <>
      <Segmented
        name="assembly"
        legend={words.figure}
        choices={ASSEMBLIES.map((_, i) => ({
          value: `${i}`,
          label: fillWords(words.level, { n: i + 1 }),
        }))}
        value={level}
        onChange={setLevel}
      />
      <Assembly key={level} parts={ASSEMBLIES[Number(level)] ?? []} />
    </>
  );
}

function Assembly({ parts }: { readonly parts: readonly PartCells[] }) {
  const all = () => new Set(parts.keys());
  const [present, setPresent] = useState<ReadonlySet<number>>(all);
  const [chosen, setChosen] = useState<ReadonlySet<number>>(new Set());
  const [moves, setMoves] = useState(0);
  const [said, setSaid] = useState('');
  const toggle = (index: number) => {
    const next = new Set(chosen);
    if (!next.delete(index)) {
      next.add(index);
    }
    setChosen(next);
  };
  const pull = (direction: Direction) => {
    if (chosen.size === 0) {
      setSaid(words.choose);
      return;
    }
    const blocker = blockerOf(parts, present, chosen, direction);
    setMoves(moves + 1);
    if (blocker >= 0) {
      setSaid(fillWords(words.blocked, { n: blocker + 1 }));
      return;
    }
    const left = new Set([...present].filter((index) => !chosen.has(index)));
    setPresent(left);
    setChosen(new Set());
    setSaid(fillWords(words.off, { n: left.size }));
  };
  const restart = () => {
    setPresent(all());
    setChosen(new Set());
    setMoves(0);
    setSaid('');
  };
  return (
    <>
      <svg class="lesson-figure" viewBox="-1 -5 7 6" {...FIGURE} aria-label={words.figure}>
        {parts.map((part, index) =>
          present.has(index) ? (
            <PartShape
              key={index}
              index={index}
              part={part}
              chosen={chosen.has(index)}
              onPress={() => toggle(index)}
            />
          ) : null,
        )}
      </svg>
      <div class="lesson-row">
        {ORDER.map((direction) => (
          <button key={direction} type="button" class="button" onClick={() => pull(direction)}>
            {fillWords(words.pull, { direction: words[direction] })}
          </button>
        ))}
        <button type="button" class="button plain" onClick={restart}>
          {lessonWords.reset}
        </button>
      </div>
      <p role="status" data-testid="apart-says">
        {said}
      </p>
      <Praise when={present.size === 0} words={fillWords(words.finished, { n: moves })} />
    </>
  );
}

function PartShape(props: {
  readonly index: number;
  readonly part: PartCells;
  readonly chosen: boolean;
  readonly onPress: () => void;
}) {
  const { index, part, chosen, onPress } = props;
  return (
    <g
      class={`apart-part ${chosen ? 'chosen' : ''}`}
      {...pressable(fillWords(words.part, { n: index + 1 }), onPress, chosen)}
    >
      {part.map(({ x, y }) => (
        <rect
          key={`${x},${y}`}
          x={x}
          y={-y - 1}
          width={1}
          height={1}
          fill={COLOURS[index % COLOURS.length]}
        />
      ))}
      <path class="apart-outline" d={outlineOf(part)} />
      <text x={(part[0]?.x ?? 0) + 0.5} y={-(part[0]?.y ?? 0) - 0.3}>
        {index + 1}
      </text>
    </g>
  );
}

/** The sides of cells that have no neighbour of the same part. */
function outlineOf(part: PartCells): string {
  const has = (x: number, y: number) => part.some((cell) => cell.x === x && cell.y === y);
  return part
    .flatMap(({ x, y }) =>
      Object.values({ ...DIRECTIONS, down: { x: 0, y: -1 } }).flatMap((d) => {
        if (has(x + d.x, y + d.y)) {
          return [];
        }
        if (d.x !== 0) {
          return [`M${x + (d.x > 0 ? 1 : 0)} ${-y}v-1`];
        }
        return [`M${x} ${-y - (d.y > 0 ? 1 : 0)}h1`];
      }),
    )
    .join('');
}
