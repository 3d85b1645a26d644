import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import type { Page } from '@playwright/test';
import { expect, steadyBox, test } from './helpers/test.ts';

const gallery = JSON.parse(
  readFileSync(resolve(import.meta.dirname, '../public/gallery/index.json'), 'utf8'),
) as { readonly models: readonly unknown[] };

async function openLesson(page: Page, id: string): Promise<void> {
  await page.addInitScript(() => {
    localStorage.setItem('liftarm/preferences', JSON.stringify({ autoSolve: false }));
  });
  await page.goto(`./?room=lessons&lesson=${id}`);
  await expect(page.locator(`[data-lesson="${id}"] svg`).first()).toBeVisible();
}

test.use({ draws: false });

/** Takes one of a few choices: radio buttons that lie under their words. */
async function choose(page: Page, legend: string, label: string): Promise<void> {
  await page
    .getByRole('group', { name: legend })
    .getByRole('radio', { name: label, exact: true })
    .check({ force: true });
}

const praise = (page: Page) => page.getByTestId('praise');

test('a lesson that is opened by its link does not wait for a drawing behind it', async ({
  page,
}) => {
  await page.goto('./?room=lessons&lesson=graph');
  await expect(page.locator('[data-lesson="graph"] svg').first()).toBeVisible();
  await expect(page.locator('.scene canvas')).toHaveCount(0);
  await page.getByRole('button', { name: 'Back to the drawing' }).click();
  await expect(page.locator('.scene canvas')).toBeVisible();
  await expect(page.getByTestId('verdict')).toContainText('Buildable');
});

test('guiding graph: beams cover every edge', async ({ page }) => {
  await openLesson(page, 'graph');
  // Lines have 8, 6 and 10 edges; the last takes two beams.
  for (const [from, to] of [
    ['1/1', '1/9'],
    ['2/1', '2/7'],
    ['3/1', '3/9'],
    ['3/9', '3/11'],
  ] as const) {
    await page.getByRole('button', { name: from, exact: true }).press('Enter');
    await page.getByRole('button', { name: to, exact: true }).press('Enter');
  }
  await expect(page.getByTestId('covered')).toContainText('24 of 24');
  await expect(praise(page)).toContainText('Well done');
});

test('hole axes: as few connectors as possible', async ({ page }) => {
  await openLesson(page, 'axes');
  await expect(page.getByTestId('connectors')).toContainText('3');
  await choose(page, 'Beam 1 along x', 'z');
  await expect(page.getByTestId('connectors')).toContainText('2');
  await expect(praise(page)).toContainText('Well done');
});

test('annealing: hot, then cooled, it settles', async ({ page }) => {
  await openLesson(page, 'annealing');
  await page.getByLabel('Temperature').fill('2');
  await page.getByLabel('Cool down by itself').check();
  await page.getByRole('button', { name: 'Run' }).click();
  await expect(page.getByText(/[1-9]\d* tries/)).toBeVisible();
  for (let i = 0; i < 5 && (await praise(page).textContent()) === ''; i++) {
    await expect(async () => {
      const cold = (await page.getByLabel('Temperature').inputValue()) === '0';
      expect(cold || (await praise(page).textContent()) !== '').toBe(true);
    }).toPass({ timeout: 60_000 });
    if ((await praise(page).textContent()) === '') {
      await page.getByRole('button', { name: 'Start again' }).click();
      await page.getByLabel('Temperature').fill('2');
    }
  }
  await expect(praise(page)).toContainText('Well done');
});

test('folding: a brace of ten holds a frame of six and eight', async ({ page }) => {
  await openLesson(page, 'folding');
  await page.getByRole('slider', { name: /^Corner/ }).press('ArrowRight');
  await expect(page.getByTestId('fold-state')).toContainText('87');
  await choose(page, 'Brace', '9');
  await expect(page.getByTestId('fold-state')).toContainText('leans');
  await choose(page, 'Brace', '10');
  await expect(praise(page)).toContainText('Well done');
});

test('puzzle: beams by mouse and by keys, and the solver plays along', async ({ page }) => {
  await openLesson(page, 'puzzle');
  const board = page.locator('.puzzle-board');
  const box = await steadyBox(board);
  const unit = box.width / 10;
  const place = (x: number, y: number) =>
    [box.x + (x + 1) * unit, box.y + box.height - (y + 1) * unit] as const;
  const drag = async (from: readonly [number, number], to: readonly [number, number]) => {
    await page.mouse.move(...place(...from));
    await page.mouse.down();
    await page.mouse.move(...place(...to), { steps: 3 });
    await page.mouse.up();
  };
  for (const at of [0, 4, 8]) {
    await drag([0, at], [8, at]);
  }
  await choose(page, 'Layer', '2');
  for (const at of [0, 4]) {
    await drag([at, 0], [at, 8]);
  }
  await expect(page.getByTestId('puzzle-uncovered')).toHaveText('8');
  await board.focus();
  // The cursor is where the mouse was last: at (4, 8).
  for (let i = 0; i < 4; i++) {
    await board.press('ArrowRight');
  }
  await board.press('Enter');
  for (let i = 0; i < 8; i++) {
    await board.press('ArrowDown');
  }
  await board.press('Enter');
  await expect(page.getByTestId('puzzle-collisions')).toHaveText('0');
  await expect(praise(page)).toContainText('6 beams');
  await page.getByRole('button', { name: 'Let the solver play' }).click();
  await expect(page.getByTestId('solver-says')).toContainText('6 beams', { timeout: 90_000 });
});

test('taking apart: blocked parts say so, pairs move together', async ({ page }) => {
  await openLesson(page, 'apart');
  const part = (n: number) => page.getByRole('button', { name: `Part ${n}` });
  await part(2).press('Enter');
  await page.getByRole('button', { name: 'Pull up' }).click();
  await expect(page.getByTestId('apart-says')).toContainText('Blocked');
  await choose(page, 'Parts seen from the side', 'Assembly 2');
  for (const group of [[2, 3], [1]]) {
    for (const n of group) {
      await part(n).press('Enter');
    }
    await page.getByRole('button', { name: 'Pull up' }).click();
  }
  await expect(praise(page)).toContainText('2 moves');
});

test('a presentation has large type and figures that fit the projector', async ({ page }) => {
  await page.setViewportSize({ width: 1920, height: 1080 });
  await openLesson(page, 'folding');
  const type = () =>
    page.locator('.lesson-task').evaluate((task) => parseFloat(getComputedStyle(task).fontSize));
  const usual = await type();
  await page.getByRole('button', { name: 'Presentation mode' }).click();
  await expect.poll(type).toBeGreaterThanOrEqual(24);
  // The figure and what it is changed with are on screen together.
  await expect(page.locator('.lesson-figure').first()).toBeInViewport({ ratio: 1 });
  await expect(page.getByRole('group', { name: 'Brace' })).toBeInViewport();
  await page.getByRole('button', { name: 'End presentation' }).click();
  await expect.poll(type).toBe(usual);
});

test('the teacher’s page has a code for each lesson and model', async ({ page }) => {
  await openLessonsTeacher(page);
  await expect(page.locator('.handouts .qr-code')).toHaveCount(6 + gallery.models.length, {
    timeout: 60_000,
  });
  const link = page.locator('.handouts a').last();
  await expect(link).toHaveAttribute('href', /#s\d+\./);
  await page.emulateMedia({ media: 'print' });
  await expect(page.getByRole('button', { name: 'Print' })).toBeHidden();
  await expect(page.locator('.room-head')).toBeHidden();
  await expect(page.locator('.handouts .qr-code').last()).toBeVisible();
});

async function openLessonsTeacher(page: Page): Promise<void> {
  await page.goto('./?room=lessons&lesson=teacher');
  await expect(page.getByRole('heading', { name: 'For teachers' })).toBeVisible();
}
