// The replay: a scene, its time slider, buttons and keys.

import { Scene } from './scene.js';
import { onTheme } from './theme.js';
import { lastNotAbove } from './run_data.js';

const SECONDS_OF_A_REPLAY = 40; // the speed chosen at first shows a run in about this
const SPEEDS = [0.5, 1, 2, 5, 10, 20, 50, 100, 200];

const LAYERS = [
  ['map', 'map of the best particle', '<rect x="3" y="2" width="9" height="12" class="free"/><rect x="12" y="2" width="9" height="12" class="occupied"/>'],
  ['walls', 'true walls', '<path d="M3 13V3h18v10" class="truth thin"/>'],
  ['lidar', 'LiDAR', '<path d="M3 6h4v4H3zM10 6h4v4h-4zM17 6h4v4h-4z" class="lidar"/>'],
  ['particles', 'particles', '<circle cx="7" cy="8" r="2" class="cloud"/><path d="M7 8h12" class="cloud"/>'],
  ['truth', 'true path, ring', '<path d="M1 8h22" class="truth"/>'],
  ['odometry', 'odometry, diamond', '<path d="M1 8h22" class="odometry"/>'],
  ['estimate', 'estimate, arrow', '<path d="M1 8h22" class="estimate"/>'],
];

function markup(run) {
  const options = run.labels.map((label, i) => `<option value="${i}"></option>`).join('');
  const layers = LAYERS.map(
    ([name, text, swatch]) =>
      `<label><input type="checkbox" data-layer="${name}" checked><svg viewBox="0 0 24 16" aria-hidden="true">${swatch}</svg>${text}</label>`,
  ).join('');
  return `<h2 id="player-title">Replay</h2>
<div class="player">
  <div class="stage">
    <div class="canvas"><canvas id="scene" role="img" aria-label="The room from above"></canvas></div>
    <div class="bar">
      <button type="button" id="play" aria-pressed="false">▶ play</button>
      <input type="range" id="time" min="0" max="${run.frames - 1}" step="1" value="0" aria-label="Moment of the run">
      <output id="clock" for="time"></output>
    </div>
    <p class="keys"><kbd>space</kbd> plays and stops, <kbd>←</kbd> <kbd>→</kbd> go one step (with <kbd>shift</kbd> ten),
      <kbd>Home</kbd> and <kbd>End</kbd> to the ends.</p>
  </div>
  <div class="panel">
    <label>Variant <select id="variant">${options}</select></label>
    <label>Speed <select id="speed"></select></label>
    <fieldset><legend>Shown</legend>${layers}
      <label><input type="checkbox" id="follow"><svg viewBox="0 0 24 16" aria-hidden="true"></svg>near the robot</label></fieldset>
    <dl id="readout"></dl>
  </div>
</div>
<p class="note" id="honest"></p>`;
}

const metres = (value) => (Math.abs(value) < 1 ? `${(100 * value).toFixed(1)} cm` : `${value.toFixed(2)} m`);

export class Player {
  /** `onFrame(frame)` and `onVariant(index)` are told of every change. */
  constructor(run, section, { onFrame, onVariant }) {
    Object.assign(this, { run, section, onFrame, onVariant, frame: 0, playing: false });
    section.setAttribute('aria-labelledby', 'player-title');
    section.innerHTML = markup(run);
    const find = (id) => section.querySelector(`#${id}`);
    Object.assign(this, { slider: find('time'), button: find('play'), clock: find('clock'), readout: find('readout') });
    this.chooser = find('variant');
    run.labels.forEach((label, i) => (this.chooser.options[i].textContent = label));
    this.scene = new Scene(find('scene'));
    this.#setUpSpeed(find('speed'));
    this.#listen(find);
    onTheme(() => this.scene.run && this.scene.repaint());
  }

  #setUpSpeed(chooser) {
    const { time } = this.run; // it may jump, as stamps of real logs do
    this.seconds = time.reduce((most, t) => Math.max(most, t), 0) - time.reduce((least, t) => Math.min(least, t), 0);
    if (!(this.seconds > 0)) this.seconds = this.run.frames / 20;
    const start = SPEEDS.findLast((speed) => this.seconds / speed >= SECONDS_OF_A_REPLAY * 0.7) ?? 1;
    for (const speed of SPEEDS) chooser.append(new Option(`${speed} ×`, speed, speed === start, speed === start));
    this.speed = start;
    chooser.addEventListener('change', () => (this.speed = Number(chooser.value)));
  }

  #listen(find) {
    this.slider.addEventListener('input', () => this.seek(Number(this.slider.value)));
    this.button.addEventListener('click', () => this.play(!this.playing));
    this.chooser.addEventListener('change', () => this.choose(Number(this.chooser.value)));
    find('follow').addEventListener('change', (event) => {
      this.scene.follow = event.target.checked;
      this.scene.draw(this.frame);
    });
    this.section.querySelectorAll('[data-layer]').forEach((box) =>
      box.addEventListener('change', () => {
        this.scene.layers[box.dataset.layer] = box.checked;
        this.scene.draw(this.frame);
      }),
    );
    addEventListener('keydown', (event) => this.#key(event));
    addEventListener('resize', () => {
      if (!this.variant) return;
      this.scene.resize();
      this.scene.draw(this.frame);
    });
  }

  #key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const on = event.target;
    if (on.closest?.('select, textarea, input[type=search]')) return;
    const stepped = event.shiftKey ? 10 : 1;
    const acts = {
      ' ': () => this.play(!this.playing),
      ArrowLeft: () => this.seek(this.frame - stepped),
      ArrowRight: () => this.seek(this.frame + stepped),
      Home: () => this.seek(0),
      End: () => this.seek(this.run.frames - 1),
    };
    const act = acts[event.key];
    // Space presses the button or opens the fold that has the focus.
    if (!act || (event.key === ' ' && on.closest?.('button, summary, input[type=checkbox], a'))) return;
    event.preventDefault();
    act();
  }

  async choose(index) {
    this.chooser.value = String(index);
    this.variant = await this.run.variant(index);
    this.scene.look(this.run, this.variant);
    for (const layer of ['particles', 'estimate']) this.#allow(layer, this.variant.clouds !== undefined);
    for (const layer of ['truth', 'walls']) this.#allow(layer, this.run.truth !== undefined);
    this.#tellWhatIsShown();
    this.#show();
    await this.onVariant(index);
  }

  #allow(layer, possible) {
    this.section.querySelector(`[data-layer=${layer}]`).disabled = !possible;
  }

  #tellWhatIsShown() {
    const { json } = this.run;
    const states = this.variant.map.records.length;
    const parts = [
      `Shown are ${json.frames} of ${json.scans} scans, at most ${json.beams} beams of each as if swept at once, and ${states} states of the map;` +
        ' a state stays until the next, and the last is the final map in the folder, in steps of 0.05 of probability.',
    ];
    if (this.variant.clouds) {
      const count = Math.min(json.cloud, this.variant.particles);
      const unweighted = 'without their weights, as they were after the last registered scan and moved on with the estimate since';
      parts.push(`Particles: ${count} of ${this.variant.particles}, ${unweighted}. Path and map are those of the best particle of the moment, so they may jump.`);
    } else {
      parts.push('This variant was given the true poses: it has no particles and no path of its own.');
    }
    if (json.variants.length < json.variants_of_run) {
      parts.push(`To bound the size of this page, only the first ${json.variants.length} of ${json.variants_of_run} variants can be replayed.`);
    }
    this.section.querySelector('#honest').textContent = parts.join(' ');
  }

  seek(frame) {
    this.frame = Math.min(this.run.frames - 1, Math.max(0, Math.round(frame)));
    this.#show();
  }

  play(on) {
    if (on === this.playing) return;
    this.playing = on;
    this.button.setAttribute('aria-pressed', String(on));
    this.button.textContent = on ? '❚❚ pause' : '▶ play';
    if (!on) return;
    if (this.frame === this.run.frames - 1) this.seek(0);
    this.exact = this.frame;
    this.before = undefined;
    requestAnimationFrame((now) => this.#tick(now));
  }

  #tick(now) {
    if (!this.playing) return;
    const passed = this.before === undefined ? 0 : (now - this.before) / 1000;
    this.before = now;
    if (Math.round(this.exact) !== this.frame) this.exact = this.frame; // moved by hand meanwhile
    this.exact += (passed * this.speed * (this.run.frames - 1)) / this.seconds;
    if (Math.round(this.exact) !== this.frame) this.seek(this.exact);
    if (this.frame >= this.run.frames - 1) this.play(false);
    else requestAnimationFrame((next) => this.#tick(next));
  }

  #show() {
    if (!this.variant) return;
    this.scene.draw(this.frame);
    this.slider.value = String(this.frame);
    const facts = this.#facts();
    this.clock.textContent = facts[0][1];
    this.slider.setAttribute('aria-valuetext', facts.map(([name, value]) => `${name} ${value}`).join(', '));
    this.scene.canvas.setAttribute('aria-label', `The room from above: ${facts.map((fact) => fact.join(' ')).join(', ')}`);
    this.readout.replaceChildren(...facts.flatMap((fact) => fact.map((text, i) => Object.assign(document.createElement(i ? 'dd' : 'dt'), { textContent: text }))));
    this.onFrame(this.frame);
  }

  /** Name and value of what is known of this moment; the time first. */
  #facts() {
    const { run, variant, frame } = this;
    const facts = [['time', `${run.time[frame].toFixed(1)} s`], ['scan record', `${run.record[frame]}`]];
    if (variant.errors) {
      facts.push(['off the true position', metres(variant.errors.position[frame])]);
      facts.push(['off the true heading', `${variant.errors.heading[frame].toFixed(2)}°`]);
    }
    const { registered } = variant;
    const r = lastNotAbove(registered.registered_record, run.record[frame]);
    if (r >= 0) {
      facts.push(['scans registered', `${lastNotAbove(registered.registered_record, run.record[frame]) + 1}`]);
      if (variant.clouds) facts.push(['effective particles', `${registered.effective[r].toFixed(1)} of ${variant.particles}`]);
      facts.push(['map bytes per particle', `${Math.round(registered.payload[r])}`]);
    }
    facts.push(['map state', `${variant.map.state + 1} of ${variant.map.records.length}`]);
    return facts;
  }
}
