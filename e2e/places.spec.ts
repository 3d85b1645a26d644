// Every place has its name in sight, an address of its own, and says what it lacks.
import type { Page } from '@playwright/test';
import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, goTo, openPage, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

const NAMES = ['Draw', 'Check', 'Move', 'Build', 'Share', 'Gallery', 'Learn', 'Lab'] as const;
const EMPTY = { format: 'technic-sketch', version: 1, name: 'Nothing', lines: [] } as const;

/** Opens the page with nothing drawn. */
async function openNothing(page: Page, place: string): Promise<void> {
  await page.goto(`./?room=${place}${await linkOf(EMPTY as never)}`);
}

/** Names of the places whose link is not wholly in sight, or too small to be hit, or covered. */
async function hiddenPlaces(page: Page): Promise<string[]> {
  return page.locator('.spine a').evaluateAll((links) =>
    links.flatMap((link) => {
      const { left, right, top, bottom, width, height } = link.getBoundingClientRect();
      const inside = left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
      const seen = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      const large = width >= 44 && height >= 36;
      return inside && large && link.contains(seen) ? [] : [link.textContent ?? ''];
    }),
  );
}

for (const [device, size] of [
  ['a desk', { width: 1280, height: 800 }],
  ['a phone', { width: 390, height: 844 }],
] as const) {
  test.describe(`on ${device}`, () => {
    test.use({ viewport: size });

    test('all places are in sight from every place, large enough for a finger', async ({
      page,
    }) => {
      await openPage(page);
      for (const name of NAMES) {
        await goTo(page, name);
        await expect.poll(() => hiddenPlaces(page), name).toEqual([]);
      }
    });
  });
}

test('a place has an address, and the back button leaves it', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Check');
  await expect(page).toHaveURL(/[?&]room=check/);
  await goTo(page, 'Build');
  await expect(page).toHaveURL(/[?&]room=instructions/);
  await page.goBack();
  await expect(page.getByRole('link', { name: 'Check' })).toHaveAttribute('aria-current', 'page');
  await expect(page.getByRole('heading', { name: 'Checks' })).toBeVisible({ timeout: 60_000 });
  await page.goBack();
  await expect(page.getByRole('link', { name: 'Draw' })).toHaveAttribute('aria-current', 'page');
});

test('an address opens its place', async ({ page }) => {
  await page.goto(`./?room=move${await linkOf(publicSketch('examples/seesaw'))}`);
  await expect(page.getByRole('slider', { name: 'Angle' })).toBeVisible({ timeout: 90_000 });
});

for (const place of ['check', 'move', 'instructions', 'share']) {
  test(`the place ${place} says that it needs a model, and the way to one`, async ({ page }) => {
    await openNothing(page, place);
    await expect(page.getByText('There is no model here yet.')).toBeVisible();
    await page.getByRole('button', { name: 'Go and draw' }).click();
    await expect(page.getByRole('link', { name: 'Draw' })).toHaveAttribute('aria-current', 'page');
  });
}

test('who takes a tool in another place is back at the drawing', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Move');
  await page.getByRole('button', { name: 'Put a joint' }).click();
  await expect(page.getByRole('link', { name: 'Draw' })).toHaveAttribute('aria-current', 'page');
  await expect(page.getByRole('button', { name: 'Joint' })).toHaveAttribute('aria-pressed', 'true');
});

test('the menu has groups, and what is chosen in it is done', async ({ page }) => {
  await openPage(page);
  await page.getByRole('button', { name: 'Menu', exact: true }).click();
  const menu = page.getByRole('dialog', { name: 'Menu' });
  for (const group of ['Save', 'Change', 'Looks', 'Help']) {
    await expect(menu.getByRole('heading', { name: group, exact: true })).toBeVisible();
  }
  await menu.getByRole('button', { name: 'Theme: dark' }).click();
  await expect(menu).toBeHidden();
  await expect(page.locator('html')).toHaveAttribute('data-theme', 'dark');
});

test.describe('a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('keeps half the height for the drawing, also with the sheet open', async ({ page }) => {
    await openPage(page);
    const height = async () => (await page.locator('.scene canvas').boundingBox())?.height ?? 0;
    await expect.poll(height).toBeGreaterThanOrEqual(422);
    await page.getByRole('button', { name: 'Show result and settings' }).tap();
    await expect.poll(height).toBeGreaterThanOrEqual(420);
    await goTo(page, 'Check');
    await expect.poll(height).toBeGreaterThanOrEqual(420);
  });

  test('shows where the row of tools goes on', async ({ page }) => {
    await openPage(page);
    const rail = page.getByRole('toolbar', { name: 'Tools' });
    await expect(rail).toHaveAttribute('data-more', 'end');
    await rail.evaluate((row) => row.scrollTo({ left: row.scrollWidth }));
    await expect(rail).toHaveAttribute('data-more', 'start');
  });
});

for (const width of [1280, 1190, 1000, 830]) {
  test(`the places leave room for what stands beside them, ${width} wide, in German`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height: 800 });
    await openPage(page, '/?lang=de');
    const last = await page.getByRole('link', { name: 'Labor', exact: true }).boundingBox();
    const undo = await page.getByRole('button', { name: /^Rückgängig/ }).boundingBox();
    expect((last?.x ?? 0) + (last?.width ?? 0)).toBeLessThanOrEqual(undo?.x ?? 0);
    expect((undo?.x ?? 0) + (undo?.width ?? 0)).toBeLessThanOrEqual(width);
    const outside = () =>
      page
        .locator('.top-bar button')
        .evaluateAll((all) =>
          all.flatMap((button) =>
            button.getBoundingClientRect().right > innerWidth ? [button.ariaLabel] : [],
          ),
        );
    expect(await outside()).toEqual([]);
    await goTo(page, 'Labor');
    expect(await outside()).toEqual([]);
  });
}
