import {
  Color,
  DoubleSide,
  Group,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  ShadowMaterial,
} from 'three';
import type { ViewTheme } from './theme.ts';

const GRID_VERTEX = /* glsl */ `
varying vec2 vPlace;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  vPlace = world.xy;
  gl_Position = projectionMatrix * viewMatrix * world;
}
`;

/** Unit and five-unit lines, one pixel wide, that thin out with distance instead of flickering. */
const GRID_FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform vec3 strongColour;
uniform float opacity;
uniform float reach;
uniform vec2 middle;
varying vec2 vPlace;

float lines(vec2 place, float spacing) {
  vec2 scaled = place / spacing;
  vec2 width = fwidth(scaled);
  vec2 off = abs(fract(scaled - 0.5) - 0.5) / max(width, vec2(1e-6));
  vec2 line = 1.0 - min(off, 1.0);
  // Where lines come closer than a few pixels they become a tint, and then nothing.
  line *= 1.0 - smoothstep(0.15, 0.4, width);
  return max(line.x, line.y);
}

void main() {
  float fade = 1.0 - smoothstep(0.35, 1.0, distance(vPlace, middle) / reach);
  float fine = lines(vPlace, 1.0) * 0.45;
  float strong = lines(vPlace, 5.0);
  float alpha = max(fine, strong) * opacity * fade;
  if (alpha < 0.004) {
    discard;
  }
  gl_FragColor = vec4(mix(colour, strongColour, step(fine, strong)), alpha);
  #include <colorspace_fragment>
}
`;

/** The floor: a unit grid that fades out, and the shadow of the model. */
export class Ground {
  readonly group = new Group();
  readonly #grid: Mesh<PlaneGeometry, ShaderMaterial>;
  readonly #shadow: Mesh<PlaneGeometry, ShadowMaterial>;

  constructor() {
    const plane = new PlaneGeometry(1, 1);
    const material = new ShaderMaterial({
      vertexShader: GRID_VERTEX,
      fragmentShader: GRID_FRAGMENT,
      uniforms: {
        colour: { value: new Color() },
        strongColour: { value: new Color() },
        opacity: { value: 1 },
        reach: { value: 60 },
        middle: { value: [0, 0] },
      },
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    this.#grid = new Mesh(plane, material);
    this.#grid.renderOrder = -2;
    this.#shadow = new Mesh(plane, new ShadowMaterial({ transparent: true, depthWrite: false }));
    this.#shadow.receiveShadow = true;
    this.#shadow.renderOrder = -1;
    this.group.add(this.#grid, this.#shadow);
    this.place([0, 0, 0], 30);
  }

  /** Lays the floor under a box: its middle, height in z, and half its size. */
  place(middle: readonly [number, number, number], radius: number): void {
    const reach = Math.max(24, radius * 3.2);
    this.#grid.material.uniforms['reach'] = { value: reach };
    this.#grid.material.uniforms['middle'] = { value: [middle[0], middle[1]] };
    this.#grid.scale.setScalar(reach * 2);
    this.#grid.position.set(middle[0], middle[1], middle[2]);
    this.#shadow.scale.setScalar(reach * 2);
    this.#shadow.position.set(middle[0], middle[1], middle[2] - 0.002);
  }

  setTheme(theme: ViewTheme): void {
    const { uniforms } = this.#grid.material;
    uniforms['colour'] = { value: new Color(theme.grid) };
    uniforms['strongColour'] = { value: new Color(theme.gridStrong) };
    uniforms['opacity'] = { value: theme.gridOpacity };
    this.#shadow.material.opacity = theme.shadowOpacity;
  }

  setShadowVisible(visible: boolean): void {
    this.#shadow.visible = visible;
  }

  dispose(): void {
    this.#grid.geometry.dispose();
    this.#grid.material.dispose();
    this.#shadow.material.dispose();
  }
}
