import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { expect } from './test.ts';

const DESK = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844 };

/** What axe finds serious or worse: the rule and the elements. */
async function findings(page: Page, rules: 'all' | 'contrast'): Promise<string[]> {
  const axe = new AxeBuilder({ page });
  const { violations } = await (rules === 'contrast'
    ? axe.withRules(['color-contrast'])
    : axe.options({ rules: { 'target-size': { enabled: true } } })
  ).analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .flatMap(({ id, nodes }) =>
      nodes.map((node) => `${id}: ${node.target.join(' ')} ${node.html}`),
    );
}

/** The same state in both themes and at a phone's width: a theme changes colours alone. */
export async function expectAccessible(page: Page, state: string): Promise<void> {
  const found: string[] = [];
  for (const [size, theme, rules] of [
    [DESK, 'light', 'all'],
    [DESK, 'dark', 'contrast'],
    [PHONE, 'dark', 'contrast'],
    [PHONE, 'light', 'all'],
  ] as const) {
    await page.setViewportSize(size);
    await page.emulateMedia({ colorScheme: theme, reducedMotion: 'reduce' });
    const place = `${state}, ${theme}, ${size.width} wide`;
    found.push(...(await findings(page, rules)).map((one) => `${place}: ${one}`));
  }
  await page.setViewportSize(DESK);
  expect(found).toEqual([]);
}
