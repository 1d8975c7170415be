// The page of a run in a real browser. COGSLAM_PROGRAM makes the runs; see tests/page/CMakeLists.txt.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open, openRun } from './browser.mjs';

const scratch = mkdtempSync(path.join(tmpdir(), 'cogslam-page-'));
let browser;
let folder;
let staticFolder;

function made(name, ...more) {
  const out = path.join(scratch, name);
  const scenario = path.join(process.env.COGSLAM_SOURCE, 'scenarios', 'cluttered.yaml');
  const few = ['--set', 'duration_s=6', '--set', 'slam.cell_sizes_m=[0.2, 0.1]', '--particles', '20'];
  execFileSync(process.env.COGSLAM_PROGRAM, ['run', scenario, '--quiet', '--out', out, ...few, ...more], { stdio: 'pipe' });
  return path.join(out, readdirSync(out)[0]);
}

const read = (name, encoding) => readFileSync(path.join(folder, name), encoding);
const state = (page) => page.evaluate(() => window.cogslam.state());

before(async () => {
  folder = made('player');
  staticFolder = made('static', '--page', 'static');
  browser = await launch();
});

after(async () => {
  await browser?.close();
  rmSync(scratch, { recursive: true, force: true });
});

/** A session with the player, which ends without any fault. */
async function withRun(options, act) {
  const { page, faults, close } = await openRun(browser, path.join(folder, 'page.html'), options);
  await act(page);
  assert.deepEqual(faults, []);
  await close();
}

/** Rows of a TUM file, one per record. */
const tum = (name) => read(name, 'utf8').trim().split('\n').map((line) => line.split(' ').map(Number));

test('opens from file:// without a fault, and shows the end', () =>
  withRun({}, async (page) => {
    const { frame, frames, playing, variant } = await state(page);
    assert.equal(frame, frames - 1);
    assert.equal(playing, false);
    assert.equal(variant, 'og 0.1 m');
    assert.equal(await page.locator('canvas#scene').count(), 1);
    assert.equal(await page.locator('#curves canvas').count(), 4);
  }));

test('shows the numbers of scores.json', () =>
  withRun({}, async (page) => {
    const record = JSON.parse(read('scores.json', 'utf8'));
    const cells = await page.evaluate(() =>
      Array.from(document.querySelectorAll('td[data-key]'), ({ dataset, textContent }) => ({ ...dataset, text: textContent })),
    );
    const seen = new Set();
    for (const { key, variant, value, derived, text } of cells) {
      const exact = record.variants[variant].scores[key];
      if (value !== undefined) assert.deepEqual(JSON.parse(value), exact, key);
      if (value !== undefined) seen.add(`${variant} ${key}`);
      if (exact === null) assert.match(text, /^–/, key);
      if (typeof exact !== 'number') continue;
      const root = derived === 'root' ? Math.sqrt(exact) : derived === 'root_deg' ? (Math.sqrt(exact) * 180) / Math.PI : exact;
      const decimals = text.match(/^-?\d+\.?(\d*)/)[1].length;
      const rounding = Math.max(5.001e-4 * Math.abs(root), 0.5001 * 10 ** -decimals);
      assert.ok(Math.abs(Number.parseFloat(text) - root) <= rounding, `${key}: ${text} for ${root}`);
    }
    const expected = record.variants.flatMap((variant, v) => Object.keys(variant.scores).map((key) => `${v} ${key}`));
    assert.deepEqual([...seen].sort(), expected.sort());
  }));

test('the slider moves the robot along the paths in the folder', () =>
  withRun({}, async (page) => {
    const [online, truth, odometry] = ['og_0.1m_online.tum', 'truth.tum', 'odometry.tum'].map(tum);
    const slider = page.locator('#time');
    const places = [];
    for (const share of [0, 0.3, 0.7]) {
      const frame = Math.floor(share * Number(await slider.getAttribute('max')));
      await slider.fill(String(frame));
      const now = await state(page);
      assert.equal(now.frame, frame);
      for (const [pose, path] of [[now.estimate, online], [now.truth, truth], [now.odometry, odometry]]) {
        assert.ok(Math.hypot(pose.x - path[now.record][1], pose.y - path[now.record][2]) < 2e-4, `frame ${frame}`);
      }
      assert.ok(Math.abs(now.time_s - (truth[now.record][0] - truth[0][0])) < 2e-3);
      assert.ok(now.curves_x.every((x) => Math.abs(x - now.time_s) < 1e-9), 'the curves point to the same moment');
      places.push(now);
    }
    // The canvas keeps shape and directions: x to the right, y up, one scale.
    const [a, b, c] = places;
    const scales = [[a, b, 'x', 0, 1], [a, b, 'y', 1, -1], [a, c, 'x', 0, 1], [a, c, 'y', 1, -1]]
      .filter(([from, to, axis]) => Math.abs(to.estimate[axis] - from.estimate[axis]) > 0.1)
      .map(([from, to, axis, i, sign]) => (sign * (to.robot_px[i] - from.robot_px[i])) / (to.estimate[axis] - from.estimate[axis]));
    assert.ok(scales.length >= 3 && scales[0] > 20, `${scales} pixels per metre`);
    assert.ok(scales.every((scale) => Math.abs(scale - scales[0]) < 1e-6), `${scales} pixels per metre`);
  }));

test('draws the robot where it says', () =>
  withRun({}, async (page) => {
    const ink = (x, y) =>
      page.evaluate(([px, py]) => {
        const canvas = document.getElementById('scene');
        const ratio = canvas.width / canvas.clientWidth;
        return Array.from(canvas.getContext('2d').getImageData(Math.round(px * ratio), Math.round(py * ratio), 1, 1).data);
      }, [x, y]);
    await page.locator('[data-layer=particles]').uncheck(); // they lie on top of it
    await page.evaluate(() => window.cogslam.seek(0));
    const { robot_px: start } = await state(page);
    await page.evaluate(() => window.cogslam.seek(Infinity));
    const { robot_px: end } = await state(page);
    assert.ok(Math.hypot(start[0] - end[0], start[1] - end[1]) > 40);
    const [r, g, b] = await ink(...end);
    assert.ok(r + g + b < 150, `the arrow is dark: ${[r, g, b]}`);
  }));

test('the last map is that in the folder, and it grew', () =>
  withRun({}, async (page) => {
    for (const [index, name] of [[0, 'og_0.2m'], [4, 'og_0.1m'], [7, 'cog40_true_poses_0.1m']]) {
      await page.evaluate((i) => window.cogslam.choose(i), index);
      await page.evaluate(() => window.cogslam.seek(Infinity));
      const map = await page.evaluate(() => window.cogslam.map());
      const bytes = read(`${name}.pgm`);
      const header = bytes.subarray(0, 40).toString('latin1').match(/^P5\n(\d+) (\d+)\n255\n/);
      assert.deepEqual([map.width, map.height], [Number(header[1]), Number(header[2])], name);
      const pixel = (x, y) => bytes[header[0].length + (map.height - 1 - y) * map.width + x];
      let different = 0;
      map.levels.forEach((level, i) => {
        const shown = level <= 6 ? 254 : level >= 14 ? 0 : 205;
        if (shown !== pixel(i % map.width, Math.floor(i / map.width))) ++different;
      });
      assert.equal(different, 0, `${name}: cells that differ`);
      await page.evaluate(() => window.cogslam.seek(0));
      const first = await page.evaluate(() => window.cogslam.map());
      const fresh = await openRun(browser, path.join(folder, 'page.html'));
      await fresh.page.evaluate((i) => window.cogslam.choose(i).then(() => window.cogslam.seek(0)), index);
      assert.deepEqual(first, await fresh.page.evaluate(() => window.cogslam.map()), `${name}: no trace of what came later`);
      await fresh.close();
      const known = ({ levels }) => levels.filter((level) => level <= 6 || level >= 14).length;
      assert.ok(known(first) < known(map), `${name}: fewer cells were known at first`);
      await page.evaluate(() => window.cogslam.seek(Infinity));
      assert.deepEqual(await page.evaluate(() => window.cogslam.map()), map, 'the same after going back and forth');
    }
  }));

test('keys play, step and jump', () =>
  withRun({}, async (page) => {
    const pressed = async (key) => {
      await page.keyboard.press(key);
      return (await state(page)).frame;
    };
    assert.equal(await pressed('Home'), 0);
    assert.equal(await pressed('ArrowRight'), 1);
    assert.equal(await pressed('Shift+ArrowRight'), 11);
    assert.equal(await pressed('ArrowLeft'), 10);
    const { frames } = await state(page);
    assert.equal(await pressed('End'), frames - 1);
    assert.equal(await pressed('ArrowRight'), frames - 1, 'no further');
    await pressed('Home');
    await pressed(' ');
    await page.waitForFunction(() => window.cogslam.state().frame > 3);
    assert.equal((await state(page)).playing, true);
    assert.equal(await page.locator('#play').getAttribute('aria-pressed'), 'true');
    const stopped = await pressed(' ');
    await page.waitForTimeout(150);
    assert.equal((await state(page)).frame, stopped);
    await page.locator('#time').focus();
    assert.equal(await pressed('Home'), 0, 'with the slider in focus too');
    assert.equal(await pressed('ArrowRight'), 1);
    await page.locator('#play').focus();
    await pressed(' ');
    assert.equal((await state(page)).playing, true, 'space on the button counts once');
  }));

test('a click on a curve goes to that moment', () =>
  withRun({}, async (page) => {
    await page.locator('.u-over').first().click({ position: { x: 5, y: 50 } });
    assert.ok((await state(page)).time_s < 0.5);
  }));

test('a variant is chosen in the list and in the table', () =>
  withRun({}, async (page) => {
    await page.locator('#variant').selectOption('3');
    await page.waitForFunction(() => window.cogslam.state().variant === 'cog40_true_poses 0.2 m');
    assert.equal((await state(page)).particles, 0);
    assert.equal(await page.locator('#explained .chosen-name').textContent(), 'cog40_true_poses 0.2 m');
    await page.locator('#headlines tr[data-variant="5"] button').click();
    await page.waitForFunction(() => window.cogslam.state().variant === 'cog40 0.1 m');
    assert.equal((await state(page)).particles, 20);
    assert.equal(await page.locator('#pictures figure:visible').count(), 1);
    assert.ok((await page.locator('#explained td[data-key="grid_mse"]').getAttribute('data-variant')) === '5');
  }));

test('tables sort and filter', () =>
  withRun({}, async (page) => {
    const column = () => page.locator('#headlines tbody tr:visible td:nth-child(8)').allTextContents();
    const head = page.locator('#headlines thead th:nth-child(8) button');
    await head.click();
    const rising = (await column()).map(Number);
    assert.deepEqual(rising, [...rising].sort((a, b) => a - b));
    await head.click();
    assert.deepEqual((await column()).map(Number), rising.reverse());
    await page.locator('#headlines thead th:nth-child(5) button').click();
    await page.locator('#headlines thead th:nth-child(5) button').click();
    const errors = await page.locator('#headlines tbody td:nth-child(5)').allTextContents();
    assert.deepEqual(errors.slice(4), ['–', '–', '–', '–'], 'what was not measured comes last');
    await page.locator('.filter input').first().fill('cog40 0.1');
    assert.equal((await column()).length, 2);
  }));

const background = (page) => page.evaluate(() => getComputedStyle(document.querySelector('section')).backgroundColor);
const lightness = (rgb) => rgb.match(/\d+/g).slice(0, 3).reduce((sum, v) => sum + Number(v), 0);

test('is dark where the system is, and where the reader says so', () =>
  withRun({ colorScheme: 'dark' }, async (page) => {
    assert.equal((await state(page)).theme, 'dark');
    assert.ok(lightness(await background(page)) < 150);
    const corner = () => page.evaluate(() => Array.from(document.getElementById('scene').getContext('2d').getImageData(2, 2, 1, 1).data).join());
    const sample = () => page.evaluate(() => getComputedStyle(document.querySelectorAll('.u-legend .u-marker')[1]).borderTopColor);
    const dark = await corner();
    assert.ok(lightness(await sample()) > 600, 'the legend shows a light line');
    await page.locator('#theme').click();
    assert.equal((await state(page)).theme, 'light');
    assert.ok(lightness(await background(page)) > 700);
    assert.notEqual(await corner(), dark, 'the scene too');
    assert.ok(lightness(await sample()) < 150, 'and the legend');
    await page.locator('#theme').click();
    assert.equal(await corner(), dark);
  }));

test('prints on white paper, without its controls', () =>
  withRun({ colorScheme: 'dark' }, async (page) => {
    const pdf = await page.pdf({ format: 'A4' });
    assert.equal(pdf.subarray(0, 5).toString(), '%PDF-');
    assert.ok(pdf.length > 20000);
    await page.emulateMedia({ media: 'print', colorScheme: 'light' });
    for (const control of ['#theme', '#play', '#time', '.filter >> nth=0']) {
      assert.equal(await page.locator(control).isVisible(), false, control);
    }
    assert.ok(await page.locator('#explained').isVisible());
    assert.equal((await state(page)).theme, 'light');
  }));

test('fits a narrow screen', () =>
  withRun({ viewport: { width: 360, height: 740 }, hasTouch: true }, async (page) => {
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360, 'nothing sticks out');
  }));

test('every control has a name, and every picture says what it shows', () =>
  withRun({}, async (page) => {
    const nameless = await page.evaluate(() =>
      Array.from(document.querySelectorAll('button, input, select, img, canvas[role], [role=img]'))
        .filter((e) => !(e.getAttribute('aria-label') || e.getAttribute('alt') || e.textContent.trim() || e.labels?.length))
        .map((e) => e.outerHTML.slice(0, 80)),
    );
    assert.deepEqual(nameless, []);
    assert.match(await page.locator('#time').getAttribute('aria-valuetext'), /^time \d/);
  }));

test('is bounded: a page of a short run is small', () => {
  assert.ok(read('page.html').length < 1_500_000, `${read('page.html').length} bytes`);
});

test('the static page has scores, pictures and curves, and needs no script', async () => {
  const { page, faults, close } = await open(browser, path.join(staticFolder, 'page.html'), { javaScriptEnabled: false });
  assert.equal(await page.locator('script').count(), 0);
  assert.equal(await page.locator('#curves img').count(), 1);
  assert.equal(await page.locator('#pictures img').count(), 12);
  assert.ok(await page.locator('#headlines').isVisible());
  const broken = await page.locator('img').evaluateAll((images) => images.filter((i) => !(i.naturalWidth > 0)).length).catch(() => 0);
  assert.equal(broken, 0);
  assert.deepEqual(faults, []);
  await close();
});
