// How long the page takes on this machine: printed, not judged. `npm run bench:page`.
import type { Browser, Page } from '@playwright/test';
import { FIRST_MODEL } from '../web/src/app/first-model.ts';
import { scaffold } from './helpers/sketches.ts';
import {
  canvasPoint,
  expect,
  openEmpty,
  openText,
  settled,
  test,
  withoutDrawing,
} from './helpers/test.ts';

test.use({ draws: false });

/** A mid-range machine at the end of a slow line: bits a second, milliseconds there and back. */
const THROTTLED = { bits: 10e6, latency: 40, processor: 2 } as const;
const VISITS = 4;
const MOVES = 60;

function print(what: string, values: readonly number[], unit: string): void {
  process.stdout.write(`${what}: ${values.map((value) => value.toFixed(2)).join(', ')} ${unit}\n`);
}

/** Milliseconds from a click on a link to the page until all parts of a model are drawn, on a first visit. */
async function firstModelAfter(browser: Browser, baseURL: string): Promise<number> {
  const context = await browser.newContext({ baseURL, reducedMotion: 'reduce' });
  const page = await context.newPage();
  await page.addInitScript(withoutDrawing);
  const client = await context.newCDPSession(page);
  await client.send('Network.enable');
  await client.send('Network.emulateNetworkConditions', {
    offline: false,
    latency: THROTTLED.latency,
    downloadThroughput: THROTTLED.bits / 8,
    uploadThroughput: THROTTLED.bits / 8,
  });
  await client.send('Emulation.setCPUThrottlingRate', { rate: THROTTLED.processor });
  await page.goto('./');
  const shown = () =>
    page.evaluate((mark) => performance.getEntriesByName(mark)[0]?.startTime ?? null, FIRST_MODEL);
  await expect.poll(shown, { timeout: 60_000 }).not.toBeNull();
  const milliseconds = (await shown()) ?? Infinity;
  await context.close();
  return milliseconds;
}

test('the first model, on a throttled machine', async ({ browser, baseURL }) => {
  const visits: number[] = [];
  while (visits.length < VISITS) {
    visits.push((await firstModelAfter(browser, baseURL ?? '')) / 1000);
  }
  print(`first model (${JSON.stringify(THROTTLED)}; two seconds are wanted)`, visits, 's');
});

test('the first model on the main thread', async ({ page }) => {
  // Processor time, not the clock.
  const client = await page.context().newCDPSession(page);
  await client.send('Performance.enable', { timeDomain: 'threadTicks' });
  await page.goto('./');
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 90_000 });
  const { metrics } = await client.send('Performance.getMetrics');
  const seconds = metrics.find(({ name }) => name === 'TaskDuration')?.value ?? Infinity;
  print('main thread until the first model (1.5 are wanted)', [seconds], 's');
});

interface TraceEvent {
  readonly name: string;
  /** `X` is a whole event, with its times. */
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  /** Microseconds of the processor; left out for 0. */
  readonly tdur?: number;
  readonly args?: { readonly name?: string };
}

/**
 * Milliseconds of the processor that each task of a page's main thread took: events, frames, timers,
 * messages of workers, garbage. Not of the clock: that also tells who else was busy.
 */
async function mainThreadTasks(
  browser: Browser,
  page: Page,
  work: () => Promise<void>,
): Promise<number[]> {
  await browser.startTracing(page, {
    categories: ['toplevel', 'devtools.timeline', 'disabled-by-default-devtools.timeline'],
  });
  await work();
  const raw = await browser.stopTracing();
  const trace = JSON.parse(raw.toString('utf8')) as { traceEvents: TraceEvent[] };
  const mains = new Set(
    trace.traceEvents
      .filter(({ name, args }) => name === 'thread_name' && args?.name === 'CrRendererMain')
      .map(({ pid, tid }) => `${pid} ${tid}`),
  );
  return trace.traceEvents
    .filter(
      ({ name, ph, pid, tid }) => name === 'RunTask' && ph === 'X' && mains.has(`${pid} ${tid}`),
    )
    .map(({ tdur }) => (tdur ?? 0) / 1000);
}

test('the longest task beside a running search of 300 lines', async ({ browser, page }) => {
  await openEmpty(page);
  await openText(page, scaffold(14));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Scaffold');
  await page.keyboard.press('l');
  const at = await canvasPoint(page, 0, 0);
  await page.mouse.click(at.x, at.y);
  await settled(page);
  const tasks = await mainThreadTasks(browser, page, async () => {
    await page.getByRole('button', { name: /^Generate/ }).click();
    await expect(page.getByRole('progressbar')).toBeVisible();
    for (let i = 0; i < MOVES; i++) {
      await page.mouse.move(at.x + 200 * Math.cos(i / 9), at.y + 150 * Math.sin(i / 7));
    }
  });
  print(
    'longest tasks of the main thread (50 are wanted)',
    tasks.sort((a, b) => b - a).slice(0, 5),
    'ms',
  );
});
