import type { MirrorPlane } from '../geometry/mirrors.ts';
import type { SketchSymmetry } from '../model/sketch.ts';
import type { SketchFault } from '../state/sketch-faults.ts';
import { fillWords } from '../tools/tool-words.ts';
import { Section } from './controls.tsx';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { formatNumber } from './text/language.ts';
import { text } from './text.ts';

const SHOWN = 6;

/** What cannot be built, each with its mend. Nothing when all is well. */
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
          <li key={`${fault.kind}${fault.lines.join()}`} class="fault">
            <button type="button" class="problem" onClick={() => page.showPlace(fault.at)}>
              <Icon name="alert" />
              <span>{sentence(fault)}</span>
            </button>
            <button type="button" class="button secondary small" onClick={() => page.mend(fault)}>
              {fault.kind === 'twin' ? text.faults.mendTwin : text.faults.mendCrossing}
            </button>
          </li>
        ))}
      </ul>
      {faults.length > SHOWN ? (
        <p class="quiet">{fillWords(text.result.more, { n: faults.length - SHOWN })}</p>
      ) : null}
    </section>
  );
}

function sentence(fault: SketchFault): string {
  const [a, b] = fault.lines;
  const words = fault.kind === 'twin' ? text.faults.twin : text.faults.crossing;
  return fillWords(words, { a: a + 1, b: b + 1 });
}

/** Mirror planes: those that hold, and those that the program has found. */
export function SymmetrySection() {
  const page = usePage();
  const held = page.store.sketch.value.symmetries ?? [];
  const found = page.mirrors.value.filter((plane) => !held.some((each) => isPlane(each, plane)));
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
              <span>{heldName(symmetry)}</span>
            </label>
          </li>
        ))}
        {found.map((plane) => (
          <FoundMirror key={JSON.stringify(plane)} plane={plane} />
        ))}
      </ul>
    </Section>
  );
}

/** A plane shows itself in the scene while one is about to confirm it. */
function FoundMirror({ plane }: { readonly plane: MirrorPlane }) {
  const page = usePage();
  const propose = (shown: MirrorPlane | null) => {
    page.proposedMirror.value = shown;
  };
  return (
    <li onPointerEnter={() => propose(plane)} onPointerLeave={() => propose(null)}>
      <label class="check-row">
        <input
          type="checkbox"
          checked={false}
          onFocus={() => propose(plane)}
          onBlur={() => propose(null)}
          onChange={() => page.confirmMirror(plane)}
        />
        <span>{planeName(plane)}</span>
        <span class="quiet">{text.symmetry.found}</span>
      </label>
    </li>
  );
}

function note(held: number, found: number): string {
  if (held > 0) {
    return fillWords(text.symmetry.heldNote, { n: held });
  }
  return found > 0 ? fillWords(text.symmetry.foundNote, { n: found }) : '';
}

function heldName(symmetry: SketchSymmetry): string {
  return symmetry.kind === 'reflection' ? planeName(symmetry) : text.symmetry.translation;
}

/** Such as `x = 4` or `x − y = 0`. */
function planeName({ normal, offset }: MirrorPlane): string {
  const terms = normal.flatMap((value, k) => {
    const name = ['x', 'y', 'z'][k] ?? '';
    return Math.abs(value) < 1e-9 ? [] : [{ name, minus: value < 0 }];
  });
  const left = terms
    .map(({ name, minus }, i) =>
      i === 0 ? `${minus ? '−' : ''}${name}` : `${minus ? '− ' : '+ '}${name}`,
    )
    .join(' ');
  const digits = Math.abs(offset - Math.round(offset)) < 1e-6 ? 0 : 1;
  return fillWords(text.symmetry.plane, { plane: `${left} = ${formatNumber(offset, digits)}` });
}

function isPlane(symmetry: SketchSymmetry, plane: MirrorPlane): boolean {
  return (
    symmetry.kind === 'reflection' &&
    symmetry.lines === undefined &&
    symmetry.normal.every((value, k) => Math.abs(value - plane.normal[k as 0 | 1 | 2]) < 1e-6) &&
    Math.abs(symmetry.offset - plane.offset) < 1e-6
  );
}
