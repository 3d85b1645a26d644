import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import { drawDepth } from '../../../web/src/view/drawing/depth-buffer.ts';
import {
  cameraFor,
  ISO_OUT,
  projectPoint,
  turned,
} from '../../../web/src/view/drawing/drawing-camera.ts';
import { type DrawnPart, MeshShelf } from '../../../web/src/view/drawing/drawn-part.ts';
import { writeLineArt } from '../../../web/src/view/drawing/line-art.ts';
import { drawPicture } from '../../../web/src/view/drawing/picture.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

const shelf = new MeshShelf(catalogue);
const FRONT: Vec3 = [0, -1, 0];
const SIZE = { width: 120, height: 90, margin: 6 };

const beam = (y: number, hex = 0xff0000): DrawnPart => ({
  part: '32316',
  position: [0, y, 0],
  rotation: [0, 1, 0, -1, 0, 0, 0, 0, 1],
  hex,
});

function cameraOf(parts: readonly DrawnPart[], out: Vec3 = FRONT) {
  return cameraFor(
    parts.flatMap((part) => shelf.corners(part)),
    out,
    SIZE,
  );
}

describe('the camera', () => {
  it('fits all points into the picture with its margin', () => {
    const parts = [beam(0), beam(4)];
    const camera = cameraOf(parts, ISO_OUT);
    for (const point of parts.flatMap((part) => shelf.corners(part))) {
      const [x, y] = projectPoint(camera, point);
      expect(Math.min(x, y, SIZE.width - x, SIZE.height - y)).toBeGreaterThanOrEqual(5.999);
    }
  });

  it('turns to the right and upwards', () => {
    const out = turned([0, -1, 0], Math.PI / 2, 0.5);
    expect(out[0]).toBeCloseTo(Math.cos(0.5));
    expect(out[2]).toBeCloseTo(Math.sin(0.5));
  });
});

describe('the depth buffer', () => {
  it('keeps the part that is nearer, in any order', () => {
    for (const parts of [
      [beam(0), beam(3)],
      [beam(3), beam(0)],
    ]) {
      const near = parts.findIndex((part) => part.position[1] === 0);
      const buffer = drawDepth(parts, cameraOf(parts), shelf, 'low');
      const seen = new Set(buffer.owner.filter((owner) => owner >= 0));
      expect([...seen]).toEqual([near]);
    }
  });

  it('leaves out parts that nobody knows', () => {
    const parts = [{ ...beam(0), part: 'nonsense' }];
    const buffer = drawDepth(parts, cameraOf(parts), shelf, 'low');
    expect(buffer.owner.every((owner) => owner === -1)).toBe(true);
  });
});

describe('a picture', () => {
  it('has a transparent ground and the colour of its part', () => {
    const parts = [beam(0)];
    const { data } = drawPicture(parts, cameraOf(parts), shelf);
    expect(data[3]).toBe(0);
    const reds = Array.from({ length: data.length / 4 }, (_, i) => i).filter(
      (i) => (data[4 * i] ?? 0) > 120 && data[4 * i + 1] === 0 && data[4 * i + 3] === 255,
    );
    expect(reds.length).toBeGreaterThan(500);
  });

  it('is the same every time', () => {
    const parts = [beam(0), beam(2, 0x00ff00)];
    const camera = cameraOf(parts, ISO_OUT);
    expect(drawPicture(parts, camera, shelf).data).toEqual(drawPicture(parts, camera, shelf).data);
  });

  it('draws an outline round new parts alone', () => {
    const count = (outline: number) => {
      const parts = [{ ...beam(0), outline }];
      const { data } = drawPicture(parts, cameraOf(parts), shelf);
      return data.filter((value, i) => i % 4 === 1 && value > 100 && value < 140).length;
    };
    expect(count(1)).toBeGreaterThan(count(0) + 50);
  });
});

describe('line art', () => {
  it('hides the lines behind a part', () => {
    // Millimetres of ink, near enough: each stretch from its M to its L.
    const ink = (parts: DrawnPart[]) =>
      [
        ...writeLineArt(parts, FRONT, shelf, 'x').matchAll(
          /M([\d.-]+) ([\d.-]+)L([\d.-]+) ([\d.-]+)/g,
        ),
      ].reduce((sum, [, x1, y1, x2, y2]) => {
        return sum + Math.hypot(Number(x2) - Number(x1), Number(y2) - Number(y1));
      }, 0);
    const one = ink([beam(0)]);
    expect(one).toBeGreaterThan(2000);
    // The beam behind is hidden but for what is seen through the holes.
    expect(ink([beam(0), beam(6)])).toBeLessThan(1.8 * one);
  });

  it('keeps markup of a name out of the file', () => {
    expect(writeLineArt([beam(0)], FRONT, shelf, '<script>&')).toContain('&lt;script&gt;&amp;');
  });
});
