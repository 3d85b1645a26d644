// The browser of tests and pictures: Debian's Chromium without its windows, which starts and draws a page for half
// the work of the one that has them. Another one is named by LIFTARM_CHROMIUM.
import { existsSync } from 'node:fs';

const DEBIAN = ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'];

/** How Playwright starts it. */
export const BROWSER = {
  executablePath: process.env.LIFTARM_CHROMIUM ?? DEBIAN.find((file) => existsSync(file)),
  // It needs user namespaces and another user than root, which containers may lack; only our own
  // page is opened.
  chromiumSandbox: false,
};
