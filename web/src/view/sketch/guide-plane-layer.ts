import {
  Color,
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  Vector3,
} from 'three';
import { AXIS_NAMES, type AxisName, type Vec3 } from '../../geometry/vec.ts';
import type { ViewTheme } from '../scene/theme.ts';
import type { GuidePlane } from '../view-types.ts';

/** How far the pane reaches round its middle, and the unit grid round the cursor, modules. */
const PANE_REACH = 26;
const GRID_REACH = 7;

const VERTEX = /* glsl */ `
varying vec2 vPlace;
void main() {
  vPlace = position.xy;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

/** A faint pane with a unit grid that shows only near the cursor, and lines through the anchor. */
const FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform vec3 axisColourU;
uniform vec3 axisColourV;
uniform vec2 cursor;
uniform float hasCursor;
uniform float paneReach;
uniform float gridReach;
varying vec2 vPlace;

float lineAt(float value, float width) {
  return 1.0 - min(abs(value) / max(width, 1e-6), 1.0);
}

void main() {
  vec2 width = fwidth(vPlace) * 1.1;
  float edge = 1.0 - smoothstep(0.55, 1.0, length(vPlace) / paneReach);
  float near = hasCursor * (1.0 - smoothstep(0.15, 1.0, distance(vPlace, cursor) / gridReach));
  vec2 cell = abs(fract(vPlace - 0.5) - 0.5);
  float grid = max(lineAt(cell.x, width.x), lineAt(cell.y, width.y));
  float dots = 1.0 - smoothstep(0.0, 1.0, length(cell / max(width, vec2(1e-6))) / 2.4);
  float u = lineAt(vPlace.y, width.y * 1.3);
  float v = lineAt(vPlace.x, width.x * 1.3);
  float alpha = max(0.075 * edge, max(grid * 0.5, dots) * near * 0.75);
  vec3 tint = colour;
  if (max(u, v) > 0.1) {
    tint = u > v ? axisColourU : axisColourV;
    alpha = max(alpha, max(u, v) * 0.8 * edge);
  }
  if (alpha < 0.004) {
    discard;
  }
  gl_FragColor = vec4(tint, alpha);
  #include <colorspace_fragment>
}
`;

/** The translucent plane that lines are drawn on. */
export class GuidePlaneLayer {
  readonly group = new Group();
  readonly #pane: Mesh<PlaneGeometry, ShaderMaterial>;
  #theme: ViewTheme | null = null;
  #plane: GuidePlane | null = null;

  constructor() {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        colour: { value: new Color() },
        axisColourU: { value: new Color() },
        axisColourV: { value: new Color() },
        cursor: { value: [0, 0] },
        hasCursor: { value: 0 },
        paneReach: { value: PANE_REACH },
        gridReach: { value: GRID_REACH },
      },
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    this.#pane = new Mesh(new PlaneGeometry(2 * PANE_REACH, 2 * PANE_REACH), material);
    this.#pane.renderOrder = 5;
    this.#pane.visible = false;
    this.group.add(this.#pane);
  }

  /** Shows the plane (null hides it) with its unit grid round the cursor. */
  set(plane: GuidePlane | null, cursor: Vec3 | null): void {
    this.#pane.visible = plane !== null;
    if (!plane) {
      this.#plane = null;
      return;
    }
    const [u, v, normal] = planeAxes(plane.axis);
    const { uniforms } = this.#pane.material;
    if (plane !== this.#plane) {
      this.#plane = plane;
      this.#pane.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(u, v, normal));
      this.#pane.position.set(...plane.through);
      this.#applyAxisColours();
    }
    uniforms['hasCursor'] = { value: cursor ? 1 : 0 };
    if (cursor) {
      const offset = new Vector3(...cursor).sub(this.#pane.position);
      uniforms['cursor'] = { value: [offset.dot(u), offset.dot(v)] };
    }
  }

  setTheme(theme: ViewTheme): void {
    this.#theme = theme;
    this.#pane.material.uniforms['colour'] = { value: new Color(theme.selected) };
    this.#applyAxisColours();
  }

  dispose(): void {
    this.#pane.geometry.dispose();
    this.#pane.material.dispose();
  }

  #applyAxisColours(): void {
    if (!this.#theme || !this.#plane) {
      return;
    }
    const { axes } = this.#theme;
    const [u, v] = planeAxisNames(this.#plane.axis);
    const { uniforms } = this.#pane.material;
    uniforms['axisColourU'] = { value: new Color(axes[AXIS_NAMES.indexOf(u)]) };
    uniforms['axisColourV'] = { value: new Color(axes[AXIS_NAMES.indexOf(v)]) };
  }
}

/** The two axes that span the plane perpendicular to `axis`, in the order of a right-handed frame. */
function planeAxisNames(axis: AxisName): readonly [AxisName, AxisName] {
  if (axis === 'x') {
    return ['y', 'z'];
  }
  return axis === 'y' ? ['z', 'x'] : ['x', 'y'];
}

function planeAxes(axis: AxisName): readonly [Vector3, Vector3, Vector3] {
  const [u, v] = planeAxisNames(axis);
  const vector = (name: AxisName): Vector3 =>
    new Vector3(name === 'x' ? 1 : 0, name === 'y' ? 1 : 0, name === 'z' ? 1 : 0);
  return [vector(u), vector(v), vector(axis)];
}
