// A newcomer's first minutes, click by click; the clicks stand in the table of docs/new-user.md.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import type { Locator, Page } from '@playwright/test';
import { canvasPoint, expect, openPage, settled, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** Somebody whose clicks are counted. */
class Newcomer {
  clicks = 0;
  readonly #page: Page;

  constructor(page: Page) {
    this.#page = page;
  }

  async press(control: Locator): Promise<void> {
    // What must be searched for is no button in sight.
    await expect(control).toBeInViewport({ ratio: 1 });
    await control.click();
    this.clicks += 1;
  }

  async draw(x: number, y: number): Promise<void> {
    const at = await canvasPoint(this.#page, x, y);
    await this.#page.mouse.move(at.x, at.y);
    await this.#page.mouse.click(at.x, at.y);
    this.clicks += 1;
  }

  button(name: string | RegExp): Locator {
    return this.#page.getByRole('button', { name, exact: typeof name === 'string' });
  }

  place(name: string): Locator {
    return this.#page.getByRole('link', { name, exact: true });
  }
}

/** Clicks by the row of the table that says them. */
const ROWS: Readonly<Record<string, (page: Page, person: Newcomer) => Promise<void>>> = {
  'a box, and its model': async (page, person) => {
    await person.press(person.button('Draw your own'));
    await person.press(person.button('Box frame'));
    await settled(page);
    await person.draw(-120, 0);
    await person.draw(120, -40);
    await person.draw(120, 60);
    await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  },
  'a box of 6 by 8 by 4, typed': async (page, person) => {
    await person.press(person.button('Draw your own'));
    await person.press(person.button('Take the box'));
    await page.keyboard.type('6,8,4');
    await page.keyboard.press('Enter');
    await expect(page.locator('.scene canvas')).toBeFocused();
    await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  },
  'the steps of the model on screen': async (page, person) => {
    await person.press(person.place('Build'));
    await expect(page.getByRole('img', { name: 'Picture of the step' })).toBeVisible({
      timeout: 60_000,
    });
  },
  'a link to it': async (page, person) => {
    await person.press(person.place('Share'));
    await person.press(person.button('Copy the link'));
    await expect(page.getByText('Copied.')).toBeVisible();
  },
  'what is wrong with it': async (page, person) => {
    await person.press(person.place('Check'));
    await expect(page.getByRole('heading', { name: 'Checks' })).toBeVisible();
  },
  'a lesson': async (page, person) => {
    await person.press(person.place('Learn'));
    await person.press(page.locator('.lesson-card').first());
    await expect(page.locator('[data-lesson] svg').first()).toBeVisible();
  },
  'another model to look at': async (page, person) => {
    await person.press(person.place('Gallery'));
    await person.press(page.locator('.gallery-open').first());
    await expect(person.place('Draw')).toHaveAttribute('aria-current', 'page');
  },
};

/** The clicks that the table of docs/new-user.md gives for a row. */
function clicksInDocs(row: string): number | null {
  const docs = readFileSync(resolve(import.meta.dirname, '../docs/new-user.md'), 'utf8');
  const cells = docs
    .split('\n')
    .map((line) => line.split('|').map((cell) => cell.trim()))
    .find(([, name]) => name === row);
  return cells ? Number(cells[2]) : null;
}

for (const [row, act] of Object.entries(ROWS)) {
  test(`a newcomer gets ${row} in as few clicks as the table says`, async ({ page }) => {
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await openPage(page);
    await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
    const person = new Newcomer(page);
    await act(page, person);
    expect(person.clicks).toBe(clicksInDocs(row));
  });
}

test('the first task is guided in three steps, and goes away for good', async ({ page }) => {
  await openPage(page);
  const guide = page.getByRole('region', { name: 'Your first model' });
  // An example is somebody else's drawing.
  await expect(guide).toBeHidden();
  await page.getByRole('button', { name: 'Draw your own' }).click();
  const step = guide.locator('[aria-current=step]');
  await expect(step).toContainText('Draw');
  await guide.getByRole('button', { name: 'Take the box' }).click();
  await page.keyboard.type('6,8,4');
  await page.keyboard.press('Enter');
  await expect(step).toContainText('Build', { timeout: 60_000 });
  await guide.getByRole('button', { name: 'Show the steps' }).click();
  await expect(page.getByRole('heading', { name: 'Building instructions' })).toBeVisible();
  await page.getByRole('link', { name: 'Draw', exact: true }).click();
  await expect(guide).toBeHidden();
  await page.reload();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  await expect(guide).toBeHidden();
});

test('the guide is waved away with one click', async ({ page }) => {
  await openPage(page);
  await page.getByRole('button', { name: 'Draw your own' }).click();
  const guide = page.getByRole('region', { name: 'Your first model' });
  await guide.getByRole('button', { name: 'No more tips' }).click();
  await expect(guide).toBeHidden();
});

test('undo has its place on a Cyrillic keyboard, too', async ({ page }) => {
  await openPage(page);
  await page.getByRole('button', { name: 'Draw your own' }).click();
  await expect(page.getByText('Draw some lines first.')).toBeVisible();
  await page.locator('.scene canvas').dispatchEvent('keydown', {
    key: 'я',
    code: 'KeyZ',
    ctrlKey: true,
    bubbles: true,
  });
  await expect(page.getByText('Draw some lines first.')).toBeHidden();
});
