import {
  ArrowHelper,
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  LineLoop,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  Shape,
  ShapeGeometry,
  SphereGeometry,
  Vector3,
} from 'three';
import type { Balance } from '../../model/motion.ts';
import type { OverlayContext, SceneOverlay } from './overlay.ts';

const GOOD = 0x2f9e5b;
const BALL = 0.35;
/** Above the floor, so that the two do not flicker. */
const LIFT = 0.02;
const FALL_ARROW = 3;

/** The area that a model stands on, its centre of mass, and the way in which it falls. */
export class BalanceOverlay implements SceneOverlay {
  readonly object = new Group();
  readonly #balance: Balance;
  #theme: OverlayContext['theme'] | null = null;

  constructor(balance: Balance) {
    this.#balance = balance;
  }

  attach(context: OverlayContext): void {
    if (this.#theme !== context.theme) {
      this.#theme = context.theme;
      this.#rebuild(this.#balance.stable ? GOOD : context.theme.error);
      context.invalidate();
    }
  }

  dispose(): void {
    this.object.traverse(free);
    this.object.clear();
  }

  #rebuild(colour: number): void {
    this.dispose();
    const { centre, ground, polygon } = this.#balance;
    const floor = ground + LIFT;
    if (polygon.length >= 3) {
      this.object.add(area(polygon, floor, colour), outline(polygon, floor, colour));
    }
    const ball = new Mesh(
      new SphereGeometry(BALL, 24, 16),
      new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true }),
    );
    ball.position.set(...centre);
    ball.renderOrder = 11;
    this.object.add(ball, plumbLine(centre, floor, colour));
    if (!this.#balance.stable) {
      const [x, y] = this.#balance.direction;
      const from = new Vector3(centre[0], centre[1], floor);
      this.object.add(new ArrowHelper(new Vector3(x, y, 0), from, FALL_ARROW, colour, 0.8, 0.5));
    }
  }
}

type Corners = Balance['polygon'];

function area(polygon: Corners, floor: number, colour: number): Object3D {
  const shape = new Shape();
  polygon.forEach(([x, y], i) => {
    if (i === 0) {
      shape.moveTo(x, y);
    } else {
      shape.lineTo(x, y);
    }
  });
  const material = new MeshBasicMaterial({
    color: colour,
    opacity: 0.28,
    transparent: true,
    depthWrite: false,
    side: 2,
  });
  const mesh = new Mesh(new ShapeGeometry(shape), material);
  mesh.position.z = floor;
  return mesh;
}

function outline(polygon: Corners, floor: number, colour: number): Object3D {
  const points = polygon.flatMap(([x, y]) => [x, y, floor]);
  return new LineLoop(pointsGeometry(points), new LineBasicMaterial({ color: colour }));
}

/** From the centre of mass straight down. */
function plumbLine(centre: Balance['centre'], floor: number, colour: number): Object3D {
  const [x, y, z] = centre;
  const material = new LineBasicMaterial({ color: colour, depthTest: false, transparent: true });
  const line = new Line(pointsGeometry([x, y, z, x, y, floor]), material);
  line.renderOrder = 11;
  return line;
}

function pointsGeometry(points: readonly number[]): BufferGeometry {
  return new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3));
}

function free(object: Object3D): void {
  if (object instanceof Mesh || object instanceof Line) {
    object.geometry.dispose();
    for (const material of [object.material].flat()) {
      material.dispose();
    }
  }
}
