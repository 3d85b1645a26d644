import { MOUSE, OrthographicCamera, PerspectiveCamera, Spherical, TOUCH, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Vec3 } from '../../geometry/vec.ts';
import type { Navigation, Projection, StandardView } from '../view-types.ts';
import { FIELD_OF_VIEW, fitPoints, PAGE_MARGINS } from './fit-points.ts';
import { VIEW_DIRECTIONS } from './standard-views.ts';

/** Radians from straight up and down where turning by keys stops. */
const POLE = 0.02;
const MOVE_MILLISECONDS = 320;
/** The far plane, and how near and far one may go, in modules. */
const REACH = { near: 0.1, far: 4000, minDistance: 1.5, maxDistance: 1500 } as const;

interface Move {
  readonly fromEye: Vector3;
  readonly fromTarget: Vector3;
  readonly toEye: Vector3;
  readonly toTarget: Vector3;
  readonly fromHeight: number;
  readonly toHeight: number;
  start: number | null;
}

/** Camera, orbit controls and animated moves. Calls `onChange` whenever the picture has changed. */
export class CameraRig {
  readonly controls: OrbitControls;
  readonly #perspective = new PerspectiveCamera(FIELD_OF_VIEW, 1, REACH.near, REACH.far);
  readonly #orthographic = new OrthographicCamera(-1, 1, 1, -1, -REACH.far, REACH.far);
  readonly #onChange: () => void;
  readonly #reducedMotion: boolean;
  #projection: Projection = 'perspective';
  #aspect = 1;
  #move: Move | null = null;

  constructor(
    element: HTMLElement,
    options: { readonly reducedMotion: boolean; readonly onChange: () => void },
  ) {
    this.#onChange = options.onChange;
    this.#reducedMotion = options.reducedMotion;
    for (const camera of [this.#perspective, this.#orthographic]) {
      camera.up.set(0, 0, 1);
      camera.position.set(20, -24, 16);
    }
    this.controls = new OrbitControls(this.#perspective, element);
    this.controls.enableDamping = !options.reducedMotion;
    this.controls.dampingFactor = 0.18;
    this.controls.minDistance = REACH.minDistance;
    this.controls.maxDistance = REACH.maxDistance;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', options.onChange);
    this.controls.addEventListener('start', () => {
      this.#move = null;
    });
    this.setNavigation('orbit');
    this.#applyLens();
  }

  get camera(): PerspectiveCamera | OrthographicCamera {
    return this.#projection === 'perspective' ? this.#perspective : this.#orthographic;
  }

  /** Width divided by height of the picture. */
  setAspect(aspect: number): void {
    this.#aspect = aspect > 0 ? aspect : 1;
    this.#applyLens();
  }

  setNavigation(navigation: Navigation): void {
    const { controls } = this;
    if (navigation === 'orbit') {
      controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN };
      controls.touches = { ONE: TOUCH.ROTATE, TWO: TOUCH.DOLLY_PAN };
    } else {
      controls.mouseButtons = { LEFT: null, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.ROTATE };
      controls.touches = { ONE: null, TWO: TOUCH.DOLLY_ROTATE };
    }
  }

  setTurntable(state: 'on' | 'off'): void {
    this.controls.autoRotate = state === 'on' && !this.#reducedMotion;
    this.controls.autoRotateSpeed = 1.2;
    this.#onChange();
  }

  setProjection(projection: Projection): void {
    if (projection === this.#projection) {
      return;
    }
    const height = this.viewHeight();
    const eye = this.camera.position.clone();
    this.#projection = projection;
    const camera = this.camera;
    camera.position.copy(eye);
    if (projection === 'perspective') {
      const away = height / (2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360));
      const direction = eye.sub(this.controls.target).normalize();
      camera.position.copy(this.controls.target).addScaledVector(direction, away);
    } else {
      this.#orthographic.zoom = 1;
      this.#setOrthographicHeight(height);
    }
    this.controls.object = camera;
    this.#applyLens();
    this.controls.update();
    this.#onChange();
  }

  /** Height of what is seen at the target, modules. */
  viewHeight(): number {
    if (this.#projection === 'orthographic') {
      return (this.#orthographic.top - this.#orthographic.bottom) / this.#orthographic.zoom;
    }
    return this.#heightAt(this.#perspective.position.distanceTo(this.controls.target));
  }

  /** Looks from a direction (or the present one) so that all points are seen, as large as may be. */
  fit(points: readonly Vec3[], view?: StandardView): void {
    const direction = view
      ? new Vector3(...VIEW_DIRECTIONS[view]).normalize()
      : this.camera.position.clone().sub(this.controls.target).normalize();
    const { target, away } = fitPoints(points, direction, this.#aspect, PAGE_MARGINS);
    const eye = target.clone().addScaledVector(direction, away);
    this.#moveTo(target, eye, this.#heightAt(away));
  }

  /**
   * Turns the eye about what is looked at, for keys and buttons.
   * @param azimuth radians to the right.
   * @param elevation radians upwards; stops short of the poles.
   */
  turn(azimuth: number, elevation: number): void {
    const { target } = this.controls;
    const offset = this.camera.position.clone().sub(target);
    const place = new Spherical().setFromVector3(new Vector3(offset.x, offset.z, -offset.y));
    place.theta += azimuth;
    place.phi = Math.min(Math.PI - POLE, Math.max(POLE, place.phi - elevation));
    const turned = new Vector3().setFromSpherical(place);
    offset.set(turned.x, -turned.z, turned.y);
    this.#moveTo(target.clone(), target.clone().add(offset));
  }

  /** Goes nearer (factor below 1) or farther. */
  zoom(factor: number): void {
    const { target } = this.controls;
    const offset = this.camera.position.clone().sub(target);
    const away = (offset.length() * factor * this.viewHeight()) / this.#heightAt(offset.length());
    const bounded = Math.min(REACH.maxDistance, Math.max(REACH.minDistance, away));
    const eye = target.clone().add(offset.setLength(bounded));
    this.#moveTo(target.clone(), eye, this.#heightAt(bounded));
  }

  /**
   * Brings a point to the middle without turning.
   * @param above how far above the middle instead, as a share of the height of the picture.
   */
  centreOn(point: Vec3, above = 0): void {
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    const target = new Vector3(...point).addScaledVector(up, -above * this.viewHeight());
    const eye = this.camera.position.clone().sub(this.controls.target).add(target);
    this.#moveTo(target, eye);
  }

  /**
   * Advances controls and moves before a frame.
   * @param now milliseconds, as requestAnimationFrame gives them.
   * @returns true while further frames are needed.
   */
  update(now: number): boolean {
    const moving = this.#advanceMove(now);
    const settling = this.controls.update();
    return moving || settling || this.controls.autoRotate;
  }

  dispose(): void {
    this.controls.dispose();
  }

  /** Height of what the perspective camera sees at a distance, modules. */
  #heightAt(distance: number): number {
    return 2 * distance * Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
  }

  /** @param height of what is seen there, for the orthographic camera; as now when left out. */
  #moveTo(target: Vector3, eye: Vector3, height = this.viewHeight()): void {
    this.#move = {
      fromEye: this.camera.position.clone(),
      fromTarget: this.controls.target.clone(),
      toEye: eye,
      toTarget: target,
      fromHeight: this.viewHeight(),
      toHeight: height,
      start: null,
    };
    if (this.#reducedMotion) {
      this.#placeAt(this.#move, 1);
      this.#move = null;
    }
    this.#onChange();
  }

  #advanceMove(now: number): boolean {
    const move = this.#move;
    if (!move) {
      return false;
    }
    move.start ??= now;
    const t = Math.min(1, (now - move.start) / MOVE_MILLISECONDS);
    this.#placeAt(move, t * t * (3 - 2 * t));
    if (t >= 1) {
      this.#move = null;
    }
    return t < 1;
  }

  /** Turns about the target rather than cutting across, so that the distance stays in between. */
  #placeAt(move: Move, t: number): void {
    const target = move.fromTarget.clone().lerp(move.toTarget, t);
    const from = move.fromEye.clone().sub(move.fromTarget);
    const to = move.toEye.clone().sub(move.toTarget);
    const away = from.length() + (to.length() - from.length()) * t;
    const direction = from.normalize().lerp(to.normalize(), t);
    if (direction.lengthSq() < 1e-6) {
      direction.copy(to);
    }
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(direction.normalize(), away);
    // At once, so that places on screen are right before the next frame too.
    this.camera.lookAt(target);
    if (this.#projection === 'orthographic') {
      this.#orthographic.zoom = 1;
      this.#setOrthographicHeight(move.fromHeight + (move.toHeight - move.fromHeight) * t);
    }
  }

  #setOrthographicHeight(height: number): void {
    const camera = this.#orthographic;
    camera.top = height / 2;
    camera.bottom = -height / 2;
    this.#applyLens();
  }

  #applyLens(): void {
    this.#perspective.aspect = this.#aspect;
    this.#perspective.updateProjectionMatrix();
    const camera = this.#orthographic;
    camera.right = camera.top * this.#aspect;
    camera.left = -camera.right;
    camera.updateProjectionMatrix();
  }
}
