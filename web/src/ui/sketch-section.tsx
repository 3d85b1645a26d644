import { useEffect, useRef } from 'preact/hooks';
import type { Vec3 } from '../geometry/vec.ts';
import { type FoundSymmetry, isSameSymmetry } from '../model/found-symmetries.ts';
import type { Stretch } from '../model/report.ts';
import type { SketchSymmetry } from '../model/sketch.ts';
import { hasMend, isLoud } from '../state/sketch-faults.ts';
import { fillWords } from '../tools/tool-words.ts';
import { Section } from './controls.tsx';
import { faultSentence, mendWords } from './fault-words.ts';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { formatNumber, formatPoint } from './text/language.ts';
import { text } from './text.ts';

const SHOWN = 6;

/** What is most likely not meant, each with its place and its mend. Nothing when all is well. */
export function SketchFaults() {
  const page = usePage();
  const faults = page.faults.value;
  if (faults.length === 0) {
    return null;
  }
  return (
    <section class="sketch-faults" aria-label={text.faults.title}>
      <h3>{text.faults.title}</h3>
      <ul>
        {faults.slice(0, SHOWN).map((fault) => (
          <li key={`${fault.kind}${fault.lines.join()}${fault.at.join()}`} class="fault">
            <button type="button" class="problem" onClick={() => page.showPlace(fault.at)}>
              <Icon name={isLoud(fault) || fault.kind === 'pieces' ? 'alert' : 'info'} />
              <span>{faultSentence(fault)}</span>
            </button>
            {hasMend(fault) ? (
              <button type="button" class="button secondary small" onClick={() => page.mend(fault)}>
                {mendWords(fault)}
              </button>
            ) : null}
          </li>
        ))}
      </ul>
      {faults.length > SHOWN ? (
        <p class="quiet">{fillWords(text.result.more, { n: faults.length - SHOWN })}</p>
      ) : null}
    </section>
  );
}

/** Symmetries: those that hold, and those that the program has found. */
export function SymmetrySection() {
  const page = usePage();
  const held = page.store.sketch.value.symmetries ?? [];
  const found = page.foundSymmetries.value.filter(
    (symmetry) => !held.some((each) => isSameSymmetry(each, symmetry)),
  );
  if (held.length + found.length === 0) {
    return null;
  }
  return (
    <Section title={text.symmetry.title} note={note(held.length, found.length)}>
      <p class="quiet">{text.symmetry.text}</p>
      <ul class="symmetries">
        {held.map((symmetry, index) => (
          <li key={JSON.stringify(symmetry)}>
            <label class="check-row">
              <input type="checkbox" checked onChange={() => page.dropSymmetry(index)} />
              <span>{symmetryName(symmetry)}</span>
            </label>
          </li>
        ))}
        {found.map((symmetry) => (
          <Found key={JSON.stringify(symmetry)} symmetry={symmetry} />
        ))}
      </ul>
      <Differences />
    </Section>
  );
}

/** Where the model's sides differ although a symmetry is kept. */
function Differences() {
  const page = usePage();
  const stretches = page.stale.value ? [] : (page.result.value?.report.asymmetric ?? []);
  if (stretches.length === 0) {
    return null;
  }
  return (
    <>
      <p class="quiet">{text.symmetry.differs}</p>
      <ul class="symmetries" data-testid="differences">
        {stretches.slice(0, SHOWN).map((stretch) => (
          <li key={JSON.stringify(stretch)}>
            <button type="button" class="problem" onClick={() => page.showPlace(middleOf(stretch))}>
              <Icon name="info" />
              <span>
                {formatPoint(stretch.from)} – {formatPoint(stretch.to)}
              </span>
            </button>
          </li>
        ))}
      </ul>
      {stretches.length > SHOWN ? (
        <p class="quiet">{fillWords(text.result.more, { n: stretches.length - SHOWN })}</p>
      ) : null}
    </>
  );
}

function middleOf({ from, to }: Stretch): Vec3 {
  return [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2];
}

/** A symmetry shows itself in the scene while one is about to confirm it. */
function Found({ symmetry }: { readonly symmetry: FoundSymmetry }) {
  const page = usePage();
  const mine = useRef(false);
  const propose = (shown: FoundSymmetry | null) => {
    mine.current = shown !== null;
    page.proposedSymmetry.value = shown;
  };
  // A row that goes from under the pointer, as the list is found anew, is not left by it.
  useEffect(
    () => () => {
      if (mine.current) {
        page.proposedSymmetry.value = null;
      }
    },
    [page],
  );
  return (
    <li onPointerEnter={() => propose(symmetry)} onPointerLeave={() => propose(null)}>
      {symmetry.kind === 'rotation' ? (
        <span class="check-row">{symmetryName(symmetry)}</span>
      ) : (
        <label class="check-row">
          <input
            type="checkbox"
            checked={false}
            onFocus={() => propose(symmetry)}
            onBlur={() => propose(null)}
            onChange={() => page.confirmSymmetry(symmetry)}
          />
          <span>{symmetryName(symmetry)}</span>
          <span class="quiet">{text.symmetry.found}</span>
        </label>
      )}
    </li>
  );
}

function note(held: number, found: number): string {
  if (held > 0) {
    return fillWords(text.symmetry.heldNote, { n: held });
  }
  return found > 0 ? fillWords(text.symmetry.foundNote, { n: found }) : '';
}

function symmetryName(symmetry: FoundSymmetry): string {
  switch (symmetry.kind) {
    case 'reflection':
      return planeName(symmetry);
    case 'translation':
      return fillWords(text.symmetry.translation, {
        n: symmetry.pairs.length,
        vector: symmetry.vector.map((x) => formatNumber(x, digitsOf(x))).join(', '),
      });
    case 'rotation':
      return fillWords(text.symmetry.rotation, { n: formatNumber(360 / symmetry.order, 0) });
  }
}

/** Such as `x = 4`, `x − y = 0` or, in a hexagon, `0.58x + y = 2`. */
function planeName({ normal, offset, lines }: Extract<SketchSymmetry, { kind: 'reflection' }>) {
  const most = Math.max(...normal.map(Math.abs));
  const terms = normal.flatMap((value, k) => {
    const size = Math.abs(value) / most;
    const factor = Math.abs(size - 1) < 1e-6 ? '' : formatNumber(size, 2);
    return size < 1e-9 ? [] : [{ name: `${factor}${['x', 'y', 'z'][k] ?? ''}`, minus: value < 0 }];
  });
  const left = terms
    .map(({ name, minus }, i) =>
      i === 0 ? `${minus ? '−' : ''}${name}` : `${minus ? '− ' : '+ '}${name}`,
    )
    .join(' ');
  const at = offset / most;
  const plane = `${left} = ${formatNumber(at, digitsOf(at))}`;
  return lines
    ? fillWords(text.symmetry.partPlane, { n: lines.length, plane })
    : fillWords(text.symmetry.plane, { plane });
}

function digitsOf(value: number): number {
  return Math.abs(value - Math.round(value)) < 1e-6 ? 0 : 1;
}
