import { add, normalize, scale, subtract, unitVector, type Vec3 } from '../geometry/vec.ts';
import type { Place } from '../model/keep.ts';
import type { SketchDocument } from '../model/sketch.ts';
import type { Projected } from '../view/view-types.ts';

const SVG = 'http://www.w3.org/2000/svg';
/** A padlock in a box of 20 by 20. */
const PADLOCK = 'M5.5 9h9v7h-9zM7.5 9V6.5a2.5 2.5 0 0 1 5 0V9';

/** The middle of a kept part, modules. */
export function middleOf(sketch: SketchDocument, { line, part }: Place): Vec3 {
  const { from, to } = sketch.lines[line] ?? { from: [0, 0, 0], to: [1, 0, 0] };
  const along = normalize(subtract(to, from));
  const on = add(from, scale(along, (part.from + part.to) / 2));
  return add(on, scale(unitVector(part.holeAxis), part.layer));
}

/** A padlock on every part of the model that is kept. */
export class SceneLocks {
  readonly element = document.createElement('div');
  #at: readonly Vec3[] = [];

  constructor() {
    this.element.className = 'scene-locks';
    this.element.setAttribute('aria-hidden', 'true');
  }

  set(sketch: SketchDocument): void {
    const places = (sketch.keep ?? []).flatMap(({ line, parts = [] }) =>
      parts.map((part) => ({ line, part })),
    );
    this.#at = places.map((place) => middleOf(sketch, place));
    while (this.element.childElementCount > this.#at.length) {
      this.element.lastElementChild?.remove();
    }
    while (this.element.childElementCount < this.#at.length) {
      this.element.append(badge());
    }
  }

  /** They follow their parts on screen. */
  place(project: (at: Vec3) => Projected): void {
    this.#at.forEach((at, i) => {
      const { x, y, visible } = project(at);
      const mark = this.element.children[i];
      if (mark instanceof HTMLElement) {
        mark.hidden = !visible;
        mark.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
      }
    });
  }
}

function badge(): HTMLElement {
  const mark = document.createElement('span');
  const picture = document.createElementNS(SVG, 'svg');
  const path = document.createElementNS(SVG, 'path');
  picture.setAttribute('viewBox', '0 0 20 20');
  path.setAttribute('d', PADLOCK);
  picture.append(path);
  mark.append(picture);
  return mark;
}
