import {
  Color,
  CylinderGeometry,
  Group,
  InstancedMesh,
  Matrix4,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
} from 'three';
import {
  displacedPoint,
  type StressResult,
  type StressSample,
  stressHex,
} from '../../model/stress.ts';
import type { OverlayContext, SceneOverlay } from './overlay.ts';

const RADIUS = 0.22;
const SIDES = 10;
const UP = new Vector3(0, 1, 0);
const SHORTEST = 1e-6;

/** One straight piece of a part between two samples. */
interface Piece {
  readonly from: StressSample;
  readonly to: StressSample;
}

/** The frame as rods in the colours of their stress, bent as far as is asked for. */
export class StressShape implements SceneOverlay {
  readonly object = new Group();
  readonly #pieces: readonly Piece[];
  readonly #mesh: InstancedMesh;
  #invalidate: () => void = () => undefined;

  constructor(result: StressResult) {
    this.#pieces = result.samples.flatMap(piecesOf);
    const rod = new CylinderGeometry(RADIUS, RADIUS, 1, SIDES);
    this.#mesh = new InstancedMesh(rod, new MeshLambertMaterial(), this.#pieces.length);
    this.#mesh.frustumCulled = false;
    const colour = new Color();
    this.#pieces.forEach(({ from, to }, index) => {
      const stress = (from[3] + to[3]) / 2;
      this.#mesh.setColorAt(index, colour.set(stressHex(stress / (result.maxStress || 1))));
    });
    this.object.add(this.#mesh);
    this.setExaggeration(0);
  }

  /** Number of rods. */
  get count(): number {
    return this.#pieces.length;
  }

  /** @param factor 0 shows the frame at rest. */
  setExaggeration(factor: number): void {
    const matrix = new Matrix4();
    this.#pieces.forEach((piece, index) => {
      this.#mesh.setMatrixAt(index, rodMatrix(piece, factor, matrix));
    });
    this.#mesh.instanceMatrix.needsUpdate = true;
    this.#invalidate();
  }

  setVisible(visible: boolean): void {
    this.object.visible = visible;
    this.#invalidate();
  }

  attach(context: OverlayContext): void {
    this.#invalidate = context.invalidate;
    context.invalidate();
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    (this.#mesh.material as MeshLambertMaterial).dispose();
    this.#mesh.dispose();
  }
}

/** Samples come in threes, one three for each bar; a part without bars has one sample. */
function piecesOf(samples: readonly StressSample[]): Piece[] {
  const pieces: Piece[] = [];
  for (let bar = 0; bar + 2 < samples.length; bar += 3) {
    const [a, middle, b] = samples.slice(bar, bar + 3);
    if (a && middle && b) {
      pieces.push({ from: a, to: middle }, { from: middle, to: b });
    }
  }
  return pieces;
}

function rodMatrix({ from, to }: Piece, factor: number, matrix: Matrix4): Matrix4 {
  const start = new Vector3(...displacedPoint(from, factor));
  const end = new Vector3(...displacedPoint(to, factor));
  const along = end.clone().sub(start);
  const length = Math.max(SHORTEST, along.length());
  const turn = new Quaternion().setFromUnitVectors(UP, along.divideScalar(length));
  return matrix.compose(start.add(end).multiplyScalar(0.5), turn, new Vector3(1, length, 1));
}
