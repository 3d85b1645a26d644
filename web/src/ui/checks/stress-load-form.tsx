import { useEffect, useState } from 'preact/hooks';
import { scale, type Vec3 } from '../../geometry/vec.ts';
import type { PointLoad } from '../../model/stress.ts';
import type { PointerInput } from '../../tools/tool.ts';
import { IconButton } from '../controls.tsx';
import type { Page } from '../page.ts';
import { usePage } from '../page-context.ts';
import { formatNumber } from '../text/language.ts';
import type { StressStudy } from './stress-study.ts';
import { stressWords as words } from './stress-words.ts';

const DIRECTIONS = {
  down: [0, 0, -1],
  up: [0, 0, 1],
  left: [-1, 0, 0],
  right: [1, 0, 0],
  front: [0, -1, 0],
  back: [0, 1, 0],
} as const satisfies Record<string, Vec3>;

type Direction = keyof typeof DIRECTIONS;

const MOST_NEWTONS = 1000;

/** What somebody pushes with: how hard, which way, and where. */
export function LoadForm({ study }: { readonly study: StressStudy }) {
  const page = usePage();
  const [newtons, setNewtons] = useState(5);
  const [direction, setDirection] = useState<Direction>('down');
  const [placing, setPlacing] = useState(false);
  const add = (at: Vec3) => {
    study.addLoad({ at, force: scale(DIRECTIONS[direction], newtons) });
    page.announce(words.placed);
  };
  usePlacing(page, placing, (at) => {
    setPlacing(false);
    add(at);
  });
  const picked = page.pickedPart.value;
  const middle = picked === null ? null : page.view()?.partCentre(picked);
  return (
    <fieldset class="stress-form">
      <legend>{words.loads}</legend>
      <label>
        <span>{words.force}</span>
        <input
          type="number"
          min="0.1"
          max={MOST_NEWTONS}
          step="0.1"
          value={newtons}
          onChange={(event) => setNewtons(newtonsOf(event.currentTarget.valueAsNumber))}
        />
      </label>
      <label>
        <span>{words.direction}</span>
        <select
          value={direction}
          onChange={(event) => setDirection(event.currentTarget.value as Direction)}
        >
          {Object.keys(DIRECTIONS).map((name) => (
            <option key={name} value={name}>
              {words[name as Direction]}
            </option>
          ))}
        </select>
      </label>
      <div class="stress-buttons">
        <button
          type="button"
          class="button"
          aria-pressed={placing}
          onClick={() => setPlacing(!placing)}
        >
          {placing ? words.placing : words.place}
        </button>
        {middle ? (
          <button type="button" class="button" onClick={() => add(middle)}>
            {words.onPicked}
          </button>
        ) : null}
      </div>
      <LoadList study={study} />
    </fieldset>
  );
}

function LoadList({ study }: { readonly study: StressStudy }) {
  const { loads } = study.options.value;
  return (
    <ul class="stress-loads">
      {loads.map((load, index) => (
        <li key={JSON.stringify(load)}>
          <span>{describe(load)}</span>
          <IconButton icon="close" label={words.remove} onClick={() => study.removeLoad(index)} />
        </li>
      ))}
    </ul>
  );
}

/** While placing, the next press on a brick goes to `place`. */
function usePlacing(page: Page, placing: boolean, place: (at: Vec3) => void): void {
  useEffect(() => {
    if (!placing) {
      return;
    }
    page.pointerTaker.value = {
      pressed: ({ x, y }: PointerInput) => {
        const part = page.view()?.pickPart(x, y);
        if (part) {
          place(part.point);
        }
        return Boolean(part);
      },
      moved: () => undefined,
      released: () => undefined,
    };
    return () => {
      page.pointerTaker.value = null;
    };
  });
}

function describe({ force }: PointLoad): string {
  const size = Math.hypot(...force);
  const name = (Object.keys(DIRECTIONS) as Direction[]).find((key) =>
    DIRECTIONS[key].every((share, axis) => Math.abs(share * size - (force[axis] ?? 0)) < 1e-9),
  );
  return words.load(formatNumber(size, 1), words[name ?? 'down']);
}

function newtonsOf(value: number): number {
  return Number.isFinite(value) ? Math.min(MOST_NEWTONS, Math.max(0.1, value)) : 1;
}
