// Curves over a common x, drawn by uPlot; shared by all pages.

import uPlot from 'uplot';
import { colour, onTheme } from './theme.js';

const PAPER_WIDTH = 335; // half of the printed width of A4 [CSS pixels], less the gap

const DASHES = [[], [9, 4], [2, 3], [12, 3, 2, 3], [5, 5], [14, 5], [1, 2]];
const COLOURS = ['ink', 'orange', 'green', 'purple', 'blue', 'yellow', 'grey'];

/** Colour (by its name in page.css) and dashes of the n-th curve: told apart by either alone. */
export const look = (n) => ({
  colour: COLOURS[n % COLOURS.length],
  dash: DASHES[(n + Math.floor(n / COLOURS.length)) % DASHES.length],
});

function axis(label, size) {
  return {
    label,
    labelSize: 22,
    size,
    stroke: () => colour('soft'),
    grid: { stroke: () => colour('line'), width: 1 },
    ticks: { stroke: () => colour('line'), width: 1, size: 5 },
    font: '12px system-ui, sans-serif',
    labelFont: '12px system-ui, sans-serif',
    values: (_, splits) => splits.map((v) => (v === null ? '' : String(Number(v.toPrecision(6))))),
  };
}

function seriesOf(curve) {
  if (curve.pointsOnly) {
    return {
      label: curve.label,
      paths: () => null,
      value: () => '○',
      points: { show: true, size: 7, width: 1.5, stroke: () => colour(curve.colour), fill: () => colour('paper') },
    };
  }
  return {
    label: curve.label,
    colour: curve.colour, // our own: a name of page.css
    stroke: () => colour(curve.colour),
    width: curve.width ?? 1.5,
    dash: curve.dash,
    spanGaps: true,
    points: curve.markers ? { show: true, size: 6, fill: () => colour(curve.colour) } : { show: false },
    value: (_, v) => (v === null || v === undefined ? '–' : String(Number(v.toPrecision(4)))),
  };
}

/** An x in the legend: with one decimal, or with so many digits. */
const textOf = (v, digits) =>
  v === null || v === undefined ? '–' : digits ? String(Number(v.toPrecision(digits))) : v.toFixed(1);

/** Of the sample in the legend. */
const lineStyle = (dash) => (!dash?.length ? 'solid' : dash[0] < 4 ? 'dotted' : 'dashed');

/** Curves as uPlot takes them, with low and high of an interval as two more for each that has them. */
function tables(curves) {
  const columns = [];
  const series = [];
  const bands = [];
  for (const curve of curves) {
    columns.push([Array.from(curve.x), Array.from(curve.y, (v) => (Number.isFinite(v) ? v : null))]);
    series.push(seriesOf(curve));
    if (!curve.low) continue;
    for (const edge of [curve.high, curve.low]) {
      columns.push([Array.from(curve.x), Array.from(edge)]);
      series.push({ label: `${curve.label}, interval`, edge: true, stroke: 'transparent', points: { show: false }, spanGaps: true });
    }
    bands.push({ series: [series.length - 1, series.length], fill: () => `${colour(curve.colour)}33` });
  }
  return { data: uPlot.join(columns), series, bands };
}

/** An interval goes and comes with its curve. */
function hideEdges(plot, index, { show }) {
  if (show === undefined || index === null || plot.series[index].edge) return;
  for (const next of [index + 1, index + 2]) {
    if (plot.series[next]?.edge) plot.setSeries(next, { show });
  }
}

/** A chart that fills the width of its figure. */
export class Chart {
  /** `curves`: {label, x, y, colour, dash, width, markers, pointsOnly, low, high}; y may hold NaN. `onPick(x)`: it was clicked. */
  constructor(figure, { title, xLabel, yLabel, curves, logarithmic = false, onPick, xDigits }) {
    const { data, series, bands } = tables(curves);
    this.figure = figure;
    this.colours = series.reduce((list, { colour: name }) => [...list, name], [undefined]);
    this.height = 230;
    const options = {
      width: this.#width(),
      height: this.height,
      series: [{ label: xLabel, value: (_, v) => textOf(v, xDigits) }, ...series],
      bands,
      axes: [axis(xLabel, 32), axis(yLabel, 52)],
      scales: {
        x: { time: false },
        y: logarithmic ? { distr: 3 } : { range: (_, low, high) => [Math.min(0, low ?? 0), (high || 1) * 1.05] },
      },
      legend: { markers: { width: 2, dash: (plot, i) => lineStyle(plot.series[i].dash) } },
      cursor: { drag: { x: false, y: false } },
      hooks: { setSeries: [hideEdges] },
    };
    const caption = document.createElement('figcaption');
    caption.textContent = title;
    const holder = document.createElement('div');
    holder.setAttribute('role', 'img');
    holder.setAttribute('aria-label', `${title}: ${curves.map((curve) => curve.label).join(', ')}`);
    figure.replaceChildren(caption, holder);
    this.plot = new uPlot(options, data, holder);
    this.plot.root.querySelectorAll('.u-legend .u-series').forEach((row, i) => {
      row.hidden = Boolean(this.plot.series[i].edge);
    });
    this.head = document.createElement('div');
    this.head.className = 'playhead';
    if (onPick) this.plot.over.append(this.head);
    this.plot.over.addEventListener('mouseleave', () => this.x !== undefined && this.point(this.x));
    if (onPick) {
      this.plot.over.addEventListener('click', (event) => {
        onPick(this.plot.posToVal(event.clientX - this.plot.over.getBoundingClientRect().left, 'x'));
      });
    }
  }
  #width() {
    return Math.max(240, Math.floor(this.figure.clientWidth));
  }
  /** Marks an x. */
  point(x) {
    this.x = x;
    this.head.style.transform = `translateX(${this.plot.valToPos(x, 'x')}px)`;
    this.plot.setLegend({ idx: this.plot.valToIdx(x) });
  }
  /** To `width`, or to that of the figure. */
  resize(width = this.#width()) {
    if (this.plot.width === width) return;
    this.plot.setSize({ width, height: this.height });
    if (this.x !== undefined) this.point(this.x);
  }
  /** In the colours of now; uPlot colours the samples of its legend but once. */
  redraw() {
    this.plot.redraw(false, true);
    this.plot.root.querySelectorAll('.u-legend .u-series').forEach((row, i) => {
      const marker = row.querySelector('.u-marker');
      if (marker && this.colours[i]) marker.style.borderColor = colour(this.colours[i]);
    });
  }
  destroy() {
    this.plot.destroy();
  }
}

/** Keeps the charts that `current()` returns in colour and in width. */
export function keepFresh(current) {
  onTheme(() => current().forEach((chart) => chart.redraw()));
  addEventListener('resize', () => current().forEach((chart) => chart.resize()));
  // Two beside each other on a sheet of paper, which is laid out without telling of a new width.
  addEventListener('beforeprint', () => current().forEach((chart) => chart.resize(PAPER_WIDTH)));
  addEventListener('afterprint', () => current().forEach((chart) => chart.resize()));
}
