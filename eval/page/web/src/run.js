// The page of one run. docs/run_page.md tells what it shows, and what tests may ask of window.cogslam.

import { RunCurves } from './curves.js';
import { Player } from './player.js';
import { loadRun } from './run_data.js';
import { setUpTables } from './table.js';
import { setUpTheme, themeNow } from './theme.js';

/** Scores and pictures of the chosen variant. */
function showScores(index) {
  const row = document.querySelector(`#all-scores tr[data-variant="${index}"]`);
  document.querySelectorAll('#explained td[data-key]').forEach((cell) => {
    cell.replaceWith(row.querySelector(`[data-key="${cell.dataset.key}"]`).cloneNode(true));
  });
  const record = JSON.parse(document.getElementById('record').textContent);
  const { name, cell_size_m: cell } = record.variants[index];
  document.querySelectorAll('.chosen-name').forEach((place) => (place.textContent = `${name} ${cell} m`));
  document.querySelectorAll('tr[data-variant]').forEach((other) => {
    other.classList.toggle('chosen', other.dataset.variant === String(index));
  });
  document.querySelectorAll('#pictures figure').forEach((figure) => {
    figure.hidden = figure.dataset.variant !== String(index);
  });
}

/** A click on a variant's name in a table chooses it. */
function makeRowsChoose(player, count) {
  document.querySelectorAll('#headlines tbody th').forEach((head) => {
    const index = Number(head.parentElement.dataset.variant);
    if (index >= count) return;
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'choose';
    button.title = 'Show this variant';
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener('click', () => player.choose(index));
  });
}

function hookOf(run, player, ready) {
  return {
    ready,
    seek: (frame) => player.seek(frame),
    choose: (index) => player.choose(index),
    /** What is shown now; poses in [m, m, rad], robot_px in pixels of the canvas. */
    state: () => {
      const { frame, variant, scene } = player;
      const poseAt = (path) => path && path.at(frame);
      const robot = variant.estimate ?? run.truth;
      const { x, y } = (robot ?? run.odometry).at(frame);
      return {
        frame,
        frames: run.frames,
        time_s: run.time[frame],
        record: run.record[frame],
        playing: player.playing,
        theme: themeNow(),
        variant: variant.label,
        estimate: poseAt(variant.estimate),
        truth: poseAt(run.truth),
        odometry: poseAt(run.odometry),
        robot_px: scene.at(x, y),
        particles: variant.clouds ? variant.clouds.at(frame).length : 0,
        map_state: variant.map.state,
        curves_x: player.curves.charts.map((chart) => chart.x),
      };
    },
    /** The map as it is shown now: rows from the bottom, steps of 0.05 of probability (10 unknown). */
    map: () => {
      const { width, height, cell, origin, levels } = player.variant.map;
      return { width, height, cell_size_m: cell, origin_m: origin, levels: Array.from(levels) };
    },
  };
}

async function start() {
  setUpTheme(document.querySelector('header'));
  setUpTables();
  const section = document.getElementById('player');
  const run = await loadRun();
  if (!run) {
    section.innerHTML = '<p class="note">The run was too long, or kept no trace, for a replay.</p>';
    document.getElementById('curves').remove();
    return;
  }
  const curves = new RunCurves(run, document.getElementById('curves'), (frame) => player.seek(frame));
  const player = new Player(run, section, {
    onFrame: (frame) => curves.point(frame),
    onVariant: (index) => {
      showScores(index);
      return curves.show(index);
    },
  });
  player.curves = curves;
  makeRowsChoose(player, run.json.variants.length);
  const ready = player.choose(Math.min(Number(section.dataset.variant), run.json.variants.length - 1));
  window.cogslam = hookOf(run, player, ready);
  await ready;
  player.seek(run.frames - 1);
  performance.mark('cogslam-ready');
}

start();
