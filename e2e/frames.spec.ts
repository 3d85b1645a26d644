// What our own code costs on the page's main thread, and how much it asks of the graphics card. Drawing
// itself is switched off: without a graphics card it would be all that is measured.
import type { Page } from '@playwright/test';
import { scaffold } from './helpers/sketches.ts';
import { canvasPoint, expect, openEmpty, openText, settled, test } from './helpers/test.ts';

/** Milliseconds that the main thread may be taken at one time. */
const BLOCK = 50;
const MOVES = 60;

interface Costs {
  /** Script time of animation frames and of pointer events, ms. */
  frames: number[];
  events: number[];
  /** Draw calls and triangles of each frame. */
  calls: number[];
  triangles: number[];
}

declare global {
  interface Window {
    costs: Costs;
  }
}

async function measureCosts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const costs: Costs = { frames: [], events: [], calls: [], triangles: [] };
    window.costs = costs;
    let calls = 0;
    let triangles = 0;
    const count = (vertices: number, instances: number) => {
      calls += 1;
      triangles += (vertices / 3) * instances;
    };
    const gl = WebGL2RenderingContext.prototype;
    gl.drawArrays = (_mode, _first, vertices) => count(vertices, 1);
    gl.drawElements = (_mode, vertices) => count(vertices, 1);
    gl.drawArraysInstanced = (_mode, _first, vertices, n) => count(vertices, n);
    gl.drawElementsInstanced = (...args) => count(args[1], args[4]);
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) =>
      request((now) => {
        const begin = performance.now();
        calls = 0;
        triangles = 0;
        callback(now);
        costs.frames.push(performance.now() - begin);
        if (calls > 0) {
          costs.calls.push(calls);
          costs.triangles.push(triangles);
        }
      });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries() as PerformanceEventTiming[]) {
        costs.events.push(entry.processingEnd - entry.processingStart);
      }
    }).observe({ type: 'event', durationThreshold: 16 } as PerformanceObserverInit);
  });
}

/** The value that all but one in twenty stay below: a busy machine may stop us for a moment. */
function usually(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length * 0.95)] ?? 0;
}

test('with 300 lines and a running search the pointer never waits', async ({ page }) => {
  await measureCosts(page);
  await openEmpty(page);
  await openText(page, scaffold(14));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Scaffold');
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByRole('progressbar')).toBeVisible();
  await page.keyboard.press('l');
  const at = await canvasPoint(page, 0, 0);
  await page.mouse.click(at.x, at.y);
  await page.evaluate(() => {
    window.costs.frames.length = 0;
    window.costs.events.length = 0;
  });
  for (let i = 0; i < MOVES; i++) {
    await page.mouse.move(at.x + 200 * Math.cos(i / 9), at.y + 150 * Math.sin(i / 7));
  }
  await expect(page.getByRole('progressbar')).toBeVisible();
  const { frames, events } = await page.evaluate(() => window.costs);
  expect(frames.length).toBeGreaterThan(10);
  expect(usually(frames)).toBeLessThan(BLOCK);
  expect(usually(events)).toBeLessThan(BLOCK);
});

/** A thousand parts of many kinds, side by side. */
function thousandParts(): string {
  const kinds = ['32523', '32316', '32524', '40490', '32525', '32278', '2780', '6558', '3673'];
  const parts = Array.from({ length: 1000 }, (_, i) => ({
    part: kinds[i % kinds.length],
    color: 71,
    position: [(i % 10) * 20, (Math.floor(i / 10) % 10) * 3, Math.floor(i / 100) * 3],
    rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1],
    component: 0,
    layer: 0,
    piece: 0,
  }));
  return JSON.stringify({ format: 'liftarm-model', version: 1, name: 'Thousand', parts });
}

test('a model of 1,000 parts stays within its draw calls and triangles', async ({ page }) => {
  await measureCosts(page);
  await openEmpty(page);
  await openText(page, thousandParts(), 'thousand.model.json');
  await expect(page.getByText('1,000 bricks')).toBeVisible({ timeout: 60_000 });
  await page.keyboard.press('i');
  await settled(page);
  const { calls, triangles } = await page.evaluate(() => window.costs);
  expect(Math.max(...calls)).toBeGreaterThan(10);
  expect(Math.max(...calls)).toBeLessThan(150);
  expect(Math.max(...triangles)).toBeLessThan(4_000_000);
});
