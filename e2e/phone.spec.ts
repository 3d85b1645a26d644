import type { CDPSession } from '@playwright/test';
import { canvasPoint, expect, expectLines, goTo, openPage, settled, test } from './helpers/test.ts';

test.use({ draws: false, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

async function drag(
  session: CDPSession,
  from: { x: number; y: number },
  to: { x: number; y: number },
): Promise<void> {
  const touch = (
    type: 'touchStart' | 'touchMove' | 'touchEnd',
    points: { x: number; y: number }[],
  ) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
  await touch('touchStart', [from]);
  await touch('touchMove', [{ x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 }]);
  await touch('touchMove', [to]);
  await touch('touchEnd', []);
}

test('one finger draws a line on a phone', async ({ page }) => {
  await openPage(page);
  await page.getByRole('button', { name: 'Menu' }).tap();
  await page.getByRole('button', { name: 'New sketch' }).tap();
  await page.keyboard.press('t');
  await settled(page);
  const session = await page.context().newCDPSession(page);
  await drag(session, await canvasPoint(page, -90, 40), await canvasPoint(page, 90, 40));
  await expectLines(page, 1);
});

test('the sheet opens over the drawing and closes again', async ({ page }) => {
  await openPage(page);
  const choice = page.getByText('Generate after each edit');
  await expect(choice).toBeHidden();
  await page.getByRole('button', { name: 'Show result and settings' }).tap();
  await expect(choice).toBeVisible();
  await page.getByRole('button', { name: 'Hide result and settings' }).tap();
  await expect(choice).toBeHidden();
});

test('a room covers the drawing, down to the places', async ({ page }) => {
  await openPage(page);
  await goTo(page, 'Share');
  const room = page.locator('.room');
  await expect(room).toBeVisible();
  const places = await page.getByRole('navigation').boundingBox();
  const box = await room.boundingBox();
  expect(box?.y).toBe(0);
  expect((box?.y ?? 0) + (box?.height ?? 0)).toBeCloseTo(places?.y ?? 0, 0);
});
