import { lerp, samePoint, type Vec3 } from '../geometry/vec.ts';
import { lineLength, type SketchDocument } from '../model/sketch.ts';
import { freerEnd, type LineEnd } from '../state/line-length.ts';
import { fillWords } from '../tools/tool-words.ts';
import { formatPoint } from '../ui/text/language.ts';
import { text } from '../ui/text.ts';
import type { Projected } from '../view/view-types.ts';

const SVG = 'http://www.w3.org/2000/svg';
/** Shorter ones on screen have no room for their number, CSS pixels. */
const LEAST_PIXELS = 34;
/** Beside its line, CSS pixels. */
const BESIDE = 17;
/** More numbers than these nobody reads. */
const MOST = 150;

interface Row {
  readonly index: number;
  readonly from: Vec3;
  readonly to: Vec3;
}

/** A line, the end of it that moves, and how long it is to be. */
export interface LengthWish {
  readonly index: number;
  readonly end: LineEnd;
  readonly length: number;
}

interface Options {
  /** @returns why a line cannot be so long, in words; null when it is. */
  readonly onLength: (wish: LengthWish) => string | null;
  /** Gives the keys back to the drawing. */
  readonly leave: () => void;
  /** Asks for place() again. */
  readonly replace: () => void;
}

/** Lengths beside their lines; that of a line selected alone can be changed in its place. */
export class SceneDimensions {
  readonly element = document.createElement('div');
  readonly #options: Options;
  readonly #field = new LengthField();
  #rows: readonly Row[] = [];
  #edited: Row | null = null;
  #end: LineEnd = 'to';

  constructor(options: Options) {
    this.#options = options;
    this.element.className = 'scene-dimensions';
    this.#field.form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#submit();
    });
    this.#field.input.addEventListener('keydown', (event) => this.#onKey(event));
    this.#field.side.addEventListener('click', () => {
      this.#end = this.#end === 'to' ? 'from' : 'to';
      this.#tellEnd();
    });
  }

  /**
   * @param shown lines with a number.
   * @param edited the one whose number can be changed, if any.
   */
  set(sketch: SketchDocument, shown: Iterable<number>, edited: number | null): void {
    const rows = [...shown].slice(0, MOST).flatMap((index) => {
      const line = sketch.lines[index];
      return line ? [{ index, from: line.from, to: line.to }] : [];
    });
    this.#rows = rows.filter(({ index }) => index !== edited);
    this.#setEdited(rows.find(({ index }) => index === edited) ?? null, sketch);
    const labels = this.#rows.map((row) => {
      const label = document.createElement('span');
      label.className = 'dimension';
      label.textContent = lengthText(row);
      label.setAttribute('aria-hidden', 'true');
      return label;
    });
    if (this.#edited && !this.#field.form.isConnected) {
      this.element.append(this.#field.form);
    }
    for (const label of this.element.querySelectorAll('.dimension:not(form)')) {
      label.remove();
    }
    this.element.append(...labels);
    if (!this.#edited) {
      this.#field.form.remove();
    }
  }

  /** A digit that is typed over the drawing begins the length. @returns whether it did. */
  type(key: string): boolean {
    if (!this.#edited || !/^[1-9]$/.test(key)) {
      return false;
    }
    this.#field.begin(key);
    return true;
  }

  /** They follow their lines on screen. */
  place(project: (at: Vec3) => Projected): void {
    const labels = this.element.querySelectorAll<HTMLElement>('span.dimension');
    this.#rows.forEach((row, i) => {
      const label = labels[i];
      if (label) {
        placeBeside(label, row, project);
      }
    });
    if (this.#edited) {
      const { from, to } = this.#edited;
      placeBeside(this.#field.form, this.#edited, project, 'always');
      const [a, b] = [project(from), project(to)];
      const way = this.#end === 'to' ? 1 : -1;
      this.#field.turn(Math.atan2(way * (b.y - a.y), way * (b.x - a.x)));
    }
  }

  #setEdited(row: Row | null, sketch: SketchDocument): void {
    const same = row?.index === this.#edited?.index;
    this.#edited = row;
    if (!row) {
      return;
    }
    if (!same) {
      this.#end = freerEnd(sketch, row.index);
    }
    this.#field.show(row.index, lengthText(row));
    this.#tellEnd();
  }

  #tellEnd(): void {
    if (this.#edited) {
      this.#field.tellEnd(this.#edited[this.#end]);
      this.#options.replace();
    }
  }

  #submit(): void {
    const { input } = this.#field;
    if (!this.#edited) {
      return;
    }
    const length = Number(input.value);
    const refused = this.#options.onLength({ index: this.#edited.index, end: this.#end, length });
    this.#field.refuse(refused);
    if (refused === null) {
      this.#options.leave();
    }
  }

  #onKey(event: KeyboardEvent): void {
    if (event.key === 'Escape' && this.#edited) {
      event.stopPropagation();
      this.#field.restore(lengthText(this.#edited));
      this.#options.leave();
    }
  }
}

/** A number that can be changed, and an arrow that says which end of the line will move. */
class LengthField {
  readonly form = document.createElement('form');
  readonly input = document.createElement('input');
  readonly side = document.createElement('button');
  readonly #refusal = document.createElement('span');
  readonly #arrow = document.createElementNS(SVG, 'svg');

  constructor() {
    const path = document.createElementNS(SVG, 'path');
    path.setAttribute('d', 'M3 10h13M11 5l5 5-5 5');
    this.#arrow.setAttribute('viewBox', '0 0 20 20');
    this.#arrow.setAttribute('aria-hidden', 'true');
    this.#arrow.append(path);
    this.side.type = 'button';
    this.side.append(this.#arrow);
    this.input.inputMode = 'numeric';
    this.input.autocomplete = 'off';
    this.input.maxLength = 3;
    this.#refusal.setAttribute('role', 'alert');
    this.#refusal.hidden = true;
    this.form.className = 'dimension';
    this.form.append(this.input, this.side, this.#refusal);
    this.input.addEventListener('focus', () => this.input.select());
    this.input.addEventListener('input', () => this.refuse(null));
  }

  /** The length as it is drawn; what is being typed is left in peace. */
  show(index: number, value: string): void {
    this.input.setAttribute('aria-label', fillWords(text.draw.lengthOf, { i: index + 1 }));
    if (this.input.dataset['shown'] !== `${index} ${value}`) {
      this.input.dataset['shown'] = `${index} ${value}`;
      this.restore(value);
    }
  }

  restore(value: string): void {
    this.input.value = value;
    this.refuse(null);
  }

  begin(digit: string): void {
    this.input.focus({ preventScroll: true });
    this.input.value = digit;
    this.refuse(null);
  }

  tellEnd(at: Vec3): void {
    const words = fillWords(text.draw.movesEnd, { at: formatPoint(at) });
    this.side.setAttribute('aria-label', words);
    this.side.title = words;
  }

  /** @param angle on screen, radians, clockwise from the right. */
  turn(angle: number): void {
    this.#arrow.style.transform = `rotate(${Math.round((angle * 180) / Math.PI)}deg)`;
  }

  refuse(why: string | null): void {
    this.#refusal.hidden = why === null;
    this.#refusal.textContent = why ?? '';
    this.input.setAttribute('aria-invalid', String(why !== null));
  }
}

function lengthText({ from, to }: Row): string {
  return String(Math.round(100 * lineLength({ from, to })) / 100);
}

/** Beside the middle of the line, on its upper side; hidden where the line is too short to read it. */
function placeBeside(
  label: HTMLElement,
  { from, to }: Row,
  project: (at: Vec3) => Projected,
  when: 'long' | 'always' = 'long',
): void {
  const [a, b, at] = [project(from), project(to), project(lerp(from, to, 0.5))];
  const span = Math.hypot(b.x - a.x, b.y - a.y);
  label.hidden = !at.visible || (when === 'long' && span < LEAST_PIXELS);
  if (label.hidden || samePoint(from, to, 1e-6)) {
    return;
  }
  const across = span > 1 ? [(b.y - a.y) / span, -(b.x - a.x) / span] : [0, -1];
  const side = (across[1] ?? 0) > 0 || ((across[1] ?? 0) === 0 && (across[0] ?? 0) < 0) ? -1 : 1;
  const x = Math.round(at.x + side * BESIDE * (across[0] ?? 0));
  const y = Math.round(at.y + side * BESIDE * (across[1] ?? 0));
  label.style.transform = `translate(${x}px, ${y}px) translate(-50%, -50%)`;
}
