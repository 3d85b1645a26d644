import {
  BoxGeometry,
  type BufferGeometry,
  CylinderGeometry,
  DoubleSide,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Quaternion,
  TorusGeometry,
  Vector3,
} from 'three';
import { type Bounds, sketchBounds } from '../../model/bounds.ts';
import type { KeepOutBox, SketchDocument, SketchJoint } from '../../model/sketch.ts';
import type { Vec3 } from '../../model/vec.ts';
import type { ViewTheme } from '../scene/theme.ts';
import type { SketchMarks } from '../view-types.ts';

/** Modules. */
const JOINT = { radius: 0.55, tube: 0.07, axisLength: 2.2, axisRadius: 0.05 } as const;
const SYMMETRY_MARGIN = 2;
const UP = new Vector3(0, 0, 1);
const Y = new Vector3(0, 1, 0);

/** Joints, keep-out boxes and mirror planes of a sketch. Few, so each is its own object. */
export class SketchGlyphs {
  readonly group = new Group();
  readonly #owned: (BufferGeometry | Material)[] = [];
  #shown: readonly unknown[] = [];

  set(sketch: SketchDocument | null, marks: SketchMarks, theme: ViewTheme): void {
    const proposed = marks.proposedMirror ?? null;
    const shown = [sketch, marks.selectedJoint ?? null, proposed, theme];
    // Hovering over lines must not make all of this again.
    if (shown.every((value, i) => value === this.#shown[i])) {
      return;
    }
    this.#shown = shown;
    this.#clear();
    if (!sketch) {
      return;
    }
    sketch.joints?.forEach((joint, index) => {
      const chosen = marks.selectedJoint === index;
      this.#addJoint(joint, chosen ? theme.selected : theme.joint);
    });
    for (const box of sketch.keepOut ?? []) {
      this.#addKeepOut(box, theme.keepOut);
    }
    const bounds = sketchBounds(sketch);
    for (const symmetry of sketch.symmetries ?? []) {
      if (symmetry.kind === 'reflection' && bounds) {
        this.#addMirror(symmetry, bounds, theme.symmetry);
      }
    }
    if (proposed && bounds) {
      this.#addMirror(proposed, bounds, theme.hovered);
    }
  }

  dispose(): void {
    this.#clear();
  }

  #clear(): void {
    this.group.clear();
    for (const item of this.#owned) {
      item.dispose();
    }
    this.#owned.length = 0;
  }

  #own<T extends BufferGeometry | Material>(item: T): T {
    this.#owned.push(item);
    return item;
  }

  #addJoint(joint: SketchJoint, colour: number): void {
    const material = this.#own(new MeshBasicMaterial({ color: colour }));
    const ring = new Mesh(this.#own(new TorusGeometry(JOINT.radius, JOINT.tube, 8, 40)), material);
    const axis = new Mesh(
      this.#own(new CylinderGeometry(JOINT.axisRadius, JOINT.axisRadius, JOINT.axisLength, 10)),
      material,
    );
    const direction = new Vector3(...joint.axis).normalize();
    ring.quaternion.copy(new Quaternion().setFromUnitVectors(UP, direction));
    axis.quaternion.copy(new Quaternion().setFromUnitVectors(Y, direction));
    for (const mesh of [ring, axis]) {
      mesh.position.set(...joint.at);
      mesh.renderOrder = 13;
      this.group.add(mesh);
    }
  }

  /** Cells by their centres: the box reaches half a module further than its corners. */
  #addKeepOut(box: KeepOutBox, colour: number): void {
    const size: Vec3 = [
      box.max[0] - box.min[0] + 1,
      box.max[1] - box.min[1] + 1,
      box.max[2] - box.min[2] + 1,
    ];
    const geometry = this.#own(new BoxGeometry(...size));
    const body = new Mesh(geometry, this.#own(glass(colour, 0.14)));
    const edges = new LineSegments(
      this.#own(new EdgesGeometry(geometry)),
      this.#own(new LineBasicMaterial({ color: colour })),
    );
    for (const object of [body, edges]) {
      object.position.set(
        (box.min[0] + box.max[0]) / 2,
        (box.min[1] + box.max[1]) / 2,
        (box.min[2] + box.max[2]) / 2,
      );
      object.renderOrder = 14;
      this.group.add(object);
    }
  }

  #addMirror(
    mirror: { readonly normal: Vec3; readonly offset: number },
    bounds: Bounds,
    colour: number,
  ): void {
    const normal = new Vector3(...mirror.normal);
    const scale = 1 / (normal.lengthSq() || 1);
    const middle = new Vector3(...bounds.min).add(new Vector3(...bounds.max)).multiplyScalar(0.5);
    const off = mirror.offset - normal.dot(middle);
    middle.addScaledVector(normal, off * scale);
    const size = Math.hypot(
      bounds.max[0] - bounds.min[0],
      bounds.max[1] - bounds.min[1],
      bounds.max[2] - bounds.min[2],
    );
    const side = size + 2 * SYMMETRY_MARGIN;
    const geometry = this.#own(new PlaneGeometry(side, side));
    const pane = new Mesh(geometry, this.#own(glass(colour, 0.1)));
    const frame = new LineSegments(
      this.#own(new EdgesGeometry(geometry)),
      this.#own(new LineBasicMaterial({ color: colour })),
    );
    for (const object of [pane, frame]) {
      object.position.copy(middle);
      object.quaternion.setFromUnitVectors(UP, normal.clone().normalize());
      object.renderOrder = 14;
      this.group.add(object);
    }
  }
}

function glass(color: number, opacity: number): MeshBasicMaterial {
  return new MeshBasicMaterial({
    color,
    opacity,
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
  });
}
