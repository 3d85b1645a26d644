import { describe, expect, it } from 'vitest';
import { towardsText } from '../../../web/src/ui/checks/balance.tsx';

describe('the way in which a model tips over', () => {
  it('is told by the axes that it has a share in', () => {
    expect(towardsText([1, 0])).toBe('+x');
    expect(towardsText([0, -1])).toBe('−y');
    expect(towardsText([-0.71, 0.71])).toBe('−x +y');
    expect(towardsText([0.98, 0.2])).toBe('+x');
  });
});
