import { Color, type ColorRepresentation } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { Vec3 } from '../../geometry/vec.ts';

/** A straight line to draw. */
export interface Segment {
  readonly from: Vec3;
  readonly to: Vec3;
  /** sRGB. */
  readonly colour: ColorRepresentation;
}

/** Lines of a fixed width on screen, in one draw call. */
export class ThickLines {
  readonly object: LineSegments2;
  readonly #material: LineMaterial;

  constructor(options: {
    /** CSS pixels. */
    readonly width: number;
    readonly renderOrder: number;
    readonly dashed?: boolean;
    readonly opacity?: number;
  }) {
    this.#material = new LineMaterial({
      linewidth: options.width,
      vertexColors: true,
      dashed: options.dashed ?? false,
      dashSize: 0.28,
      gapSize: 0.2,
      transparent: true,
      opacity: options.opacity ?? 1,
      depthWrite: false,
      alphaToCoverage: false,
    });
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.#material);
    this.object.frustumCulled = false;
    this.object.renderOrder = options.renderOrder;
    this.object.visible = false;
  }

  set(segments: readonly Segment[]): void {
    this.object.visible = segments.length > 0;
    if (segments.length === 0) {
      return;
    }
    const colour = new Color();
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(segments.flatMap((line) => [...line.from, ...line.to]));
    geometry.setColors(
      segments.flatMap((line) => {
        const rgb = colour.set(line.colour).toArray();
        return [...rgb, ...rgb];
      }),
    );
    this.object.geometry.dispose();
    this.object.geometry = geometry;
    if (this.#material.dashed) {
      this.object.computeLineDistances();
    }
  }

  /** Size of the picture in CSS pixels. */
  setResolution(width: number, height: number): void {
    this.#material.resolution.set(width, height);
  }

  /** Lines over everything, or hidden behind bricks. */
  setOverlay(overlay: 'over' | 'within'): void {
    this.#material.depthTest = overlay === 'within';
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.#material.dispose();
  }
}
