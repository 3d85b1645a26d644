// How much the page asks of the graphics card, and in which frame it answers the pointer: counted, since a clock tells
// of the machine (page-times.ts has the clocks). Drawing itself is switched off: without a graphics card it takes long.
import type { Page } from '@playwright/test';
import { scaffold } from './helpers/sketches.ts';
import { canvasPoint, expect, openEmpty, openText, settled, test } from './helpers/test.ts';

const MOVES = 60;

interface Costs {
  /** Draw calls and triangles of each frame. */
  calls: number[];
  triangles: number[];
  /** For each move of the pointer that a picture followed: in which frame after it. */
  lags: number[];
}

declare global {
  interface Window {
    costs: Costs;
  }
}

async function countDrawing(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const costs: Costs = { calls: [], triangles: [], lags: [] };
    window.costs = costs;
    let calls = 0;
    let triangles = 0;
    let frame = 0;
    let frames = 0;
    let movedAt: number | null = null;
    const count = (vertices: number, instances: number) => {
      calls += 1;
      triangles += (vertices / 3) * instances;
    };
    const gl = WebGL2RenderingContext.prototype;
    gl.drawArrays = (_mode, _first, vertices) => count(vertices, 1);
    gl.drawElements = (_mode, vertices) => count(vertices, 1);
    gl.drawArraysInstanced = (_mode, _first, vertices, n) => count(vertices, n);
    gl.drawElementsInstanced = (...args) => count(args[1], args[4]);
    window.addEventListener(
      'pointermove',
      () => {
        movedAt ??= frames;
      },
      { capture: true },
    );
    const request = window.requestAnimationFrame.bind(window);
    const tick = (now: number) => {
      frames += now === frame ? 0 : 1;
      frame = now;
      request(tick);
    };
    request(tick);
    window.requestAnimationFrame = (callback) =>
      request((now) => {
        calls = 0;
        triangles = 0;
        callback(now);
        if (calls > 0) {
          costs.calls.push(calls);
          costs.triangles.push(triangles);
          if (movedAt !== null) {
            costs.lags.push(frames + (now === frame ? 0 : 1) - movedAt);
            movedAt = null;
          }
        }
      });
  });
}

test('with 300 lines and a running search a picture follows each move of the pointer at once', async ({
  page,
}) => {
  await countDrawing(page);
  await openEmpty(page);
  await openText(page, scaffold(14));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Scaffold');
  await page.keyboard.press('l');
  const at = await canvasPoint(page, 0, 0);
  await page.mouse.click(at.x, at.y);
  await settled(page);
  await page.evaluate(() => {
    window.costs.lags.length = 0;
  });
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByRole('progressbar')).toBeVisible();
  for (let i = 0; i < MOVES; i++) {
    await page.mouse.move(at.x + 200 * Math.cos(i / 9), at.y + 150 * Math.sin(i / 7));
  }
  await expect(page.getByRole('progressbar')).toBeVisible();
  await expect.poll(() => page.evaluate(() => window.costs.lags.length)).toBeGreaterThan(10);
  const { lags } = await page.evaluate(() => window.costs);
  expect(Math.max(...lags)).toBeLessThanOrEqual(2);
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
  await countDrawing(page);
  await openEmpty(page);
  await openText(page, thousandParts(), 'thousand.model.json');
  await expect(page.getByText('1,000 bricks')).toBeVisible({ timeout: 60_000 });
  await page.keyboard.press('i');
  await settled(page);
  await expect.poll(() => page.evaluate(() => Math.max(...window.costs.calls))).toBeGreaterThan(10);
  const { calls, triangles } = await page.evaluate(() => window.costs);
  expect(Math.max(...calls)).toBeLessThan(150);
  expect(Math.max(...triangles)).toBeLessThan(4_000_000);
});
