import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { placeTrain, readGearTrain, teethOf } from '../../../web/src/ui/gallery/gear-train.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

function trainOf(id: string) {
  const file = new URL(`../../../public/gallery/${id}.gears.json`, import.meta.url);
  const read = readGearTrain(JSON.parse(readFileSync(file, 'utf8')), catalogue);
  if (!read.ok) {
    throw new Error(read.message);
  }
  return read.value;
}

describe('gear trains', () => {
  it.each([
    ['gear-box', [1, -1 / 3, 1 / 15]],
    ['winch', [1, -24 / 40, 3]],
  ])('of %s turn with the ratio of their teeth', (id, speeds) => {
    const train = trainOf(id);
    train.speeds.forEach((speed, i) => {
      expect(speed).toBeCloseTo(speeds[i] ?? 0, 9);
    });
  });

  it.each(['gear-box', 'winch'])('of %s keep teeth between teeth while they turn', (id) => {
    const train = trainOf(id);
    for (const turn of [0, 0.3, 1.7]) {
      for (const mesh of train.meshes) {
        const share = (shaft: number, teeth: number, toward: number) => {
          const angle = (train.phases[shaft] ?? 0) + turn * (train.speeds[shaft] ?? 0);
          return ((toward - angle) * teeth) / (2 * Math.PI);
        };
        const a = train.shafts[mesh.a]?.at ?? [0, 0, 0];
        const b = train.shafts[mesh.b]?.at ?? [0, 0, 0];
        const toward = Math.atan2(-(b[2] - a[2]), b[0] - a[0]);
        // A tooth of one is a half pitch off a tooth of the other, counted the other way round.
        const sum =
          share(mesh.a, mesh.teethA, toward) + share(mesh.b, mesh.teethB, toward + Math.PI);
        const off = (((sum - 0.5) % 1) + 1.5) % 1;
        expect(Math.abs(off - 0.5)).toBeLessThan(1e-6);
      }
    }
  });

  it.each(['gear-box', 'winch'])('of %s have bearings that are holes of exact lines', (id) => {
    const file = new URL(`../../../public/gallery/${id}.sketch.json`, import.meta.url);
    const { lines } = JSON.parse(readFileSync(file, 'utf8')) as {
      lines: { from: number[]; to: number[]; exact?: boolean; holeAxis?: string }[];
    };
    for (const { at } of trainOf(id).shafts) {
      const bearings = lines.filter(
        ({ from, to, exact, holeAxis }) =>
          exact &&
          holeAxis === 'y' &&
          from[2] === at[2] &&
          (from[0] ?? 0) < at[0] &&
          at[0] < (to[0] ?? 0) &&
          Number.isInteger(at[0]),
      );
      expect(bearings).toHaveLength(2);
    }
  });

  it('place every part of a shaft on it', () => {
    const train = trainOf('gear-box');
    const parts = placeTrain(train, 0.4, catalogue);
    expect(parts).toHaveLength(train.shafts.flatMap((shaft) => shaft.parts).length);
    expect(parts.filter((part) => teethOf(part.part, catalogue) > 0)).toHaveLength(4);
  });

  it('that lock are refused', () => {
    const gear = { part: '3648b', color: 72, along: 0 };
    const at = (x: number, z: number) => ({ at: [x, 0, z], parts: [gear] });
    const ring = { shafts: [at(0, 0), at(3, 0), at(1.5, Math.sqrt(6.75))] };
    const read = readGearTrain(ring, catalogue);
    expect(read.ok ? '' : read.message).toContain('locked');
  });
});
