// Everything that can be done can be done from the keyboard.
import type { Page } from '@playwright/test';
import type { Actions } from '../web/src/app/actions.ts';
import { commandTable } from '../web/src/app/commands.ts';
import { linkOf } from './helpers/links.ts';
import { begun, expect, openPage, openPalette, settled, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** Every command can be done with all of it selected, and every one that edits changes something. */
const SKETCH = {
  format: 'technic-sketch',
  version: 1,
  name: 'A bit of everything',
  lines: [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [0, 0, 0], to: [0, 6, 0] },
    { from: [0, 6, 0], to: [0, 10, 0] },
    { from: [8, 0, 0], to: [8, 0, 4], holeAxis: 'x' },
  ],
  joints: [{ at: [0, 0, 0], axis: [0, 0, 1] }],
  keepOut: [{ min: [3, 3, 3], max: [4, 4, 4] }],
  ground: -3,
} as const;

/** Commands of these groups change the sketch, each once, but for those in the second list. */
const CHANGING = ['Edit', 'Annotate'];
const NOT_CHANGING = [
  'undo',
  'redo',
  'copy',
  'offset',
  'selectAll',
  'selectConnected',
  'selectNext',
  'selectPrevious',
  'selectChain',
  'tool.array',
  'tool.joint',
  'tool.keepOut',
  'tool.shaft',
];
/** These end what the others need, so they come last; the language is the very last. */
const LAST = [
  'generate',
  'newSeed',
  'searchLonger',
  'new',
  'languageEn',
  'languageAuto',
  'languageDe',
];
const SHARES = 6;
/** There only while a search runs (access.spec.ts), with something undone or hidden, or with shafts (shafts.spec.ts). */
const IN_OTHER_STATES = [
  'cancel',
  'clearShafts',
  'crankOnShaft',
  'wheelsOnShaft',
  'redo',
  'isolateNone',
];

/** Has every property, and each is this again: enough to make the table of commands, of which only the names are read. */
const ANYTHING: Actions = new Proxy(() => undefined, {
  get: () => ANYTHING,
}) as unknown as Actions;

interface Row {
  readonly id: string;
  readonly label: string;
  readonly group: string;
}

const options = (page: Page) => page.locator('.palette [role=option]');

async function rowsOfPalette(page: Page): Promise<Row[]> {
  await openPalette(page);
  return options(page).evaluateAll((rows) =>
    rows.map((option) => ({
      id: option.id.replace(/^command-/, ''),
      label: option.querySelector('.palette-label')?.textContent ?? '',
      group: option.querySelector('.quiet')?.textContent ?? '',
    })),
  );
}

/** Back to the drawing from whatever a command has opened. */
async function leave(page: Page): Promise<void> {
  // A room or a sheet may come a moment after the command: whatever is there is left, until nothing is.
  await settled(page);
  await expect(async () => {
    if (await page.locator('.room').isVisible()) {
      await page.getByRole('button', { name: 'Back to the drawing' }).press('Enter');
      await expect(page.locator('.room')).toBeHidden({ timeout: 5000 });
    }
    await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toBeHidden({ timeout: 5000 });
    await expect(page.locator('.room')).toBeHidden({ timeout: 100 });
  }).toPass();
}

/** Opens the page with something of all kinds, and a model; `n` takes its last line and what hangs on it. */
async function openWithModel(page: Page): Promise<void> {
  await page.addInitScript(() => {
    if (localStorage.getItem('liftarm/preferences') === null) {
      localStorage.setItem('liftarm/preferences', JSON.stringify({ autoSolve: false }));
    }
    window.print = () => undefined;
  });
  page.on('filechooser', () => undefined);
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await openPage(page, `/${await linkOf(SKETCH as never)}`);
  await page.keyboard.press('Control+Enter');
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  await page.keyboard.press('Control+a');
  // There is something to paste in every share of the commands, or undoing it takes the drawing away.
  await page.keyboard.press('Control+c');
  await page.keyboard.press('n');
}

/** Runs the command that the palette finds for a row's words, and makes undone what it did. */
async function runRow(page: Page, { id, label, group }: Row): Promise<void> {
  await page.keyboard.press('Control+a');
  await page.keyboard.press('n');
  await (await openPalette(page)).fill(label);
  // Others may have the same words, but none goes before the one that has them in this order.
  await expect(options(page).first(), label).toHaveId(`command-${id}`);
  // A page is loaded again for its language.
  const loaded = id.startsWith('language') ? page.waitForEvent('load') : null;
  await page.keyboard.press('Enter');
  if (loaded) {
    await loaded;
    await begun(page);
  }
  await leave(page);
  if (CHANGING.includes(group) && !NOT_CHANGING.includes(id)) {
    await page.keyboard.press('Control+z');
  }
  if (id === 'undo') {
    await page.keyboard.press('Control+Shift+z');
  }
}

test('every command is in the palette', async ({ page }) => {
  await openWithModel(page);
  const found = (await rowsOfPalette(page)).map(({ id }) => id);
  const missing = commandTable(ANYTHING)
    .all.map(({ id }) => id)
    .filter((id) => !found.includes(id));
  expect(missing.sort()).toEqual([...IN_OTHER_STATES].sort());
});

// A share of the commands each: a slow machine takes seconds for one.
for (let share = 0; share < SHARES; share++) {
  test(`commands are found in the palette by their names and run, ${share + 1} of ${SHARES}`, async ({
    page,
  }) => {
    test.setTimeout(240_000);
    await openWithModel(page);
    const all = await rowsOfPalette(page);
    await leave(page);
    const rank = ({ id }: Row) => LAST.indexOf(id);
    // Languages one after the other: the page is loaded again only for another than it has.
    const shareOf = ({ id }: Row, i: number) => (id.startsWith('language') ? 0 : i % SHARES);
    const mine = all.filter((row, i) => shareOf(row, i) === share);
    expect(mine.length).toBeGreaterThan(5);
    for (const row of mine.sort((a, b) => rank(a) - rank(b))) {
      await runRow(page, row);
    }
  });
}

/** What Tab does not come by, and what does not show that it has the focus. */
async function unreached(page: Page): Promise<string[]> {
  await page.evaluate(() => {
    const seen = new Set<Element>();
    const dim = new Set<Element>();
    Object.assign(window, { seen, dim });
    (document.activeElement as HTMLElement | null)?.blur();
    const outlined = (element: Element | null | undefined) => {
      const style = element ? getComputedStyle(element) : null;
      return style !== null && style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0;
    };
    document.addEventListener('focusin', ({ target }) => {
      const at = target as Element;
      seen.add(at);
      // A hidden radio button shows it on its words or on its box.
      const shown = [at, at.nextElementSibling, at.parentElement, at.parentElement?.parentElement];
      if (!shown.some(outlined)) {
        dim.add(at);
      }
    });
  });
  const controls = 'a[href], button, input, select, textarea, summary, [tabindex="0"]';
  // A button that makes its file, or a row that comes late, can be passed by once: what is there in the end counts,
  // and two more rounds come by it.
  let left: string[] = [];
  for (let round = 0; round < 3; round++) {
    const count = await page.locator(controls).count();
    for (let i = 0; i < count + 5; i++) {
      await page.keyboard.press('Tab');
    }
    left = await missed(page, controls);
    if (left.length === 0) {
      break;
    }
  }
  return left;
}

/** What is there now and was not come by, and what did not show the focus. */
function missed(page: Page, controls: string): Promise<string[]> {
  return page.evaluate((selector) => {
    const { seen, dim } = window as unknown as { seen: Set<Element>; dim: Set<Element> };
    const radio = (element: Element) =>
      element instanceof HTMLInputElement && element.type === 'radio' ? element.name : null;
    const groups = new Set([...seen].map(radio));
    const missed = [...document.querySelectorAll(selector)].filter(
      (element) =>
        element.checkVisibility({ visibilityProperty: true }) &&
        !element.matches(':disabled') &&
        element.closest('[inert]') === null &&
        !seen.has(element) &&
        !(radio(element) !== null && groups.has(radio(element))),
    );
    return [
      ...missed.map((element) => `not reached: ${element.outerHTML.slice(0, 160)}`),
      ...[...dim].map((element) => `focus not shown: ${element.outerHTML.slice(0, 160)}`),
    ];
  }, controls);
}

test('Tab comes by every control of the drawing and shows where it is', async ({ page }) => {
  await openPage(page, `/${await linkOf(SKETCH as never)}`);
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  await page.locator('details').evaluateAll((sections) => {
    for (const section of sections) {
      (section as HTMLDetailsElement).open = true;
    }
  });
  expect(await unreached(page)).toEqual([]);
});

for (const room of [
  'instructions',
  'share',
  'gallery',
  'lessons',
  'lessons&lesson=teacher',
  'laboratory',
  'laboratory&lab=weights',
  'laboratory&lab=contest',
  'linkage',
]) {
  test(`Tab comes by every control of the room ${room}`, async ({ page }) => {
    await page.goto(`./?room=${room}${await linkOf(SKETCH as never)}`);
    await expect(page.locator('.room-body button').first()).toBeVisible({ timeout: 60_000 });
    await expect(page.getByText('Loading…')).toBeHidden();
    if (room.endsWith('teacher')) {
      // Its links come all at once, when the last is packed.
      await expect(page.locator('.room-body a[href*="#s2."]').nth(10)).toBeVisible();
    }
    await expect(page.locator('.room-body [aria-busy="true"]')).toHaveCount(0);
    expect(await unreached(page)).toEqual([]);
  });
}
