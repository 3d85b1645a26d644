import {
  CircleGeometry,
  CylinderGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from 'three';
import type { JointFrame } from '../../geometry/joint-frame.ts';
import { cross, type Vec3 } from '../../geometry/vec.ts';
import { handlePlaces, type JointHandle, ringRadius } from '../joint-ring.ts';
import { ThickLines } from '../sketch/thick-lines.ts';
import type { OverlayContext, SceneOverlay } from './overlay.ts';

/** A joint that is being changed. */
export interface ShownJoint {
  readonly frame: JointFrame;
  readonly range: readonly [number, number] | null;
  /** Lines at the joint and what goes with them, sRGB. */
  readonly lines: readonly {
    readonly from: Vec3;
    readonly to: Vec3;
    readonly colour: number;
    /** The line is at the joint itself. */
    readonly own: boolean;
  }[];
  /** Of what turns. */
  readonly colour: number;
  /** What the pointer is over or drags. */
  readonly active: JointHandle | null;
}

/** Parts of a ring of radius 1. */
const RING = { tube: 0.022, axis: 0.028, ball: 0.11, active: 0.15, reach: 1.35 } as const;
const RADIANS = Math.PI / 180;
const ORDER = 20;

/** The ring of a joint with its axis, its range and what moves. */
export class JointOverlay implements SceneOverlay {
  readonly object = new Group();
  readonly #ring = new Group();
  readonly #own = new ThickLines({ width: 6, renderOrder: ORDER - 2 });
  readonly #others = new ThickLines({ width: 3.5, renderOrder: ORDER - 3, opacity: 0.75 });
  #shown: ShownJoint | null = null;
  #context: OverlayContext | null = null;

  constructor() {
    for (const lines of [this.#others, this.#own]) {
      lines.setOverlay('over');
      this.object.add(lines.object);
    }
    this.#ring.matrixAutoUpdate = false;
    this.object.add(this.#ring);
  }

  set(shown: ShownJoint): void {
    this.#shown = shown;
    this.#rebuild();
    this.#context?.invalidate();
  }

  attach(context: OverlayContext): void {
    this.#context = context;
    this.#rebuild();
    context.invalidate();
  }

  /** The ring keeps its size on screen. */
  update(context: OverlayContext): void {
    this.#context = context;
    this.#own.setResolution(context.width, context.height);
    this.#others.setResolution(context.width, context.height);
    if (!this.#shown) {
      return;
    }
    const { at, axis, zero } = this.#shown.frame;
    const radius = ringRadius(context.pixelsPerModule);
    this.#ring.matrix
      .makeBasis(new Vector3(...zero), new Vector3(...cross(axis, zero)), new Vector3(...axis))
      .scale(new Vector3(radius, radius, radius))
      .setPosition(...at);
    this.#ring.matrixWorldNeedsUpdate = true;
  }

  dispose(): void {
    this.#clear();
    this.#own.dispose();
    this.#others.dispose();
  }

  #clear(): void {
    for (const child of [...this.#ring.children]) {
      this.#ring.remove(child);
      if (child instanceof Mesh) {
        child.geometry.dispose();
        child.material.dispose();
      }
    }
  }

  #rebuild(): void {
    this.#clear();
    const shown = this.#shown;
    if (!shown) {
      return;
    }
    this.#own.set(shown.lines.filter(({ own }) => own));
    this.#others.set(shown.lines.filter(({ own }) => !own));
    const theme = this.#context?.theme;
    const colour = theme?.joint ?? 0xc25a00;
    this.#ring.add(new Mesh(new TorusGeometry(1, RING.tube, 8, 72), paint(colour)));
    const rod = new Mesh(
      new CylinderGeometry(RING.axis, RING.axis, 2 * RING.reach, 10),
      paint(colour),
    );
    rod.rotation.x = Math.PI / 2;
    this.#ring.add(rod);
    if (shown.range) {
      this.#ring.add(sector(shown.range, shown.colour));
    }
    this.#addHandles(shown, colour);
    for (const child of this.#ring.children) {
      child.renderOrder = Math.max(child.renderOrder, ORDER);
    }
  }

  #addHandles({ range, active }: ShownJoint, colour: number): void {
    const selected = this.#context?.theme.selected ?? colour;
    const unit: JointFrame = { at: [0, 0, 0], axis: [0, 0, 1], zero: [1, 0, 0] };
    const places = handlePlaces(unit, range ?? undefined, 1);
    for (const handle of ['axis', 'axisEnd', 'from', 'to'] as const) {
      const lit = handle === active;
      const ball = new Mesh(
        new SphereGeometry(lit ? RING.active : RING.ball, 20, 14),
        paint(lit ? selected : colour),
      );
      ball.position.set(...places[handle]);
      ball.renderOrder = ORDER + 2;
      this.#ring.add(ball);
      if (!range && (handle === 'from' || handle === 'to')) {
        ball.scale.setScalar(0.8);
      }
    }
  }
}

function sector([from, to]: readonly [number, number], colour: number): Object3D {
  const material = paint(colour, 0.32);
  material.side = DoubleSide;
  const geometry = new CircleGeometry(1, 72, from * RADIANS, (to - from) * RADIANS);
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = ORDER - 1;
  return mesh;
}

/** Seen through bricks: the middle of a joint is inside them. */
function paint(color: number, opacity = 1): MeshBasicMaterial {
  return new MeshBasicMaterial({
    color,
    opacity,
    transparent: true,
    depthTest: false,
    depthWrite: false,
  });
}
