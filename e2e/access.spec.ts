// What axe says of every screen: in both themes and at a phone's width (helpers/axe.ts).
import type { Page } from '@playwright/test';
import { LESSONS } from '../web/src/ui/lessons/lesson-table.ts';
import { expectAccessible } from './helpers/axe.ts';
import { linkOf, publicSketch } from './helpers/links.ts';
import { scaffold } from './helpers/sketches.ts';
import {
  expect,
  goTo,
  openEmpty,
  openPage,
  openText,
  runCommand,
  sharedTest,
  test,
} from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** The first visit's model in the drawing, with nothing open before it; where the last test has left it there. */
async function openModel(page: Page): Promise<void> {
  if (new URL(page.url(), 'http://none').searchParams.has('room') || page.url() === 'about:blank') {
    await openPage(page);
  }
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
}

// One state a test: on a slow machine axe takes its time each of the four times that it looks.

for (const flyout of ['Look inside', 'Standard views']) {
  sharedTest(`axe finds nothing in the menu ${flyout}`, async ({ page }) => {
    await openModel(page);
    const summary = page.locator(`summary[aria-label^="${flyout}"]`);
    await summary.click();
    await expectAccessible(page, flyout);
    await summary.click();
  });
}

for (const place of ['Check', 'Move']) {
  sharedTest(`axe finds nothing in the place ${place}`, async ({ page }) => {
    await openModel(page);
    await goTo(page, place);
    await expect(page.locator('.panel').getByText('Loading…')).toBeHidden();
    await expectAccessible(page, place);
    await goTo(page, 'Draw');
  });
}

for (const [words, name] of [
  ['menu', 'Menu'],
  ['all commands', 'All commands'],
  ['keys help', 'Keys and help'],
  ['examples', 'Examples'],
  ['my sketches', 'My sketches'],
  ['brick set', 'Brick set'],
  ['alternatives', 'Other models of this drawing'],
  ['about', 'About Liftarm'],
] as const) {
  sharedTest(`axe finds nothing on the sheet ${name}`, async ({ page }) => {
    await openModel(page);
    await runCommand(page, words);
    await expect(page.getByRole('dialog', { name })).toBeVisible();
    await expectAccessible(page, name);
    await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toBeHidden();
  });
}

sharedTest('axe finds nothing in the drawing with a model and its panel', async ({ page }) => {
  await openModel(page);
  const sections = page.locator('.panel details');
  const open = (all: boolean) =>
    sections.evaluateAll((details, wanted) => {
      for (const section of details) {
        (section as HTMLDetailsElement).open = wanted;
      }
    }, all);
  await open(true);
  await expectAccessible(page, 'the model');
  await open(false);
});

test('axe finds nothing on the empty page', async ({ page }) => {
  await openEmpty(page);
  await expectAccessible(page, 'the empty page');
});

/** Notes the workers that the page starts, so that they can be stopped. */
function noteWorkers(): void {
  const workers: Worker[] = [];
  Object.assign(window, { workers });
  window.Worker = class extends Worker {
    constructor(...asked: ConstructorParameters<typeof Worker>) {
      super(...asked);
      workers.push(this);
    }
  };
}

test('axe finds nothing while a search runs', async ({ page }) => {
  await page.addInitScript(noteWorkers);
  await openEmpty(page);
  await openText(page, scaffold(14));
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByText(/\d steps/)).toBeVisible({ timeout: 60_000 });
  // For the page it goes on; that it takes no time meanwhile leaves more to axe.
  await page.evaluate(() => {
    for (const worker of (window as unknown as { workers: Worker[] }).workers) {
      worker.terminate();
    }
  });
  await expectAccessible(page, 'a running search');
});

test('axe finds nothing when a search was stopped', async ({ page }) => {
  await openEmpty(page);
  await openText(page, scaffold(8));
  await page.getByRole('button', { name: /^Generate/ }).click();
  await page.getByRole('button', { name: /^Cancel/ }).click();
  await expect(page.getByText(/^Cancelled/)).toBeVisible();
  await expectAccessible(page, 'a search that was stopped');
});

test('axe finds nothing in a model that cannot be built', async ({ page }) => {
  await openEmpty(page);
  // Two lines cross between their nodes: no pin can join them there.
  const lines = [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [3.5, -4, 0], to: [3.5, 4, 0] },
  ];
  const sketch = { format: 'technic-sketch', version: 1, name: 'Crossing', lines };
  await openText(page, JSON.stringify(sketch));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Crossing');
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  await expectAccessible(page, 'a model that cannot be built');
});

test('axe finds nothing when a file is refused', async ({ page }) => {
  await openEmpty(page);
  await openText(page, '{"format": "technic-sketch", "version": 1, "lines": [{}]}');
  await expect(page.getByRole('alert')).toBeVisible();
  await expectAccessible(page, 'a file that is refused');
});

for (const tab of ['Steps', 'Parts', 'Film']) {
  sharedTest(`axe finds nothing in the instructions, ${tab}`, async ({ page }) => {
    await page.goto(`./?room=instructions${await linkOf(publicSketch('examples/square-frame'))}`);
    await expect(page.getByText('Loading…')).toBeHidden();
    await page.getByRole('radio', { name: tab, exact: true }).check({ force: true });
    await expectAccessible(page, `instructions, ${tab}`);
  });
}

sharedTest('axe finds nothing where files and links are taken', async ({ page }) => {
  await page.goto(`./?room=share${await linkOf(publicSketch('examples/square-frame'))}`);
  await expect(page.locator('.room-body > *').first()).toBeVisible();
  await expect(page.getByText('Loading…')).toBeHidden();
  await expectAccessible(page, 'share');
});

for (const [room, content] of [
  ['gallery', '.gallery-card'],
  ['lessons', '.lesson-card'],
  ['laboratory', '.lab-chip'],
  ['laboratory&lab=bricks', '.lab-select'],
  ['laboratory&lab=weights', '.lab-slider'],
  ['laboratory&lab=contest', '.contest-entries'],
  ['linkage', '.path-canvas'],
] as const) {
  sharedTest(`axe finds nothing in the room ${room}`, async ({ page }) => {
    await page.goto(`./?room=${room}`);
    await expect(page.locator(content).first()).toBeVisible();
    await expectAccessible(page, room);
  });
}

for (const { id } of LESSONS) {
  sharedTest(`axe finds nothing in the lesson ${id}`, async ({ page }) => {
    await page.goto(`./?room=lessons&lesson=${id}`);
    await expect(page.locator(`[data-lesson="${id}"]`).locator('svg').first()).toBeVisible();
    await expectAccessible(page, `lesson ${id}`);
  });
}

sharedTest('axe finds nothing on the teacher’s page', async ({ page }) => {
  await page.goto('./?room=lessons&lesson=teacher');
  await expect(page.locator('.room-body button').first()).toBeVisible();
  await expect(page.getByText('Loading…')).toBeHidden();
  await expectAccessible(page, 'the teacher’s page');
});

test('axe finds nothing in the viewer for other pages', async ({ page }) => {
  await page.goto(`./embed.html${await linkOf(publicSketch('examples/square-frame'))}`);
  await expect(page.locator('.embed-status')).toHaveAttribute('data-bricks', '8', {
    timeout: 90_000,
  });
  await expectAccessible(page, 'the viewer');
});

test('the page speaks German to those who ask for it', async ({ page }) => {
  await page.goto('/?lang=de#s2.broken.0');
  await expect(page.getByRole('button', { name: 'Rückgängig' })).toBeVisible();
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  await expect(page.getByRole('alert')).toContainText('Dieser Link ist beschädigt');
  await page.getByRole('link', { name: 'Prüfen' }).click();
  await expect(page.getByText('Jedes Teil gibt es')).toBeVisible({ timeout: 60_000 });
  await page.keyboard.press('Control+k');
  await page.locator('.palette-input').fill('sprache english');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeVisible();
});

/** A rail with an arm that turns. */
const ARM = {
  format: 'technic-sketch',
  version: 1,
  name: 'Arm',
  lines: [
    { from: [0, 0, 0], to: [10, 0, 0] },
    { from: [0, 0, 0], to: [0, 6, 0] },
  ],
  joints: [{ at: [0, 0, 0], axis: [0, 0, 1] }],
};

test('axe finds nothing beside a selected line with its length, nor in the card of numbers', async ({
  page,
}) => {
  await openEmpty(page);
  await openText(page, JSON.stringify(ARM));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Arm');
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('.');
  await page.keyboard.press('Shift+O');
  await expect(page.getByRole('textbox', { name: 'Length of line 1' })).toBeVisible();
  await expect(page.getByRole('region', { name: 'By numbers' })).toBeVisible();
  await expectAccessible(page, 'a line and the card of numbers');
});

test('axe finds nothing where a joint is turned, plotted and filmed', async ({ page }) => {
  await openEmpty(page);
  await openText(page, JSON.stringify(ARM));
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  await goTo(page, 'Move');
  await expect(page.getByRole('img', { name: /^Angles over time/ })).toBeVisible({
    timeout: 60_000,
  });
  await expectAccessible(page, 'a joint that is turned');
});
