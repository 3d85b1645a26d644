import { defineConfig } from '@playwright/test';
import { BROWSER } from './scripts/lib/browser.mjs';

const TIMES = process.env['LIFTARM_PAGE_TIMES'] !== undefined;

// Drives the built page in Debian's Chromium; no browser is downloaded.
export default defineConfig({
  testDir: 'e2e',
  outputDir: 'build/test-results/e2e',
  fullyParallel: true,
  forbidOnly: process.env['CI'] !== undefined,
  // What passes only the second time is told by name at the end of `npm test`: a fault of the test or of the page that
  // is still to be found, on a machine where nobody can run it again by hand.
  retries: process.env['CI'] !== undefined ? 1 : 0,
  workers: 2,
  // Most tests draw no pixel and wait more than they compute, so two go side by side. None asks a clock: what
  // does is a benchmark (scripts/page-times.mjs) and runs alone.
  ...(TIMES ? { testMatch: /page-times\.ts$/, workers: 1 } : {}),
  timeout: 120_000,
  expect: { timeout: 20_000 },
  reporter: 'list',
  use: {
    // Told by the server: a free port each time, so that nothing left behind is in the way.
    baseURL: `http://127.0.0.1:${process.env['LIFTARM_E2E_PORT']}/`,
    browserName: 'chromium',
    viewport: { width: 1280, height: 800 },
    // Keeping one costs a third of a run. What failed is run again with LIFTARM_TRACE=1.
    trace: process.env['LIFTARM_TRACE'] ? 'retain-on-failure' : 'off',
    launchOptions: BROWSER,
  },
  webServer: {
    // Without a shell in between, it ends with the run, however that ends.
    command: 'exec node scripts/serve.mjs --port 0 --with-parent',
    wait: { stdout: /served at http:\/\/127\.0\.0\.1:(?<liftarm_e2e_port>\d+)\// },
    timeout: 60_000,
  },
});
