import { OrthographicCamera, PerspectiveCamera } from 'three';
import { describe, expect, it } from 'vitest';
import { add, scale, type Vec3 } from '../../../web/src/geometry/vec.ts';
import { ScreenSpace } from '../../../web/src/view/scene/screen-space.ts';

const canvas = { clientWidth: 800, clientHeight: 600 } as HTMLCanvasElement;

function perspective(): PerspectiveCamera {
  const camera = new PerspectiveCamera(26, 800 / 600, 0.1, 4000);
  camera.up.set(0, 0, 1);
  camera.position.set(12, -15, 9);
  camera.lookAt(2, 1, 0);
  return camera;
}

function orthographic(): OrthographicCamera {
  const camera = new OrthographicCamera(-8, 8, 6, -6, -4000, 4000);
  camera.up.set(0, 0, 1);
  camera.position.set(12, -15, 9);
  camera.lookAt(2, 1, 0);
  return camera;
}

describe.each([
  ['perspective', perspective],
  ['orthographic', orthographic],
] as const)('ScreenSpace (%s)', (_, make) => {
  const space = new ScreenSpace(canvas, make);

  it('shows what is looked at in the middle', () => {
    const place = space.project([2, 1, 0]);
    expect(place.x).toBeCloseTo(400, 3);
    expect(place.y).toBeCloseTo(300, 3);
    expect(place.visible).toBe(true);
  });

  it('sends a ray through the point that it projects', () => {
    const point: Vec3 = [3, 2, 1.5];
    const place = space.project(point);
    const ray = space.toRay(place.x, place.y);
    const along = point.reduce(
      (sum, v, i) => sum + (v - (ray.origin[i] ?? 0)) * (ray.direction[i] ?? 0),
      0,
    );
    const nearest = add(ray.origin, scale(ray.direction, along));
    nearest.forEach((value, i) => {
      expect(value).toBeCloseTo(point[i] ?? 0, 4);
    });
  });

  it('has y grow downwards', () => {
    expect(space.project([2, 1, 1]).y).toBeLessThan(space.project([2, 1, 0]).y);
  });
});

describe('ScreenSpace', () => {
  it('says that a point behind the eye is not seen', () => {
    expect(new ScreenSpace(canvas, perspective).project([24, -32, 18]).visible).toBe(false);
  });
});
