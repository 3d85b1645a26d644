import type { Page } from '@playwright/test';
import axe from 'axe-core';
import { expect } from './test.ts';

const DESK = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844 };

/** Nothing is made of what passes: selectors of six hundred elements take longer than the rules. */
const VIOLATIONS_ALONE: axe.RunOptions = { resultTypes: ['violations'] };

const RULES: Readonly<Record<'all' | 'contrast', axe.RunOptions>> = {
  all: { ...VIOLATIONS_ALONE, rules: { 'target-size': { enabled: true } } },
  contrast: { ...VIOLATIONS_ALONE, runOnly: { type: 'rule', values: ['color-contrast'] } },
};

/** What axe finds moderate or worse: the rule and the elements. */
async function findings(page: Page, rules: keyof typeof RULES): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in window))) {
    await page.evaluate(axe.source);
  }
  return page.evaluate(async (options) => {
    const { run } = (window as unknown as { axe: typeof axe }).axe;
    const { violations } = await run(document, options);
    return violations
      .filter(({ impact }) => impact !== 'minor')
      .flatMap(({ id, nodes }) =>
        nodes.map((node) => `${id}: ${node.target.join(' ')} ${node.html}`),
      );
  }, RULES[rules]);
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
