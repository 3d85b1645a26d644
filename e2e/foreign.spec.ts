import { Uint8ArrayReader, Uint8ArrayWriter, ZipWriter } from '@zip.js/zip.js';
import { downloaded, expect, goTo, openPage, openText, test } from './helpers/test.ts';

test.use({ draws: false });

/** Two beams on two pins, a brick that is not known here, and a lever whose shape the file holds. */
const MODEL = `0 FILE main.ldr
1 71 0 0 0 1 0 0 0 1 0 0 0 1 32316.dat
1 71 0 20 0 1 0 0 0 1 0 0 0 1 32316.dat
0 STEP
1 0 0 10 40 0 1 0 -1 0 0 0 0 1 2780.dat
1 0 0 10 -40 0 1 0 -1 0 0 0 0 1 2780.dat
1 4 0 -40 0 1 0 0 0 1 0 0 0 1 3001.dat
1 14 0 40 0 1 0 0 0 1 0 0 0 1 lever.dat
0 FILE lever.dat
0 Lever of my own
3 16 0 0 0 40 0 0 0 20 0
4 16 0 0 0 40 0 0 40 0 40 0 0 40
`;

/** A file of Studio's, closed as it closes them. */
async function studioFile(text: string): Promise<Buffer> {
  const zip = new ZipWriter(new Uint8ArrayWriter(), { password: 'soho0909', zipCrypto: true });
  await zip.add('model.ldr', new Uint8ArrayReader(new TextEncoder().encode(text)));
  return Buffer.from(await zip.close());
}

test('a Studio file is shown whole, judged as far as it is known, and gets steps', async ({
  page,
}) => {
  await openPage(page);
  await openText(page, await studioFile(MODEL), 'My car.io');
  await expect(
    page.getByText('parts that are not known here are not judged: 3001 (1), lever (1)'),
  ).toBeVisible();
  const verdict = page.getByTestId('verdict');
  await expect(verdict).toContainText('What is known here is buildable');
  await expect(verdict).toContainText('2 parts are not known here');
  await expect(page.locator('.lamp.ok')).toHaveCount(0);

  const list = await downloaded(page, async () => {
    await page
      .getByLabel('Download', { exact: true })
      .getByRole('button', { name: 'Parts' })
      .click();
  });
  expect(list).toContain('3001,4,1');

  await goTo(page, 'Build');
  await expect(page.locator('.instructions')).toBeVisible({ timeout: 60_000 });
  await page.keyboard.press('End');
  await expect(page.getByText('Not known here, so not judged')).toBeVisible();
  await page.getByRole('radio', { name: 'Parts', exact: true }).check({ force: true });
  await expect(page.locator('.instructions').getByText('Lever of my own')).toBeVisible();
});

/** A beam whose end hole is for axles, with a round pin in it, and a beam beside. */
const WRONG_PIN = [
  '1 71 0 0 0 1 0 0 0 1 0 0 0 1 60483.dat',
  '1 71 0 -20 0 1 0 0 0 1 0 0 0 1 32316.dat',
];

test('a pin that does not fit is put right by a click, and taken back by another', async ({
  page,
}) => {
  await openPage(page);
  const pin = '1 0 0 -10 0 0 -1 0 1 0 0 0 0 1 2780.dat';
  await openText(page, [...WRONG_PIN, pin].join('\n'), 'beams.ldr');
  const verdict = page.getByTestId('verdict');
  await expect(verdict).toContainText('Not buildable yet');
  await page.getByRole('button', { name: 'Look for a mend' }).click();
  await expect(page.getByText('nothing is wrong any more')).toBeVisible({ timeout: 60_000 });
  await expect(verdict).not.toContainText('Not buildable yet');
  await page.locator('.toast').getByRole('button', { name: 'Undo' }).click();
  await expect(verdict).toContainText('Not buildable yet');
});
