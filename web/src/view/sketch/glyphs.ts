import {
  ArrowHelper,
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
import type { Vec3 } from '../../geometry/vec.ts';
import { type Bounds, sketchBounds } from '../../model/bounds.ts';
import type { FoundSymmetry, RotationSymmetry } from '../../model/found-symmetries.ts';
import type { Drive, Shaft } from '../../model/shafts.ts';
import type { KeepOutBox, SketchDocument, SketchJoint, SketchLine } from '../../model/sketch.ts';
import type { ViewTheme } from '../scene/theme.ts';
import type { SketchMarks } from '../view-types.ts';

/** Modules. */
const JOINT = { radius: 0.55, tube: 0.07, axisLength: 2.2, axisRadius: 0.05 } as const;
const SHAFT_RADIUS = 0.16;
const WHEEL_RADIUS = 2.335;
const DRIVE_RADIUS = 0.06;
const SYMMETRY_MARGIN = 2;
const SHIFT_HEAD = 0.8;
const UP = new Vector3(0, 0, 1);
const Y = new Vector3(0, 1, 0);

/** Joints, keep-out boxes, shafts and symmetries of a sketch. Few, so each is its own object. */
export class SketchGlyphs {
  readonly group = new Group();
  readonly #owned: (BufferGeometry | Material)[] = [];
  #shown: readonly unknown[] = [];

  set(sketch: SketchDocument | null, marks: SketchMarks, theme: ViewTheme): void {
    const proposed = marks.proposedSymmetry ?? null;
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
    this.#addShafts(sketch.shafts ?? [], sketch.drives ?? [], theme.joint);
    const bounds = sketchBounds(sketch);
    if (!bounds) {
      return;
    }
    for (const symmetry of sketch.symmetries ?? []) {
      this.#addSymmetry(symmetry, { sketch, bounds, colour: theme.symmetry });
    }
    if (proposed) {
      this.#addSymmetry(proposed, { sketch, bounds, colour: theme.hovered });
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
    const direction = new Vector3(...joint.axis).normalize();
    const axis = this.#rod(direction, JOINT.axisLength, material);
    ring.quaternion.copy(new Quaternion().setFromUnitVectors(UP, direction));
    for (const mesh of [ring, axis]) {
      mesh.position.set(...joint.at);
      mesh.renderOrder = 13;
      this.group.add(mesh);
    }
  }

  /** A rod for each shaft from the first of its slots to the last, a thin one between the middles of coupled shafts. */
  #addShafts(shafts: readonly Shaft[], drives: readonly Drive[], colour: number): void {
    const material = this.#own(new MeshBasicMaterial({ color: colour }));
    const ends = shafts.map(({ from, to }) => [new Vector3(...from), new Vector3(...to)] as const);
    for (const [from, to] of ends) {
      this.#addRod(from, to, { radius: SHAFT_RADIUS, beyond: 0.5 }, material);
    }
    for (const [i, { atFrom, atTo }] of shafts.entries()) {
      const [from, to] = ends[i] ?? [];
      if (from && to) {
        this.#addShaftEnd(from, from.clone().sub(to).normalize(), atFrom, material);
        this.#addShaftEnd(to, to.clone().sub(from).normalize(), atTo, material);
      }
    }
    const middles = ends.map(([from, to]) => from.clone().add(to).multiplyScalar(0.5));
    for (const drive of drives) {
      const [from, to] = [middles[drive.from], middles[drive.to]];
      if (from && to) {
        this.#addRod(from, to, { radius: DRIVE_RADIUS, beyond: 0 }, material);
      }
    }
  }

  /** A disc for a wheel; for a crank an arm, and a handle that goes out. */
  #addShaftEnd(end: Vector3, out: Vector3, what: Shaft['atTo'], material: Material): void {
    if (what === 'wheel') {
      this.#addRod(end, end.clone().add(out), { radius: WHEEL_RADIUS, beyond: -0.4 }, material);
    }
    if (what === 'crank') {
      const aside = end.clone().add(new Vector3(out.y, out.z, out.x));
      this.#addRod(end, aside, { radius: SHAFT_RADIUS, beyond: 0 }, material);
      const handle = aside.clone().add(out);
      this.#addRod(aside, handle, { radius: SHAFT_RADIUS, beyond: 0 }, material);
    }
  }

  /** From point to point and a bit beyond. */
  #addRod(
    from: Vector3,
    to: Vector3,
    { radius, beyond }: { readonly radius: number; readonly beyond: number },
    material: Material,
  ): void {
    const way = to.clone().sub(from);
    const geometry = this.#own(new CylinderGeometry(radius, radius, way.length() + 2 * beyond, 12));
    const rod = new Mesh(geometry, material);
    rod.quaternion.setFromUnitVectors(Y, way.normalize());
    rod.position.copy(from).add(to).multiplyScalar(0.5);
    rod.renderOrder = 13;
    this.group.add(rod);
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

  /** A plane for a mirror, arrows for a shift, an axis for a turn. */
  #addSymmetry(
    symmetry: FoundSymmetry,
    { sketch, bounds, colour }: { sketch: SketchDocument; bounds: Bounds; colour: number },
  ): void {
    switch (symmetry.kind) {
      case 'reflection':
        this.#addMirror(symmetry, bounds, colour);
        break;
      case 'translation':
        for (const [first] of symmetry.pairs) {
          this.#addShift(sketch.lines[first], symmetry.vector, colour);
        }
        break;
      case 'rotation':
        this.#addAxis(symmetry, bounds, colour);
        break;
    }
  }

  /** From the middle of a line to that of its image. */
  #addShift(line: SketchLine | undefined, vector: Vec3, colour: number): void {
    if (!line) {
      return;
    }
    const from = new Vector3(...line.from).add(new Vector3(...line.to)).multiplyScalar(0.5);
    const way = new Vector3(...vector);
    const length = way.length();
    const arrow = new ArrowHelper(
      way.normalize(),
      from,
      length,
      colour,
      SHIFT_HEAD,
      SHIFT_HEAD / 2,
    );
    this.#own(arrow.line.geometry);
    this.#own(arrow.line.material as Material);
    this.#own(arrow.cone.geometry);
    this.#own(arrow.cone.material as Material);
    arrow.renderOrder = 14;
    this.group.add(arrow);
  }

  /** A thin rod about the origin; `direction` has unit length. */
  #rod(direction: Vector3, length: number, material: Material): Mesh {
    const { axisRadius } = JOINT;
    const rod = new Mesh(
      this.#own(new CylinderGeometry(axisRadius, axisRadius, length, 10)),
      material,
    );
    rod.quaternion.setFromUnitVectors(Y, direction);
    return rod;
  }

  #addAxis({ axis, point }: RotationSymmetry, bounds: Bounds, colour: number): void {
    const length = sizeOf(bounds) + 2 * SYMMETRY_MARGIN;
    const direction = new Vector3(...axis).normalize();
    const material = this.#own(new MeshBasicMaterial({ color: colour }));
    const rod = this.#rod(direction, length, material);
    const middle = new Vector3(...bounds.min).add(new Vector3(...bounds.max)).multiplyScalar(0.5);
    const start = new Vector3(...point);
    rod.position.copy(start).addScaledVector(direction, middle.sub(start).dot(direction));
    rod.renderOrder = 14;
    this.group.add(rod);
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
    const side = sizeOf(bounds) + 2 * SYMMETRY_MARGIN;
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

/** From one corner of a box to the far one. */
function sizeOf({ min, max }: Bounds): number {
  return Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
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
