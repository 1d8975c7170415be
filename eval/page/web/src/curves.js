// The curves of a run: the chosen variant, and those of its cell size beside it.

import { Chart, keepFresh, look } from './chart.js';
import { errorsOf } from './run_data.js';

const cellOf = (label) => label.split(' ').slice(-2).join(' ');

/** The chosen variant first, so that it has the plain look. */
async function compared(run, chosen) {
  const others = run.labels.map((_, i) => i).filter((i) => i !== chosen && cellOf(run.labels[i]) === cellOf(run.labels[chosen]));
  return Promise.all([chosen, ...others.slice(0, 5)].map((i) => run.variant(i)));
}

function styled(variants) {
  return variants.map((variant, n) => ({ variant, style: { ...look(n), width: n === 0 ? 2.2 : 1.4, label: variant.label } }));
}

function errorCurves(run, list, kind, x) {
  const odometry = errorsOf(run.odometry, run.truth)[kind];
  const curves = list
    .filter(({ variant }) => variant.errors)
    .map(({ variant, style }) => ({ ...style, x, y: variant.errors[kind] }));
  return [...curves, { label: 'odometry alone', x, y: odometry, colour: 'vermilion', dash: [4, 4], width: 1.4 }];
}

function registeredCurves(run, list, column) {
  return list.map(({ variant, style }) => {
    const columns = variant.registered;
    return { ...style, x: Array.from(columns.registered_record, (r) => run.xAt(r)), y: columns[column] };
  });
}

function effectiveCurves(run, list) {
  const curves = registeredCurves(run, list.filter(({ variant }) => variant.clouds), 'effective');
  if (curves.length === 0 || !list[0].variant.clouds) return curves;
  const { resampled } = list[0].variant.registered;
  const y = Array.from(curves[0].y, (v, i) => (resampled[i] ? v : NaN));
  if (y.some(Number.isFinite)) curves.push({ label: 'resampled here', x: curves[0].x, y, colour: 'ink', pointsOnly: true });
  return curves;
}

/** Draws into the section "curves"; `onPick(frame)` when the reader clicks on a moment. */
export class RunCurves {
  constructor(run, section, onPick) {
    Object.assign(this, { run, onPick, charts: [], logarithmic: false });
    this.grid = document.createElement('div');
    this.grid.className = 'curves';
    section.append(this.#controls(), this.grid);
    keepFresh(() => this.charts);
  }
  #controls() {
    const line = document.createElement('p');
    line.className = 'note';
    line.textContent =
      'The chosen variant is the strong line; those of the same cell size stand beside it. Click a curve to go to that moment. ';
    if (this.run.truth) {
      const label = document.createElement('label');
      const box = document.createElement('input');
      box.type = 'checkbox';
      box.id = 'logarithmic';
      box.addEventListener('change', () => {
        this.logarithmic = box.checked;
        this.show(this.chosen);
      });
      label.append(box, ' logarithmic errors');
      line.append(label);
    } else {
      line.append('Errors over time need the true path, which is not known here.');
    }
    return line;
  }
  async show(chosen) {
    this.chosen = chosen;
    const list = styled(await compared(this.run, chosen));
    const { run } = this;
    const x = run.timeRises ? run.time : run.record;
    const plans = [];
    if (run.truth) {
      plans.push({ title: 'Position error: how far from the true position', yLabel: 'm', curves: errorCurves(run, list, 'position', x), error: true });
      plans.push({ title: 'Heading error: how far turned from the true heading', yLabel: 'deg', curves: errorCurves(run, list, 'heading', x), error: true });
    }
    plans.push({ title: 'Effective particles: how many share the weight', yLabel: 'N_eff', curves: effectiveCurves(run, list) });
    plans.push({ title: "Bytes of a particle's map", yLabel: 'bytes', curves: registeredCurves(run, list, 'payload') });
    this.charts.forEach((chart) => chart.destroy());
    this.grid.replaceChildren();
    this.charts = plans.filter((plan) => plan.curves.length > 0).map((plan) => this.#chart(plan));
    if (this.frame !== undefined) this.point(this.frame);
  }
  #chart({ title, yLabel, curves, error }) {
    const figure = document.createElement('figure');
    this.grid.append(figure);
    const xLabel = this.run.timeRises ? 'time [s]' : 'record';
    const onPick = (x) => this.onPick(this.#frameAt(x));
    return new Chart(figure, { title, xLabel, yLabel, curves, logarithmic: error && this.logarithmic, onPick });
  }
  #frameAt(x) {
    const values = this.run.timeRises ? this.run.time : this.run.record;
    let nearest = 0;
    values.forEach((value, f) => {
      if (Math.abs(value - x) < Math.abs(values[nearest] - x)) nearest = f;
    });
    return nearest;
  }
  point(frame) {
    this.frame = frame;
    const x = (this.run.timeRises ? this.run.time : this.run.record)[frame];
    this.charts.forEach((chart) => chart.point(x));
  }
}
