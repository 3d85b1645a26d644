import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from 'three';
import type { Vec3 } from '../../geometry/vec.ts';

const VERTEX = /* glsl */ `
attribute float size;
attribute vec3 fill;
attribute float ring;
attribute float shape;
uniform float pixelRatio;
varying vec3 vFill;
varying float vRing;
varying float vSize;
varying float vShape;
void main() {
  vShape = shape;
  vFill = fill;
  vRing = ring;
  vSize = size * pixelRatio;
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  // In front of the lines that meet here.
  if (isOrthographic) {
    mvPosition.z += 0.1;
  } else {
    mvPosition.xyz *= 0.997;
  }
  gl_Position = projectionMatrix * mvPosition;
  gl_PointSize = vSize;
}
`;

/** A disc with a soft rim; a ring when asked for, filled with the background. */
const FRAGMENT = /* glsl */ `
uniform vec3 inner;
varying vec3 vFill;
varying float vRing;
varying float vSize;
varying float vShape;

/** Distance from the middle, 0.5 at the rim: disc, square, diamond, triangle. */
float reach(vec2 p) {
  if (vShape < 0.5) {
    return length(p);
  }
  if (vShape < 1.5) {
    return max(abs(p.x), abs(p.y)) * 1.12;
  }
  if (vShape < 2.5) {
    return abs(p.x) + abs(p.y);
  }
  return max(p.y * 1.15, abs(p.x) * 1.05 - (p.y - 0.12) * 0.6);
}

void main() {
  float radius = reach(gl_PointCoord - 0.5) * vSize;
  float outside = vSize * 0.5;
  float alpha = 1.0 - smoothstep(outside - 1.2, outside, radius);
  if (alpha < 0.02) {
    discard;
  }
  float border = outside - max(1.8, vSize * 0.2);
  float inRing = vRing * (1.0 - smoothstep(border - 0.7, border + 0.7, radius));
  gl_FragColor = vec4(mix(vFill, inner, inRing), alpha);
  #include <colorspace_fragment>
}
`;

/** A dot of a fixed size on screen. */
export interface Dot {
  readonly at: Vec3;
  /** Diameter in CSS pixels. */
  readonly size: number;
  /** sRGB. */
  readonly colour: number;
  readonly ring?: boolean;
  /** A disc when left out. */
  readonly shape?: DotShape;
}

const SHAPES = { disc: 0, square: 1, diamond: 2, triangle: 3 } as const;

export type DotShape = keyof typeof SHAPES;

/** Round dots that keep their size on screen, in one draw call. */
export class Dots {
  readonly object: Points<BufferGeometry, ShaderMaterial>;

  constructor(renderOrder: number) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { pixelRatio: { value: 1 }, inner: { value: new Color(0xffffff) } },
      transparent: true,
      depthWrite: false,
    });
    this.object = new Points(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = renderOrder;
  }

  set(dots: readonly Dot[]): void {
    const colour = new Color();
    const geometry = new BufferGeometry();
    // A large sketch has thousands of them: no lists in between.
    const attribute = (name: string, size: number): Float32Array => {
      const values = new Float32Array(dots.length * size);
      geometry.setAttribute(name, new BufferAttribute(values, size));
      return values;
    };
    const position = attribute('position', 3);
    const fill = attribute('fill', 3);
    const sizes = attribute('size', 1);
    const rings = attribute('ring', 1);
    const shapes = attribute('shape', 1);
    dots.forEach((dot, i) => {
      position.set(dot.at, 3 * i);
      colour.setHex(dot.colour).toArray(fill, 3 * i);
      sizes[i] = dot.size;
      rings[i] = dot.ring ? 1 : 0;
      shapes[i] = SHAPES[dot.shape ?? 'disc'];
    });
    this.object.geometry.dispose();
    this.object.geometry = geometry;
    this.object.visible = dots.length > 0;
  }

  setPixelRatio(ratio: number): void {
    this.object.material.uniforms['pixelRatio'] = { value: ratio };
  }

  /** Colour within rings: the background's. */
  setInner(colour: number): void {
    this.object.material.uniforms['inner'] = { value: new Color(colour) };
  }

  /** Dots over everything, or hidden behind bricks. */
  setOverlay(overlay: 'over' | 'within'): void {
    this.object.material.depthTest = overlay === 'within';
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
