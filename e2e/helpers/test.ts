import { test as base, type Download, expect, type Locator, type Page } from '@playwright/test';

/** Software rendering waits for its pixels and says so; that is no fault of the page. */
const HARMLESS = /GPU stall due to ReadPixels/;

interface Options {
  /** Whether pictures are really drawn: without a graphics card that takes most of the time. */
  draws: boolean;
}

/** A test whose page must say nothing on the console that is an error, and throw nothing. */
export const test = base.extend<Options>({
  draws: [true, { option: true }],
  page: async ({ page, draws }, use) => {
    const errors = await prepare(page, draws);
    await use(page);
    expect(errors).toEqual([]);
  },
});

interface SharedPage {
  readonly page: Page;
  readonly errors: string[];
}

/**
 * A test on a page that draws nothing and is kept for the next test of this worker: most of what a short test
 * costs is the start of its page. For tests that leave the page and what the browser keeps as they were.
 */
export const sharedTest = test.extend<object, { sharedPage: SharedPage }>({
  sharedPage: [
    async ({ browser }, use, { project }) => {
      const { baseURL, viewport } = project.use;
      const context = await browser.newContext({
        ...(baseURL ? { baseURL } : {}),
        ...(viewport ? { viewport } : {}),
      });
      const page = await context.newPage();
      await use({ page, errors: await prepare(page, false) });
      await context.close();
    },
    { scope: 'worker' },
  ],
  page: async ({ sharedPage }, use) => {
    const { page, errors } = sharedPage;
    errors.length = 0;
    await use(page);
    expect(errors).toEqual([]);
  },
});

/** @returns what the page says on the console that is an error, and throws, from now on. */
async function prepare(page: Page, draws: boolean): Promise<string[]> {
  if (!draws) {
    await page.addInitScript(withoutDrawing);
  }
  const errors: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error' && !HARMLESS.test(message.text())) {
      errors.push(message.text());
    }
  });
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  // Moving pictures cost seconds without a graphics card.
  await page.emulateMedia({ reducedMotion: 'reduce' });
  return errors;
}

/** Runs in the page: everything works as ever, only that no pixel is touched. */
export function withoutDrawing(): void {
  const gl = WebGL2RenderingContext.prototype;
  const nothing = () => undefined;
  gl.drawArrays = nothing;
  gl.drawElements = nothing;
  gl.drawArraysInstanced = nothing;
  gl.drawElementsInstanced = nothing;
  gl.clear = nothing;
}

/** Waits until the page has what it begins with (the last visit's sketch, a link's, or the first example), and keeps edits. */
export async function begun(page: Page): Promise<void> {
  await expect(page.locator('html[data-kept]')).toBeAttached({ timeout: 60_000 });
}

/** Opens the page and waits until it can be used. */
export async function openPage(page: Page, address = '/'): Promise<void> {
  await page.goto(address);
  await begun(page);
  await expect(page.locator('.scene canvas')).toBeVisible();
  await expect(page.getByText('Draw some lines first.')).toBeHidden();
}

/** Opens the page with nothing drawn and nothing solved by itself, seen from straight above. */
export async function openEmpty(page: Page, preferences: object = {}): Promise<void> {
  await page.addInitScript((wanted) => {
    const key = 'liftarm/preferences';
    if (localStorage.getItem(key) === null) {
      const quiet = { autoSolve: false, projection: 'orthographic', guide: false, ...wanted };
      localStorage.setItem(key, JSON.stringify(quiet));
    }
  }, preferences);
  await openPage(page);
  await page.getByRole('button', { name: 'New sketch' }).click();
  await expect(page.getByText('Draw some lines first.')).toBeVisible();
  await page.keyboard.press('t');
  await settled(page);
}

/** Waits for the frames in which the page answers what was done last; its camera moves at once (reduced motion). */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(
    () =>
      new Promise<void>((resolve) => {
        let frames = 0;
        const next = () => {
          frames += 1;
          return frames > 5 ? resolve() : requestAnimationFrame(next);
        };
        requestAnimationFrame(next);
      }),
  );
}

/** What the tests read of a sketch file. */
export interface Saved {
  readonly name?: string;
  readonly lines: { from: number[]; to: number[] }[];
  readonly joints?: { at: number[]; axis: number[] }[];
  readonly symmetries?: { kind: string; normal?: number[]; lines?: number[] }[];
}

/**
 * The sketch file that the page saves now. What an edit before it makes of the sketch may come later: see expectLines
 * and expectSketch.
 */
export async function savedSketch(page: Page): Promise<Saved> {
  await begun(page);
  // A sheet that is closing still takes the key.
  for (let tries = 0; tries < 4; tries++) {
    const waiting = page.waitForEvent('download', { timeout: 15_000 }).catch(() => null);
    await page.keyboard.press('Control+s');
    const file = await waiting;
    if (file) {
      return JSON.parse(await textOf(file)) as Saved;
    }
  }
  throw new Error('the page saved no sketch');
}

/** Waits until the sketch has so many lines. */
export async function expectLines(page: Page, count: number): Promise<void> {
  await expect.poll(async () => (await savedSketch(page)).lines.length).toBe(count);
}

/** Waits until something is true of the sketch. */
export async function expectSketch(
  page: Page,
  read: (sketch: Saved) => unknown,
  wanted: unknown,
): Promise<void> {
  await expect.poll(async () => read(await savedSketch(page))).toEqual(wanted);
}

/** The text of the file that an action downloads. */
export async function downloaded(page: Page, action: () => Promise<void>): Promise<string> {
  const [file] = await Promise.all([page.waitForEvent('download'), action()]);
  return textOf(file);
}

export async function textOf(file: Download): Promise<string> {
  const stream = await file.createReadStream();
  const chunks: Buffer[] = [];
  for await (const chunk of stream) {
    chunks.push(chunk as Buffer);
  }
  return Buffer.concat(chunks).toString('utf8');
}

/** Opens a file with this text, or these bytes, by the page's dialog. */
export async function openText(
  page: Page,
  content: string | Buffer,
  name = 'a.sketch.json',
): Promise<void> {
  const file = { name, mimeType: 'application/json', buffer: Buffer.from(content as string) };
  // The browser opens its dialog only within five seconds of the key: a slow machine may need another.
  for (let tries = 0; tries < 4; tries++) {
    await settled(page);
    const waiting = page.waitForEvent('filechooser', { timeout: 15_000 }).catch(() => null);
    await page.keyboard.press('Control+o');
    const chooser = await waiting;
    if (chooser) {
      await chooser.setFiles(file);
      return;
    }
  }
  throw new Error('the page opened no file dialog');
}

export async function openPalette(page: Page): Promise<Locator> {
  await begun(page);
  const input = page.getByRole('combobox', { name: 'Search for a command' });
  // A sheet that is closing still takes the key.
  await expect(async () => {
    if (!(await input.isVisible())) {
      await page.keyboard.press('Control+k');
    }
    await expect(input).toBeVisible({ timeout: 5000 });
  }).toPass();
  return input;
}

/** Goes to a place by its name in the spine. */
export async function goTo(page: Page, name: string): Promise<void> {
  const link = page.getByRole('link', { name, exact: true });
  await link.click();
  await expect(link).toHaveAttribute('aria-current', 'page');
}

/** Opens an example from the list, as the menu does. */
export async function chooseExample(page: Page, name: RegExp): Promise<void> {
  await page.getByRole('button', { name: 'Menu', exact: true }).click();
  await page.getByRole('button', { name: 'Examples…' }).click();
  await page.getByRole('button', { name }).click();
}

/** Runs the command that the palette finds first for some words. */
export async function runCommand(page: Page, words: string): Promise<void> {
  const input = await openPalette(page);
  await input.fill(words);
  await page.keyboard.press('Enter');
}

/** Presses Generate and waits for the verdict. */
export async function generate(page: Page): Promise<void> {
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 90_000 });
  await expect(page.getByRole('button', { name: /^Generate/ })).toBeVisible({ timeout: 90_000 });
}

/** Where something is, once it has stayed there for some frames: what loads late moves what is around it. */
export function steadyBox(
  locator: Locator,
): Promise<{ x: number; y: number; width: number; height: number }> {
  return locator.evaluate(
    (element) =>
      new Promise((resolve) => {
        let [last, same] = ['', 0];
        const look = () => {
          const { x, y, width, height } = element.getBoundingClientRect();
          const now = [x, y, width, height].join(' ');
          same = now === last && width > 0 ? same + 1 : 0;
          last = now;
          return same > 2 ? resolve({ x, y, width, height }) : requestAnimationFrame(look);
        };
        look();
      }),
  );
}

/** A place in the drawing: pixels from its middle, y upwards. */
export async function canvasPoint(
  page: Page,
  x: number,
  y: number,
): Promise<{ x: number; y: number }> {
  const box = await steadyBox(page.locator('.scene canvas'));
  return { x: box.x + box.width / 2 + x, y: box.y + box.height / 2 - y };
}

/** Clicks places in the drawing, one after the other. */
export async function clickPlaces(
  page: Page,
  places: readonly (readonly [number, number])[],
): Promise<void> {
  for (const [x, y] of places) {
    const at = await canvasPoint(page, x, y);
    await page.mouse.move(at.x, at.y);
    await page.mouse.click(at.x, at.y);
  }
}

export { expect };
