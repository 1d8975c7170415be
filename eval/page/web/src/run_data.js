// What the player shows, out of the page's data (eval/page/player_data.cpp).

import { unpack } from './packed.js';

const UNKNOWN = 10;

const element = (id) => document.getElementById(id);

/** Index of the last of the rising `values` that is not above `value`; -1 where there is none. */
export function lastNotAbove(values, value) {
  let low = 0;
  let high = values.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

const startsOf = (counts) => {
  const starts = new Uint32Array(counts.length + 1);
  for (let i = 0; i < counts.length; ++i) starts[i + 1] = starts[i] + counts[i];
  return starts;
};

/** A path with one pose per frame; undefined where the columns have none. */
function pathOf(columns, name) {
  const [x, y, theta] = ['x', 'y', 'theta'].map((part) => columns[`${name}_${part}`]);
  return x && { x, y, theta, at: (frame) => ({ x: x[frame], y: y[frame], theta: theta[frame] }) };
}

/** A map that is played forwards and backwards. Levels are steps of 0.05 of probability; 10 is unknown. */
class GrowingMap {
  constructor(shape, columns) {
    Object.assign(this, { width: shape.width, height: shape.height, cell: shape.cell_size_m, origin: shape.origin_m });
    this.records = columns.map_record;
    this.columns = columns;
    this.levels = new Uint8Array(this.width * this.height).fill(UNKNOWN);
    this.runStarts = startsOf(columns.map_runs);
    const perState = new Float64Array(columns.map_runs.length);
    for (let s = 0; s < perState.length; ++s) {
      for (let r = this.runStarts[s]; r < this.runStarts[s + 1]; ++r) perState[s] += columns.map_length[r];
    }
    this.levelStarts = startsOf(perState);
    this.state = -1;
  }
  /** Shows the last state that was known after `record`; true where that changed anything. */
  seek(record) {
    const wanted = lastNotAbove(this.records, record);
    if (wanted === this.state) return false;
    if (wanted < this.state) {
      this.levels.fill(UNKNOWN);
      this.state = -1;
    }
    while (this.state < wanted) this.#apply(++this.state);
    return true;
  }
  #apply(state) {
    const { map_gap: gap, map_length: length, map_level: level } = this.columns;
    let cell = 0;
    let next = this.levelStarts[state];
    for (let r = this.runStarts[state]; r < this.runStarts[state + 1]; ++r) {
      cell += gap[r];
      for (let i = 0; i < length[r]; ++i) this.levels[cell++] = level[next++] + UNKNOWN;
    }
  }
  /** Corners of the cells that are ever known [m]: x0, y0, x1, y1; nothing where none is. */
  bounds() {
    this.seek(Infinity);
    let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let y = 0; y < this.height; ++y) {
      for (let x = 0; x < this.width; ++x) {
        const level = this.levels[y * this.width + x];
        if (level > 6 && level < 14) continue;
        [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x + 1), Math.max(y1, y + 1)];
      }
    }
    const [ox, oy] = this.origin;
    return x1 < x0 ? undefined : [ox + x0 * this.cell, oy + y0 * this.cell, ox + x1 * this.cell, oy + y1 * this.cell];
  }
}

/** The particles of a variant: known after some frames, and moved on with the estimate in between. */
class Clouds {
  constructor(columns, estimate, run) {
    Object.assign(this, { columns, estimate, run });
    this.starts = startsOf(columns.cloud_count);
  }
  at(frame) {
    const c = lastNotAbove(this.columns.cloud_record, this.run.record[frame]);
    if (c < 0) return [];
    const taken = this.estimate.at(this.run.frameOf(this.columns.cloud_record[c]));
    const now = this.estimate.at(frame);
    // The motion of the estimate since then, seen from where it was.
    const [dx, dy] = [now.x - taken.x, now.y - taken.y];
    const [sin, cos] = [Math.sin(taken.theta), Math.cos(taken.theta)];
    const [mx, my, turn] = [cos * dx + sin * dy, -sin * dx + cos * dy, now.theta - taken.theta];
    const { cloud_x: x, cloud_y: y, cloud_theta: theta } = this.columns;
    const poses = [];
    for (let i = this.starts[c]; i < this.starts[c + 1]; ++i) {
      const heading = taken.theta + theta[i];
      const [s, k] = [Math.sin(heading), Math.cos(heading)];
      poses.push({ x: taken.x + x[i] + k * mx - s * my, y: taken.y + y[i] + s * mx + k * my, theta: heading + turn });
    }
    return poses;
  }
}

const wrapped = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

/** Distance [m] and turn [deg] between a path and the truth, a value per frame each. */
export function errorsOf(path, truth) {
  const position = Array.from(path.x, (x, f) => Math.hypot(x - truth.x[f], path.y[f] - truth.y[f]));
  const heading = Array.from(path.theta, (t, f) => (Math.abs(wrapped(t - truth.theta[f])) * 180) / Math.PI);
  return { position, heading };
}

class Run {
  constructor(json, columns) {
    Object.assign(this, { frames: json.frames, json, record: columns.record, time: columns.time, world: json.world });
    this.truth = pathOf(columns, 'truth');
    this.odometry = pathOf(columns, 'odometry');
    this.columns = columns;
    this.hitStarts = startsOf(columns.hits);
    this.loaded = new Map();
    // Stamps of real logs may jump: then curves run over records.
    this.timeRises = this.time.every((t, f) => f === 0 || t >= this.time[f - 1]);
  }
  get labels() {
    return this.json.variants.map((variant) => variant.label);
  }
  frameOf(record) {
    return lastNotAbove(this.record, record);
  }
  /** The x of curves at a record: seconds, interpolated between frames, or the record itself. */
  xAt(record) {
    if (!this.timeRises) return record;
    const f = this.frameOf(record);
    if (f + 1 >= this.frames || this.record[f] === record) return this.time[f];
    const share = (record - this.record[f]) / (this.record[f + 1] - this.record[f]);
    return this.time[f] + share * (this.time[f + 1] - this.time[f]);
  }
  /** Points where beams ended, seen from the base: [x, y] views. */
  hits(frame) {
    const [from, to] = [this.hitStarts[frame], this.hitStarts[frame + 1]];
    return [this.columns.hit_x.subarray(from, to), this.columns.hit_y.subarray(from, to)];
  }
  /** A variant's part, unpacked when it is first asked for. */
  variant(index) {
    if (!this.loaded.has(index)) this.loaded.set(index, this.#load(index));
    return this.loaded.get(index);
  }
  async #load(index) {
    const json = this.json.variants[index];
    const columns = await unpack(element(`pack-${index + 1}`).textContent, json.columns);
    const estimate = pathOf(columns, 'estimate');
    return {
      ...json,
      index,
      estimate,
      errors: estimate && this.truth ? errorsOf(estimate, this.truth) : undefined,
      clouds: estimate ? new Clouds(columns, estimate, this) : undefined,
      map: new GrowingMap(json.map, columns),
      registered: columns,
    };
  }
}

/** The run of this page; undefined where the page holds no data to play. */
export async function loadRun() {
  if (!element('player-data')) return undefined;
  const json = JSON.parse(element('player-data').textContent);
  return new Run(json, await unpack(element('pack-0').textContent, json.columns));
}
