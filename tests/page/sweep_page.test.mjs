// The page of a sweep in a real browser. COGSLAM_PROGRAM makes the sweep; see tests/page/CMakeLists.txt.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, openRun } from './browser.mjs';

const scratch = mkdtempSync(path.join(tmpdir(), 'cogslam-sweep-page-'));
const folder = path.join(scratch, 'out');
let browser;

const world = (name) =>
  `  - scenario: ${path.join(process.env.COGSLAM_SOURCE, 'scenarios', `${name}.yaml`)}\n` +
  '    set: [{key: duration_s, value: 3}, {key: slam.particles, value: 5}]\n';

before(async () => {
  const file = path.join(scratch, 'sweep.yaml');
  writeFileSync(
    file,
    `name: tried\nseeds: {first: 1, count: 3}\nworlds:\n${world('simple')}${world('cornered')}cell_sizes_m: [0.5, 0.25]\n` +
      'true_poses: true\nvariants:\n  - {name: og, slam: {store: {kind: dense}}}\n' +
      '  - name: cog\n    slam: {store: {kind: coefficients}}\n    each: [{key: slam.store.percent_kept, values: [5, 40]}]\n',
  );
  execFileSync(process.env.COGSLAM_PROGRAM, ['sweep', file, '-o', folder, '--quiet', '-j2'], { stdio: 'pipe' });
  browser = await launch();
});

after(async () => {
  await browser?.close();
  rmSync(scratch, { recursive: true, force: true });
});

/** A session with the page, which ends without any fault. */
async function withPage(options, act) {
  const { page, faults, close } = await openRun(browser, path.join(folder, 'page.html'), options);
  await act(page);
  assert.deepEqual(faults, []);
  await close();
}

const state = (page) => page.evaluate(() => window.cogslam.state());

/** Rows of a CSV file without quotes, as objects. */
function csv(name) {
  const [head, ...rows] = readFileSync(path.join(folder, name), 'utf8').trim().split('\n').map((line) => line.split(','));
  return rows.map((row) => Object.fromEntries(row.map((value, i) => [head[i], value])));
}

test('opens from file:// without a fault and draws what was swept', () =>
  withPage({}, async (page) => {
    const { world: first, cell, axis, charts, curves } = await state(page);
    assert.deepEqual([first, cell, axis], ['simple', 0.25, 'percent_kept']);
    assert.equal(curves.length, 4); // dense and coefficients, by filter and from true poses
    assert.equal(await page.locator('#curves canvas').count(), charts);
    assert.ok(charts >= 5);
  }));

test('choices change the curves, and a name hides its curve with its interval', () =>
  withPage({}, async (page) => {
    await page.selectOption('#world', 'cornered');
    await page.selectOption('#cell', '0.5');
    await page.selectOption('#axis', 'bytes');
    await page.check('#logarithmic');
    const now = await state(page);
    assert.deepEqual([now.world, now.cell, now.axis], ['cornered', 0.5, 'bytes']);
    assert.ok(now.charts >= 4);
    await page.uncheck('#logarithmic');
    await page.selectOption('#axis', 'percent_kept');
    const rows = page.locator('#curves figure').first().locator('.u-legend .u-series');
    const shown = () => rows.evaluateAll((all) => all.map((row) => [row.hidden, row.classList.contains('u-off')]));
    const before_ = await shown();
    assert.deepEqual(before_.slice(1, 4), [[false, false], [true, false], [true, false]]);
    await rows.nth(1).locator('th').click();
    assert.deepEqual((await shown()).slice(1, 4), [[false, true], [true, true], [true, true]]);
  }));

test('tables hold the numbers of the CSV files', () =>
  withPage({}, async (page) => {
    const tables = (id) =>
      page.evaluate(
        (table) =>
          Array.from(document.querySelectorAll(`#${table} tbody tr`), (row) =>
            Array.from(row.cells, (cell) => ({ ...cell.dataset, text: cell.textContent })),
          ),
        id,
      );
    const summary = csv('summary.csv');
    const variants = await tables('variants');
    assert.equal(variants.length, new Set(summary.map((r) => `${r.world} ${r.cell_size_m} ${r.variant}`)).size);
    let compared = 0;
    for (const [variant, place, cell, n, , ...figures] of variants) {
      for (const { key, value } of figures.filter((figure) => figure.key)) {
        const [figure, difference] = key.split(' ');
        const row = summary.find(
          (r) => r.world === place.text && r.cell_size_m === cell.text && r.variant === variant.text && r.figure === figure,
        );
        assert.equal(value, difference ? row.difference : row.mean, key);
        assert.equal(n.text, '3');
        compared += 1;
      }
    }
    assert.ok(compared > 40, String(compared));
    const scores = csv('scores.csv');
    const episodes = await tables('episodes');
    assert.equal(episodes.length, scores.length);
    episodes.forEach((cells, i) => {
      for (const { key, value } of cells.filter((cell) => cell.key)) assert.equal(Number(value), Number(scores[i][key]), key);
    });
  }));

test('episodes link to files that are there, and their command replays them', () =>
  withPage({}, async (page) => {
    const row = page.locator('#episodes tbody tr').nth(4);
    for (const link of await row.locator('a').all()) {
      assert.ok(existsSync(path.join(folder, await link.getAttribute('href'))));
    }
    const [program, ...rest] = (await row.locator('code').textContent()).split(' ');
    assert.equal(program, 'cogslam');
    const out = execFileSync(process.env.COGSLAM_PROGRAM, [...rest, '--no-files', '--json'], { cwd: folder, stdio: 'pipe' });
    const { variants } = JSON.parse(out);
    const mse = Number(await row.locator('[data-key=grid_mse]').getAttribute('data-value'));
    assert.ok(variants.some((variant) => variant.scores.grid_mse === mse));
  }));

test('rows can be sorted and filtered', () =>
  withPage({}, async (page) => {
    const column = () => page.locator('#variants tbody tr:not([hidden]) td[data-key=grid_mse]').evaluateAll((cells) => cells.map((cell) => Number(cell.dataset.value)));
    await page.locator('#variants thead th', { hasText: 'map error' }).locator('button').click();
    const sorted = await column();
    assert.deepEqual(sorted, [...sorted].sort((a, b) => a - b));
    await page.locator('#by-variant input[type=search]').fill('cornered cog');
    const names = await page.locator('#variants tbody tr:not([hidden]) th').allTextContents();
    assert.equal(names.length, 8);
    assert.ok(names.every((name) => name.startsWith('cog')));
  }));

test('follows light and dark, and fits a narrow screen', async () => {
  for (const colorScheme of ['light', 'dark']) {
    await withPage({ colorScheme, viewport: { width: 420, height: 800 } }, async (page) => {
      assert.equal((await state(page)).theme, colorScheme);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 420);
    });
  }
});
