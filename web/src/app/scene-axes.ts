import { AXIS_NAMES, add, scale, unitVector, type Vec3 } from '../geometry/vec.ts';
import type { Projected, Ray } from '../view/view-types.ts';

/** What the axes need of the view. */
export interface AxesView {
  screenToRay(x: number, y: number): Ray;
  project(point: Vec3): Projected;
}

/** Length of the longest arm, and from the tip of an arm to its letter, CSS pixels. */
const ARM = 22;
const LETTER = 8;
/** How far before the eye the axes are looked at, modules. */
const AWAY = 40;

const SVG = 'http://www.w3.org/2000/svg';

/** Three arms with the letters X, Y and Z in a corner of the drawing: which way is which, however it is turned. */
export class SceneAxes {
  readonly element = document.createElementNS(SVG, 'svg');
  readonly #arms = AXIS_NAMES.map((name) => {
    const line = document.createElementNS(SVG, 'line');
    const letter = document.createElementNS(SVG, 'text');
    letter.textContent = name.toUpperCase();
    const group = document.createElementNS(SVG, 'g');
    group.setAttribute('class', `axis-${name}`);
    group.append(line, letter);
    this.element.append(group);
    return { name, line, letter };
  });

  constructor() {
    const half = ARM + 2 * LETTER;
    this.element.setAttribute('class', 'scene-axes');
    this.element.setAttribute('viewBox', `${-half} ${-half} ${2 * half} ${2 * half}`);
    this.element.setAttribute('aria-hidden', 'true');
  }

  /** Turns them as the view is turned; `host` is the element that it fills. */
  place(view: AxesView, host: { readonly clientWidth: number; readonly clientHeight: number }) {
    const { origin, direction } = view.screenToRay(host.clientWidth / 2, host.clientHeight / 2);
    const middle = add(origin, scale(direction, AWAY));
    const from = view.project(middle);
    const ends = this.#arms.map(({ name }) => {
      const to = view.project(add(middle, unitVector(name)));
      return { x: to.x - from.x, y: to.y - from.y };
    });
    const longest = Math.max(1e-6, ...ends.map(({ x, y }) => Math.hypot(x, y)));
    this.#arms.forEach(({ line, letter }, i) => {
      const { x, y } = ends[i] ?? { x: 0, y: 0 };
      const [dx, dy] = [(x * ARM) / longest, (y * ARM) / longest];
      const length = Math.hypot(dx, dy);
      line.setAttribute('x2', dx.toFixed(1));
      line.setAttribute('y2', dy.toFixed(1));
      // An axis that points at the eye is a dot: its letter stands beside it.
      const [ux, uy] = length < 1 ? [0.7, 0.7] : [dx / length, dy / length];
      letter.setAttribute('x', (dx + ux * LETTER).toFixed(1));
      letter.setAttribute('y', (dy + uy * LETTER).toFixed(1));
    });
  }
}
