// The room seen from above, drawn on a canvas: x to the right, y up.

import { colour } from './theme.js';

const NEAR = 300; // pixels per metre at most near the robot
const MARGIN = 14; // pixels around what is shown

/** The smallest box around all points; each list is flat pairs or paths. */
function boundsOf(run, variant) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  const add = (x, y) => {
    if (!Number.isFinite(x) || !Number.isFinite(y)) return;
    [box[0], box[1], box[2], box[3]] = [Math.min(box[0], x), Math.min(box[1], y), Math.max(box[2], x), Math.max(box[3], y)];
  };
  if (run.world) [...run.world.walls, ...run.world.obstacles].flat().forEach(([x, y]) => add(x, y));
  const known = variant.map.bounds();
  if (known && !run.world) {
    add(known[0], known[1]);
    add(known[2], known[3]);
  }
  // Odometry that drifted far off would make all else small.
  for (const path of [run.truth, variant.estimate]) path?.x.forEach((x, f) => add(x, path.y[f]));
  return box[0] > box[2] ? [-1, -1, 1, 1] : [box[0] - 0.15, box[1] - 0.15, box[2] + 0.15, box[3] + 0.15];
}

export class Scene {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext('2d');
    this.mapCanvas = document.createElement('canvas');
    this.layers = { map: true, walls: true, lidar: true, particles: true, truth: true, odometry: true, estimate: true };
    this.follow = false;
  }

  look(run, variant) {
    Object.assign(this, { run, variant, box: boundsOf(run, variant) });
    this.mapCanvas.width = Math.max(1, variant.map.width);
    this.mapCanvas.height = Math.max(1, variant.map.height);
    this.mapShown = undefined;
    this.resize();
  }

  /** Takes the width of the page, and a height that suits the room. */
  resize() {
    const [x0, y0, x1, y1] = this.box;
    const width = this.canvas.parentElement.clientWidth;
    const tallest = Math.min(680, Math.max(320, innerHeight * 0.78));
    const height = Math.min(tallest, Math.max(220, (width * (y1 - y0)) / (x1 - x0)));
    this.ratio = devicePixelRatio || 1;
    this.canvas.style.height = `${height}px`;
    this.canvas.width = Math.round(width * this.ratio);
    this.canvas.height = Math.round(height * this.ratio);
    this.size = [width, height];
    this.fit = Math.min((width - 2 * MARGIN) / (x1 - x0), (height - 2 * MARGIN) / (y1 - y0));
  }

  #aim(frame) {
    const [x0, y0, x1, y1] = this.box;
    const robot = (this.variant.estimate ?? this.run.truth ?? this.run.odometry).at(frame);
    const near = this.follow && Number.isFinite(robot.x);
    this.scale = near ? Math.max(this.fit * 2, Math.min(NEAR, this.fit * 12)) : this.fit;
    this.centre = near ? [robot.x, robot.y] : [(x0 + x1) / 2, (y0 + y1) / 2];
  }

  /** Pixels of the canvas (CSS pixels) for a point of the map [m]. */
  at(x, y) {
    return [this.size[0] / 2 + this.scale * (x - this.centre[0]), this.size[1] / 2 - this.scale * (y - this.centre[1])];
  }

  /** What a reader sees at a frame. */
  draw(frame) {
    const { pen, run, variant } = this;
    this.frame = frame;
    this.#aim(frame);
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    pen.fillStyle = colour('unknown');
    pen.fillRect(0, 0, ...this.size);
    variant.map.seek(run.record[frame]);
    if (this.layers.map) this.#drawMap();
    if (this.layers.walls && run.world) this.#drawWorld();
    const paths = [
      ['truth', run.truth, 7, [], 'truth'],
      ['odometry', run.odometry, 1.8, [7, 4], 'vermilion'],
      ['estimate', variant.estimate, 2, [], 'ink'],
    ];
    for (const [layer, path, width, dash, name] of paths) {
      if (this.layers[layer] && path) this.#drawPath(path, frame, width, dash, colour(name));
    }
    if (this.layers.lidar) this.#drawHits(frame);
    if (this.layers.truth && run.truth) this.#drawTrueRobot(run.truth.at(frame));
    if (this.layers.odometry) this.#drawOdometryRobot(run.odometry.at(frame));
    if (this.layers.estimate && variant.estimate) this.#drawRobot(variant.estimate.at(frame));
    if (this.layers.particles && variant.clouds) this.#drawCloud(frame);
    this.#drawScale();
  }

  /** Colours have changed. */
  repaint() {
    this.mapShown = undefined;
    if (this.frame !== undefined) this.draw(this.frame);
  }

  #paintMap() {
    const { map } = this.variant;
    const image = new ImageData(this.mapCanvas.width, this.mapCanvas.height);
    const rgb = (name) => [1, 3, 5].map((i) => parseInt(colour(name).slice(i, i + 2), 16));
    const [free, unknown, occupied] = ['free', 'unknown', 'occupied'].map(rgb);
    const table = Array.from({ length: 21 }, (_, level) => {
      const [from, to, share] = level <= 10 ? [free, unknown, level / 10] : [unknown, occupied, (level - 10) / 10];
      return from.map((v, i) => Math.round(v + (to[i] - v) * share));
    });
    for (let y = 0; y < map.height; ++y) {
      for (let x = 0; x < map.width; ++x) {
        const at = 4 * ((map.height - 1 - y) * map.width + x);
        const [r, g, b] = table[map.levels[y * map.width + x]];
        [image.data[at], image.data[at + 1], image.data[at + 2], image.data[at + 3]] = [r, g, b, 255];
      }
    }
    this.mapCanvas.getContext('2d').putImageData(image, 0, 0);
    this.mapShown = map.state;
  }

  #drawMap() {
    const { map } = this.variant;
    if (map.width === 0 || map.height === 0) return;
    if (this.mapShown !== map.state) this.#paintMap();
    const [left, top] = this.at(map.origin[0], map.origin[1] + map.height * map.cell);
    this.pen.imageSmoothingEnabled = this.scale * map.cell < 1;
    this.pen.drawImage(this.mapCanvas, left, top, map.width * map.cell * this.scale, map.height * map.cell * this.scale);
  }

  #drawWorld() {
    const { pen } = this;
    pen.lineWidth = 1.5;
    pen.setLineDash([]);
    pen.strokeStyle = colour('truth');
    for (const loop of [...this.run.world.walls, ...this.run.world.obstacles]) {
      pen.beginPath();
      loop.forEach(([x, y]) => pen.lineTo(...this.at(x, y)));
      pen.closePath();
      pen.stroke();
    }
  }

  #drawPath(path, frame, width, dash, stroke) {
    const { pen } = this;
    pen.beginPath();
    for (let f = 0; f <= frame; ++f) {
      if (Number.isFinite(path.x[f])) pen.lineTo(...this.at(path.x[f], path.y[f]));
    }
    Object.assign(pen, { lineWidth: width, strokeStyle: stroke, lineJoin: 'round', lineCap: 'round' });
    pen.setLineDash(dash);
    pen.stroke();
    pen.setLineDash([]);
  }

  #drawHits(frame) {
    const path = this.variant.estimate ?? this.run.truth;
    if (!path) return;
    const { pen } = this;
    const pose = path.at(frame);
    const [sin, cos] = [Math.sin(pose.theta), Math.cos(pose.theta)];
    const [xs, ys] = this.run.hits(frame);
    pen.fillStyle = colour('green');
    for (let i = 0; i < xs.length; ++i) {
      const [px, py] = this.at(pose.x + cos * xs[i] - sin * ys[i], pose.y + sin * xs[i] + cos * ys[i]);
      pen.fillRect(px - 2, py - 2, 4, 4);
    }
  }

  #drawCloud(frame) {
    const { pen } = this;
    Object.assign(pen, { strokeStyle: colour('purple'), lineWidth: 1.2, lineCap: 'butt' });
    pen.beginPath();
    for (const pose of this.variant.clouds.at(frame)) {
      const [px, py] = this.at(pose.x, pose.y);
      pen.moveTo(px + 1.6, py);
      pen.arc(px, py, 1.6, 0, 2 * Math.PI);
      pen.moveTo(px, py);
      pen.lineTo(px + 9 * Math.cos(pose.theta), py - 9 * Math.sin(pose.theta));
    }
    pen.stroke();
  }

  /** A closed shape about a pose; corners in pixels, x forward. */
  #shape(pose, corners) {
    const [px, py] = this.at(pose.x, pose.y);
    const [sin, cos] = [Math.sin(pose.theta), Math.cos(pose.theta)];
    this.pen.beginPath();
    corners.forEach(([x, y]) => this.pen.lineTo(px + cos * x - sin * y, py - sin * x - cos * y));
    this.pen.closePath();
  }

  #drawRobot(pose) {
    this.#shape(pose, [[12, 0], [-8, 8], [-4, 0], [-8, -8]]);
    Object.assign(this.pen, { fillStyle: colour('ink'), strokeStyle: colour('paper'), lineWidth: 1.5 });
    this.pen.fill();
    this.pen.stroke();
  }

  #drawTrueRobot(pose) {
    const [px, py] = this.at(pose.x, pose.y);
    const { pen } = this;
    Object.assign(pen, { strokeStyle: colour('truth'), lineWidth: 4 });
    pen.beginPath();
    pen.arc(px, py, 15, 0, 2 * Math.PI);
    pen.moveTo(px + 15 * Math.cos(pose.theta), py - 15 * Math.sin(pose.theta));
    pen.lineTo(px + 23 * Math.cos(pose.theta), py - 23 * Math.sin(pose.theta));
    pen.stroke();
  }

  #drawOdometryRobot(pose) {
    this.#shape(pose, [[9, 0], [0, 6], [-9, 0], [0, -6]]);
    Object.assign(this.pen, { strokeStyle: colour('vermilion'), lineWidth: 2 });
    this.pen.stroke();
  }

  #drawScale() {
    const { pen } = this;
    const metres = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200].find((m) => m * this.scale > 50) ?? 500;
    const [x, y] = [MARGIN, this.size[1] - MARGIN];
    const text = `${metres} m`;
    pen.font = '12px system-ui, sans-serif';
    pen.fillStyle = colour('paper');
    pen.fillRect(x - 6, y - 20, metres * this.scale + 12, 26);
    Object.assign(pen, { strokeStyle: colour('ink'), fillStyle: colour('ink'), lineWidth: 1.5, textAlign: 'center' });
    pen.beginPath();
    pen.moveTo(x, y - 4);
    pen.lineTo(x, y);
    pen.lineTo(x + metres * this.scale, y);
    pen.lineTo(x + metres * this.scale, y - 4);
    pen.stroke();
    pen.fillText(text, x + (metres * this.scale) / 2, y - 5);
  }
}
