import {
  expect,
  expectLines,
  generate,
  openEmpty,
  openPage,
  runCommand,
  test,
} from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

test('a box is drawn with the keyboard alone', async ({ page }) => {
  await openEmpty(page);
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('b');
  await page.keyboard.press('Enter');
  for (let i = 0; i < 4; i++) {
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowUp');
  }
  await expect(page.getByTestId('announcer')).toContainText('Cursor');
  await page.keyboard.press('Enter');
  for (let i = 0; i < 4; i++) {
    await page.keyboard.press('PageUp');
  }
  await page.keyboard.press('Enter');
  await expectLines(page, 12);
});

test('lines are drawn, generated and undone with the keyboard alone', async ({ page }) => {
  await openEmpty(page);
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('l');
  await page.keyboard.press('Enter');
  for (const [key, count] of [
    ['ArrowRight', 6],
    ['ArrowUp', 4],
    ['ArrowLeft', 6],
    ['ArrowDown', 4],
  ] as const) {
    for (let i = 0; i < count; i++) {
      await page.keyboard.press(key);
    }
    await page.keyboard.press('Enter');
  }
  await expectLines(page, 4);
  await generate(page);
  await page.keyboard.press('Control+z');
  await expectLines(page, 3);
});

test('every command is found in the palette and run from there', async ({ page }) => {
  await openEmpty(page);
  await runCommand(page, 'keys help');
  await expect(page.getByRole('dialog', { name: 'Keys and help' })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toBeHidden();
});

test('a sheet is there for the key that comes right after it was asked for', async ({ page }) => {
  await openPage(page);
  const open = await page.evaluate(async () => {
    document.querySelector<HTMLElement>('button[aria-label="Keys and help"]')?.click();
    // Drawn, but not yet shown: before the next frame.
    await new Promise((later) => setTimeout(later, 0));
    return document.querySelector('dialog')?.open;
  });
  expect(open).toBe(true);
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toBeHidden();
});

test('a key that comes right after Escape is not the closing sheet’s', async ({ page }) => {
  await openPage(page);
  const dialogs = await page.evaluate(async () => {
    const key = (init: KeyboardEventInit) =>
      (document.activeElement ?? document.body).dispatchEvent(
        new KeyboardEvent('keydown', { bubbles: true, cancelable: true, ...init }),
      );
    document.querySelector<HTMLElement>('button[aria-label="Keys and help"]')?.click();
    await new Promise((later) => setTimeout(later, 0));
    const help = document.querySelector('dialog');
    // What the browser does on Escape: it tells of the closing only later.
    help?.dispatchEvent(new Event('cancel', { cancelable: true }));
    help?.close();
    key({ key: 'k', code: 'KeyK', ctrlKey: true });
    const labels = () => [...document.querySelectorAll('dialog')].map((each) => each.ariaLabel);
    // The closed sheet goes and the new one comes with the next frames.
    for (let i = 0; i < 100 && labels().join() !== 'All commands'; i++) {
      await new Promise((later) => setTimeout(later, 50));
    }
    return labels();
  });
  expect(dialogs).toEqual(['All commands']);
});
