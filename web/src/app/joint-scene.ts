import { bodiesOfLines, bodyColour } from '../model/line-bodies.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { bodiesOf, jointIndex } from '../state/joint-edits.ts';
import { frameOf, type JointHandle } from '../view/joint-ring.ts';
import { JointOverlay, type ShownJoint } from '../view/overlays/joint-overlay.ts';
import type { SceneView } from '../view/scene-view.ts';
import type { PageState } from './page-state.ts';

/** Shows the joint that is being changed: its ring, its range and what moves. */
export class JointScene {
  #overlay: JointOverlay | null = null;
  #remove: (() => void) | null = null;

  /** Reads the signals that it depends on. */
  show(view: SceneView | null, state: PageState, active: JointHandle | null): void {
    const tool = state.tool.value;
    const sketch = state.store.sketch.value;
    const index = tool.id === 'joint' ? jointIndex(sketch, state.joint.value) : null;
    if (index === null || !view) {
      this.clear();
      return;
    }
    const shown = shownJoint(sketch, index, active);
    if (!shown) {
      this.clear();
      return;
    }
    if (!this.#overlay) {
      this.#overlay = new JointOverlay();
      this.#remove = view.addOverlay(this.#overlay);
    }
    this.#overlay.set(shown);
  }

  clear(): void {
    this.#remove?.();
    this.#remove = null;
    this.#overlay = null;
  }
}

function shownJoint(
  sketch: SketchDocument,
  index: number,
  active: JointHandle | null,
): ShownJoint | null {
  const joint = sketch.joints?.[index];
  if (!joint) {
    return null;
  }
  const bodies = bodiesOf(sketch, joint);
  const bodyOfLine = bodiesOfLines(sketch);
  const ownBody = (line: number) => bodies.findIndex((body) => body.includes(line));
  // What hangs on the lines of one side alone goes with them; a closed chain hangs on both.
  const sides = new Map<number, Set<number>>();
  bodies.forEach((lines, side) => {
    for (const line of lines) {
      const body = bodyOfLine[line] ?? -1;
      sides.set(body, (sides.get(body) ?? new Set()).add(side));
    }
  });
  const lines = sketch.lines.flatMap(({ from, to }, i) => {
    const own = ownBody(i);
    const carried = [...(sides.get(bodyOfLine[i] ?? -1) ?? [])];
    const [only, ...more] = carried;
    const body = own >= 0 ? own : more.length === 0 ? (only ?? -1) : -1;
    return body < 0 ? [] : [{ from, to, colour: bodyColour(body), own: own >= 0 }];
  });
  return {
    frame: frameOf(sketch, joint),
    range: joint.range ?? null,
    lines,
    colour: bodyColour(1),
    active,
  };
}
