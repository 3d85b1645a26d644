import {
  Color,
  DataTexture,
  DirectionalLight,
  HemisphereLight,
  LinearFilter,
  NeutralToneMapping,
  PCFShadowMap,
  RGBAFormat,
  Scene,
  SRGBColorSpace,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { Bounds } from '../../model/bounds.ts';
import { studioEnvironment } from './environment.ts';
import { Ground } from './ground.ts';
import { type ViewTheme, viewTheme } from './theme.ts';

const SHADOW_MAP_SIZE = 2048;
/** From the model to the main light. */
const KEY_DIRECTION = new Vector3(-0.45, -0.6, 1).normalize();
/** Floor below the sketch when there is no model, modules. */
const DEFAULT_RADIUS = 12;

/** Renderer, scene, lights and floor: everything that does not depend on what is shown. */
export class Stage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly ground = new Ground();
  readonly #key = new DirectionalLight(0xffffff, 2.6);
  readonly #sky = new HemisphereLight(0xffffff, 0xb8b2a8, 0.7);
  readonly #fill = new DirectionalLight(0xdfe9ff, 0.5);
  #theme: ViewTheme = viewTheme('light');
  #background: DataTexture | null = null;
  #backdrop: 'studio' | 'clear' = 'studio';

  constructor(canvas: HTMLCanvasElement, options: { readonly transparent?: boolean } = {}) {
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: true,
      powerPreference: 'low-power',
      alpha: options.transparent ?? false,
    });
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    // Nothing moves but the camera: the shadow is drawn again only when the model changes.
    this.renderer.shadowMap.autoUpdate = false;
    this.renderer.localClippingEnabled = true;
    this.#key.castShadow = true;
    this.#key.shadow.mapSize.set(SHADOW_MAP_SIZE, SHADOW_MAP_SIZE);
    this.#key.shadow.radius = 3;
    this.#key.shadow.normalBias = 0.03;
    this.#key.shadow.bias = -0.0006;
    this.#fill.position.set(1, 0.4, 0.5);
    this.scene.add(this.#key, this.#key.target, this.#sky, this.#fill, this.ground.group);
    this.restore();
  }

  get theme(): ViewTheme {
    return this.#theme;
  }

  /** Makes again what lives in the graphics memory alone; after a lost context. */
  restore(): void {
    this.scene.environment?.dispose();
    this.scene.environment = studioEnvironment(this.renderer);
    this.scene.environmentIntensity = 0.8 * this.#theme.lightScale;
    this.shadowChanged();
  }

  setTheme(theme: ViewTheme): void {
    this.#theme = theme;
    this.#background?.dispose();
    this.#background = gradient(theme.backgroundTop, theme.backgroundBottom);
    this.#applyBackdrop();
    this.scene.environmentIntensity = 0.8 * theme.lightScale;
    this.ground.setTheme(theme);
  }

  /** Background, floor and its shadow, or nothing behind the bricks (on a transparent canvas). */
  setBackdrop(backdrop: 'studio' | 'clear'): void {
    this.#backdrop = backdrop;
    this.#applyBackdrop();
  }

  #applyBackdrop(): void {
    const studio = this.#backdrop === 'studio';
    this.scene.background = studio ? this.#background : null;
    this.ground.group.visible = studio;
  }

  /** The shadow is drawn again with the next frame. */
  shadowChanged(): void {
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** Fits the light's frustum and the floor to what stands there. @param floor z of the floor. */
  frame(box: Bounds | null, floor: number): void {
    const min = new Vector3(...(box?.min ?? [-DEFAULT_RADIUS, -DEFAULT_RADIUS, 0]));
    const max = new Vector3(...(box?.max ?? [DEFAULT_RADIUS, DEFAULT_RADIUS, 0]));
    const middle = min.clone().add(max).multiplyScalar(0.5);
    const radius = Math.max(3, min.distanceTo(max) / 2);
    this.ground.place([middle.x, middle.y, floor], radius);
    this.#key.target.position.copy(middle);
    this.#key.position.copy(middle).addScaledVector(KEY_DIRECTION, radius * 2.5);
    const camera = this.#key.shadow.camera;
    const reach = radius * 1.15;
    camera.left = -reach;
    camera.right = reach;
    camera.top = reach;
    camera.bottom = -reach;
    camera.near = radius * 0.5;
    camera.far = radius * 6;
    camera.updateProjectionMatrix();
    this.shadowChanged();
  }

  dispose(): void {
    this.ground.dispose();
    this.scene.environment?.dispose();
    this.#background?.dispose();
    this.#key.shadow.dispose();
    this.renderer.dispose();
  }
}

/** A background that runs from one colour at the top to another at the bottom. */
function gradient(top: number, bottom: number): DataTexture {
  const rows = 64;
  const data = new Uint8Array(rows * 4);
  const colour = new Color();
  const from = new Color(bottom);
  const to = new Color(top);
  for (let i = 0; i < rows; i++) {
    colour.lerpColors(from, to, i / (rows - 1)).convertLinearToSRGB();
    data.set([colour.r * 255, colour.g * 255, colour.b * 255, 255], i * 4);
  }
  const texture = new DataTexture(data, 1, rows, RGBAFormat);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
