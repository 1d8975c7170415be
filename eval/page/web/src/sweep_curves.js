// Means over seeds with their 95 % intervals, of one world at one cell size.

import { Chart, keepFresh, look } from './chart.js';

const AXES = [
  { key: 'percent_kept', label: 'coefficients kept [%]', of: (point) => point.percent_kept },
  { key: 'bytes', label: 'all bytes per particle', of: (point) => point.values.bytes?.[0] ?? null },
  { key: 'particles', label: 'particles', of: (point) => point.particles },
  { key: 'cell_size_m', label: 'cell size [m]', of: (point) => point.cell_size_m },
];

const unique = (values) => [...new Set(values)];

/** Points of a family that differ in what the axis shows; alike but for it. */
function families(points, axis) {
  const groups = new Map();
  for (const point of points) {
    const name = axis.key === 'particles' ? point.family.replace(/ x\d+/, '') : point.family;
    const kept = point.percent_kept !== null && axis.key !== 'percent_kept' && axis.key !== 'bytes' ? ` ${point.percent_kept} %` : '';
    if (!groups.has(name + kept)) groups.set(name + kept, []);
    groups.get(name + kept).push(point);
  }
  return groups;
}

/** One curve; a family without a place on the axis is a level line across it, as the baseline over the percentage kept. */
function curveOf(label, points, figure, axis, span, n) {
  const measured = points.filter((point) => point.values[figure.key]);
  if (measured.length === 0) return null;
  let samples = measured.filter((point) => axis.of(point) !== null).map((point) => [axis.of(point), ...point.values[figure.key]]);
  if (samples.length === 0) samples = span.map((x) => [x, ...measured[0].values[figure.key]]);
  samples.sort((a, b) => a[0] - b[0]);
  return {
    ...look(n),
    label,
    markers: axis.of(measured[0]) !== null,
    x: samples.map(([x]) => x),
    y: samples.map(([, mean]) => mean),
    low: samples.map(([, mean, half]) => mean - half),
    high: samples.map(([, mean, half]) => mean + half),
  };
}

function select(name, id, options, onChange) {
  const label = document.createElement('label');
  const field = document.createElement('select');
  field.id = id;
  options.forEach(({ value, text }) => field.add(new Option(text, value)));
  field.addEventListener('change', () => onChange(field.value));
  label.append(`${name} `, field);
  return label;
}

/** Draws into the section "curves". */
export class SweepCurves {
  constructor(data, section) {
    Object.assign(this, { data, charts: [], logarithmic: false });
    this.worlds = unique(data.points.map((point) => point.world));
    this.world = this.worlds[0];
    this.axis = AXES.find((axis) => unique(data.points.map(axis.of).filter((x) => x !== null)).length > 1) ?? AXES[1];
    this.cell = Math.min(...this.#cells());
    this.grid = document.createElement('div');
    this.grid.className = 'curves';
    const note = document.createElement('p');
    note.className = 'note';
    note.textContent =
      'Means over the seeds; the band is the 95 % interval of the mean. Where nothing is kept in percent, the level line is the value. Click a name to hide its curve.';
    section.append(this.#controls(), note, this.grid);
    keepFresh(() => this.charts);
    this.#draw();
  }
  #cells() {
    return unique(this.data.points.filter((point) => point.world === this.world).map((point) => point.cell_size_m));
  }
  #controls() {
    const line = document.createElement('p');
    line.className = 'choices';
    const change = (set) => (value) => {
      set(value);
      this.#draw();
    };
    const plain = (values) => values.map((value) => ({ value: String(value), text: String(value) }));
    const cells = unique(this.data.points.map((point) => point.cell_size_m));
    line.append(
      select('world', 'world', plain(this.worlds), change((value) => (this.world = value))),
      select('cell size [m]', 'cell', plain(cells), change((value) => (this.cell = Number(value)))),
      select('over', 'axis', AXES.map(({ key, label }) => ({ value: key, text: label })), change((value) => (this.axis = AXES.find(({ key }) => key === value)))),
    );
    line.querySelector('#cell').value = String(this.cell);
    line.querySelector('#axis').value = this.axis.key;
    const label = document.createElement('label');
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.id = 'logarithmic';
    box.addEventListener('change', () => change((value) => (this.logarithmic = value))(box.checked));
    label.append(box, ' logarithmic');
    line.append(label);
    return line;
  }
  #shown() {
    return this.data.points.filter(
      (point) => point.world === this.world && (this.axis.key === 'cell_size_m' || point.cell_size_m === this.cell),
    );
  }
  #draw() {
    const points = this.#shown();
    const places = points.map(this.axis.of).filter((x) => x !== null);
    const span = [Math.min(...places), Math.max(...places)];
    const groups = [...families(points, this.axis)];
    const plans = (places.length > 0 ? this.data.figures : [])
      .filter((figure) => figure.key !== this.axis.key)
      .map((figure) => ({
        figure,
        curves: groups.map(([label, members], n) => curveOf(label, members, figure, this.axis, span, n)).filter(Boolean),
      }))
      .filter(({ curves }) => curves.some((curve) => curve.y.some((y) => y !== 0)));
    this.charts.forEach((chart) => chart.destroy());
    const holders = plans.map(() => document.createElement('figure'));
    this.grid.replaceChildren(...holders); // all at once: a chart takes the width that its place has now
    this.charts = plans.map((plan, i) => this.#chart(holders[i], plan));
    if (this.charts.length === 0) this.grid.textContent = 'Nothing was measured here.';
    this.curves = groups.map(([label]) => label);
  }
  #chart(holder, { figure, curves }) {
    const { axis, logarithmic } = this;
    const { name: title, unit: yLabel } = figure;
    return new Chart(holder, { title, xLabel: axis.label, yLabel, curves, logarithmic, xDigits: 4 });
  }
  state() {
    const { world, cell, curves } = this;
    return { world, cell, axis: this.axis.key, charts: this.charts.length, curves };
  }
}
