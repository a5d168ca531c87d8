// The model as it stands and as it moves.
"use strict";

/** The largest displacement that is drawn, as a part of the size of the model. */
const AMPLITUDE = 0.09;

class Drawing {
  constructor(figure, kinds) {
    this.canvas = new Canvas(figure.querySelector(".canvas"));
    this.kinds = kinds;
    this.shape = [];
  }

  /** Takes an answer and the mode to be drawn, turned so that it goes on from what was drawn before. */
  take({ parts, points, shapes }, mode, about) {
    this.canvas.svg.setAttribute("aria-label", about);
    [this.parts, this.points] = [parts, points];
    const shape = shapes.slice(mode * points.length, (mode + 1) * points.length);
    this.shape = shape.length === this.shape.length ? turnedTowards(shape, this.shape) : shape;
    this.fit();
  }

  /** Finds the scale in which the model fits, with room for its motion. */
  fit() {
    const [xs, ys] = [this.points.map(({ x }) => x), this.points.map(({ y }) => y)];
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    this.size = Math.max(right - left, high - low);
    const room = this.size * (AMPLITUDE + 0.03);
    const { width, height } = this.canvas;
    this.scale = Math.min((width - 60) / (right - left + room), (height - 44) / (high - low + 2 * room));
    const [middle, level] = [(left + right) / 2, (low + high) / 2];
    this.at = ([x, y]) => [width / 2 + this.scale * (x - middle), height / 2 - 6 - this.scale * (y - level)];
  }

  /** Draws the motion at a phase; `extremes` adds the shape half a period later. */
  draw(phase, extremes) {
    const places = (phase) => this.points.map(({ x, y }, k) => {
      const { xRe, xIm, yRe, yIm } = this.shape[k] ?? { xRe: 0, xIm: 0, yRe: 0, yIm: 0 };
      const [cos, sin] = [AMPLITUDE * this.size * Math.cos(phase), AMPLITUDE * this.size * Math.sin(phase)];
      return this.at([x + cos * xRe - sin * xIm, y + cos * yRe - sin * yIm]);
    });
    const now = places(phase);
    const rest = this.points.map(({ x, y }) => this.at([x, y]));
    const later = extremes ? places(phase + Math.PI) : [];
    this.canvas.draws(() => {
      const of = (part, places) => places.slice(part.first, part.first + part.count);
      const beams = this.parts.filter(({ kind }) => this.kinds[kind] === "beam");
      const all = (places) => beams.map((part) => pathThrough(of(part, places))).join("");
      this.canvas.keep("rest", "path", { class: "rest", d: all(rest) });
      this.parts.forEach((part, k) => {
        if (this.kinds[part.kind] === "mass") restOfMass(this.canvas, `rest${k}`, rest[part.first]);
      });
      if (extremes) this.canvas.keep("later", "path", { class: "turned", d: all(later) });
      this.parts.forEach((part, k) => PARTS[this.kinds[part.kind]](this.canvas, k, of(part, now)));
    });
  }
}

/** Where a mass is at rest, pale below its motion. */
function restOfMass(canvas, key, [x, y]) {
  canvas.keep(key, "rect", { class: "rest", x: (x - 20).toFixed(1), y: (y - 11).toFixed(1), width: 40, height: 22, rx: 4 });
}

/** How each kind of part is drawn through its points. */
const PARTS = {
  beam: (canvas, key, points) => canvas.keep(key, "path", { class: "beam", d: pathThrough(points) }),
  mass: (canvas, key, [[x, y]]) =>
    canvas.keep(key, "rect", { class: "mass", x: (x - 20).toFixed(1), y: (y - 11).toFixed(1), width: 40, height: 22, rx: 4 }),
  spring: (canvas, key, [[x, y], [, to]]) => {
    const teeth = Array.from({ length: 9 }, (_, k) => [x - 10 + (k % 2 ? 6 : -6), y + ((to - y) * (k + 2)) / 12]);
    const d = pathThrough([[x - 10, y], [x - 10, y + (to - y) / 8], ...teeth, [x - 10, y + ((to - y) * 7) / 8], [x - 10, to]]);
    canvas.keep(key, "path", { class: "link", d });
  },
  dashpot: (canvas, key, [[x, y], [, to]]) => {
    const [right, middle] = [x + 10, (y + to) / 2];
    const d = `M${right} ${y}V${middle - 2}m-5 0h10M${right - 7} ${middle - 9}v16h14v-16M${right} ${middle + 7}V${to}`;
    canvas.keep(key, "path", { class: "link", d });
  },
  pinned: (canvas, key, [[x, y]]) =>
    canvas.keep(key, "path", { class: "support", d: `M${x} ${y}l-10 17h20zm-16 17h32` }),
  fixed: (canvas, key, [[x, y]]) =>
    canvas.keep(key, "path", { class: "support", d: `M${x - 20} ${y}h40m-34 0l-6 8m14-8l-6 8m14-8l-6 8m14-8l-6 8m14-8l-6 8` }),
};

/** A shape times the number of modulus 1 that brings it nearest to another one: shapes are known up to that. */
function turnedTowards(shape, other) {
  let [re, im] = [0, 0];
  shape.forEach((a, k) => {
    const b = other[k];
    re += a.xRe * b.xRe + a.xIm * b.xIm + a.yRe * b.yRe + a.yIm * b.yIm;
    im += a.xRe * b.xIm - a.xIm * b.xRe + a.yRe * b.yIm - a.yIm * b.yRe;
  });
  const size = Math.hypot(re, im);
  if (!(size > 0)) return shape;
  const [c, s] = [re / size, im / size];
  const turn = (re, im) => [c * re - s * im, c * im + s * re];
  return shape.map(({ xRe, xIm, yRe, yIm }) => {
    const [[x, xi], [y, yi]] = [turn(xRe, xIm), turn(yRe, yIm)];
    return { xRe: x, xIm: xi, yRe: y, yIm: yi };
  });
}
