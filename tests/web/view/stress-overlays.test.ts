import { Color, InstancedMesh, Matrix4, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { STRESS_RAMP } from '../../../web/src/model/stress.ts';
import { StressLoads } from '../../../web/src/view/overlays/stress-loads.ts';
import { StressShape } from '../../../web/src/view/overlays/stress-shape.ts';
import { stressResult } from '../helpers/stress-result.ts';

function rodsOf(shape: StressShape): InstancedMesh {
  const [rods] = shape.object.children;
  if (!(rods instanceof InstancedMesh)) {
    throw new Error('no rods');
  }
  return rods;
}

function middleOf(shape: StressShape, rod: number): Vector3 {
  const matrix = new Matrix4();
  rodsOf(shape).getMatrixAt(rod, matrix);
  return new Vector3().setFromMatrixPosition(matrix);
}

describe('StressShape', () => {
  it('has two rods for each bar and none for a part without', () => {
    expect(new StressShape(stressResult()).count).toBe(4);
  });

  it('lies along the bars when it is not bent', () => {
    const shape = new StressShape(stressResult());
    expect(middleOf(shape, 0).toArray()).toEqual([1, 0, 0]);
    expect(middleOf(shape, 3).toArray()).toEqual([7, 0, 0]);
  });

  it('sinks with the exaggeration', () => {
    const shape = new StressShape(stressResult());
    shape.setExaggeration(8);
    expect(middleOf(shape, 1).z).toBeCloseTo(-0.4);
    shape.setExaggeration(16);
    expect(middleOf(shape, 1).z).toBeCloseTo(-0.8);
  });

  it('is warmer where the stress is greater', () => {
    const rods = rodsOf(new StressShape(stressResult()));
    const [ends, middle] = [new Color(), new Color()];
    rods.getColorAt(0, ends);
    rods.getColorAt(1, middle);
    expect(middle.r).toBeGreaterThan(ends.r);
    expect(STRESS_RAMP).toHaveLength(5);
  });
});

describe('StressLoads', () => {
  it('has an arrow for each force that is not zero', () => {
    const loads = new StressLoads();
    loads.setLoads([
      { at: [0, 0, 0], force: [0, 0, -5] },
      { at: [1, 0, 0], force: [0, 0, 0] },
    ]);
    expect(loads.object.children).toHaveLength(1);
    loads.setLoads([]);
    expect(loads.object.children).toHaveLength(0);
  });

  it('ends its arrow where the force acts', () => {
    const loads = new StressLoads();
    loads.setLoads([{ at: [3, 4, 5], force: [0, 0, -5] }]);
    const [arrow] = loads.object.children;
    expect(arrow?.position.x).toBe(3);
    expect(arrow?.position.z).toBeGreaterThan(5);
  });
});
