import type { Vec3 } from '../geometry/vec.ts';
import type { OverlayLabel } from '../tools/tool.ts';
import type { Projected } from '../view/view-types.ts';

/** From the point that it tells of, CSS pixels. */
const OFFSET = 16;

/** A mark for each reason to snap, in a box of 14 by 14. */
const MARKS: Readonly<Record<OverlayLabel['kind'], string>> = {
  grid: 'M7 2v10M2 7h10',
  plane: 'M1.5 10 4.5 4h8l-3 6z',
  end: 'M3 3h8v8H3z',
  node: 'M1 7h3M10 7h3M7 4a3 3 0 1 0 0 6 3 3 0 0 0 0-6z',
  axis: 'M2 12 12 2M7.5 2H12v4.5',
  'in-line': 'M2 9 9 2M5 12l7-7',
  pythagorean: 'M2 12V2l10 10zM2 9h3v3',
  sixty: 'M1.5 12 7 2.5 12.5 12z',
  invalid: 'M3 3l8 8M11 3l-8 8',
};

/** The small text beside the end of the line that is being drawn: its length, and why it snaps. */
export class SceneLabel {
  readonly element = document.createElement('div');
  readonly #mark: SVGPathElement;
  readonly #main = document.createElement('strong');
  readonly #note = document.createElement('span');
  #at: Vec3 | null = null;

  constructor() {
    const picture = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    this.#mark = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    picture.setAttribute('viewBox', '0 0 14 14');
    picture.setAttribute('aria-hidden', 'true');
    picture.append(this.#mark);
    this.element.className = 'scene-label';
    this.element.hidden = true;
    this.element.append(picture, this.#main, this.#note);
  }

  set(label: OverlayLabel | null): void {
    this.#at = label?.at ?? null;
    this.element.hidden = label === null;
    if (label) {
      this.element.dataset['kind'] = label.kind;
      this.#mark.setAttribute('d', MARKS[label.kind]);
      this.#main.textContent = label.main;
      this.#note.textContent = label.note;
    }
  }

  /** Follows its point on screen. */
  place(project: (at: Vec3) => Projected): void {
    if (this.#at) {
      const { x, y } = project(this.#at);
      const place = `translate(${Math.round(x + OFFSET)}px, ${Math.round(y + OFFSET)}px)`;
      this.element.style.transform = place;
    }
  }
}
