import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { corners } from '../../../web/src/model/bounds.ts';
import { FIELD_OF_VIEW, fitPoints } from '../../../web/src/view/scene/fit-points.ts';

const box = corners({ min: [2, -3, 0], max: [14, 5, 4] });

/** The points as seen after fitting, in units of half the picture. */
function seen(direction: Vector3, aspect: number): Vector3[] {
  const { target, away } = fitPoints(box, direction, aspect);
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, aspect, 0.1, 4000);
  camera.up.set(0, 0, 1);
  camera.position.copy(target).addScaledVector(direction, away);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  camera.updateProjectionMatrix();
  return box.map((point) => new Vector3(...point).project(camera));
}

describe('fitPoints', () => {
  const views = [
    new Vector3(0, -1, 0),
    new Vector3(1, 0, 0),
    new Vector3(0.62, -0.7, 0.46).normalize(),
    new Vector3(0, -0.0005, 1).normalize(),
  ];

  it.each([2.2, 1, 0.5])('keeps all points in the picture (aspect %s)', (aspect) => {
    for (const direction of views) {
      for (const point of seen(direction, aspect)) {
        expect(Math.abs(point.x)).toBeLessThan(1);
        expect(Math.abs(point.y)).toBeLessThan(1);
      }
    }
  });

  it('leaves room above and below where it is asked to', () => {
    const direction = new Vector3(0, -1, 0);
    const plain = fitPoints(box, direction, 4);
    const roomy = fitPoints(box, direction, 4, { across: 1.14, up: 2.28 });
    expect(roomy.away).toBeGreaterThan(1.5 * plain.away);
  });

  it.each([2.2, 1, 0.5])('fills most of the picture one way (aspect %s)', (aspect) => {
    for (const direction of views) {
      const points = seen(direction, aspect);
      const wide = Math.max(...points.map((point) => Math.abs(point.x)));
      const high = Math.max(...points.map((point) => Math.abs(point.y)));
      expect(Math.max(wide, high)).toBeGreaterThan(0.8);
    }
  });
});
