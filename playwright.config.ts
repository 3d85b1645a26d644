import { defineConfig } from '@playwright/test';

const port = Number(process.env['LIFTARM_E2E_PORT'] ?? 4317);

const MEASURES = /(frames|budget)\.spec\.ts$/;

// Drives the built page in Debian's Chromium; no browser is downloaded.
export default defineConfig({
  testDir: 'e2e',
  outputDir: 'build/test-results/e2e',
  fullyParallel: true,
  forbidOnly: process.env['CI'] !== undefined,
  retries: 0,
  workers: 2,
  // Most tests draw no pixel and wait more than they compute, so two go side by side. What measures time
  // comes after them and alone.
  projects: [
    { name: 'together', testIgnore: MEASURES },
    { name: 'alone', testMatch: MEASURES, workers: 1, dependencies: ['together'] },
  ],
  timeout: 120_000,
  expect: { timeout: 20_000 },
  reporter: 'list',
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    browserName: 'chromium',
    viewport: { width: 1280, height: 800 },
    trace: 'retain-on-failure',
    launchOptions: {
      executablePath: process.env['LIFTARM_CHROMIUM'] ?? '/usr/bin/chromium',
      // It needs user namespaces and another user than root, which containers may lack; only our own
      // page is opened.
      chromiumSandbox: false,
    },
  },
  webServer: {
    command: `node scripts/serve.mjs --port ${port}`,
    url: `http://127.0.0.1:${port}/`,
    reuseExistingServer: false,
    timeout: 20_000,
  },
});
