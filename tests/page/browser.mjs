// Chromium for tests of pages: opens files, and keeps all that went wrong in them.
import { createRequire } from 'node:module';
import { existsSync } from 'node:fs';
import path from 'node:path';

const parts = process.env.COGSLAM_PAGE_PARTS;
export const { chromium } = createRequire(path.join(parts, 'package.json'))('playwright-core');

const executablePath = process.env.COGSLAM_CHROMIUM;
if (!existsSync(executablePath)) throw new Error(`${executablePath}: no such program`);

/** --no-sandbox: tests may run as root in a container, where Chromium's sandbox cannot start. */
export const launch = () => chromium.launch({ executablePath, args: ['--no-sandbox'] });

/** Opens a file; `faults` gathers console errors, exceptions, and requests for anything but the file. */
export async function open(browser, file, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000); // tests share the processor with others
  const faults = [];
  page.on('console', (message) => {
    if (message.type() === 'error') faults.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => faults.push(`exception: ${error.message}`));
  page.on('request', (request) => {
    if (request.url() !== `file://${file}` && !request.url().startsWith('data:')) faults.push(`request: ${request.url()}`);
  });
  await page.goto(`file://${file}`);
  return { page, faults, close: () => context.close() };
}

/** The same, once the player stands. */
export async function openRun(browser, file, options) {
  const opened = await open(browser, file, options);
  await opened.page.waitForFunction(() => window.cogslam);
  await opened.page.evaluate(() => window.cogslam.ready);
  return opened;
}
