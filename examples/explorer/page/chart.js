// A chart: two axes with a grid, in which others draw.
"use strict";

const MARGIN = { left: 58, right: 16, top: 16, bottom: 44 };

/** Scales of an axis: a place between 0 and 1 of a value, and the values that have lines. */
const linear = (range, count = 6) => ({
  place: (value) => (value - range[0]) / (range[1] - range[0]),
  lines: roundNumbers(range, count),
});

const logarithmic = (range) => {
  const [from, to] = range.map(Math.log10);
  const decades = roundNumbers([from, to], Math.ceil(to - from)).filter(Number.isInteger);
  return { place: (value) => (Math.log10(value) - from) / (to - from), lines: decades.map((power) => 10 ** power) };
};

/** Square roots of distances from zero, on either side of it. */
const rooted = (range) => {
  const root = (value) => Math.sign(value) * Math.sqrt(Math.abs(value));
  const [from, to] = range.map(root);
  const place = (value) => (root(value) - from) / (to - from);
  const lines = [0];
  for (const value of [-0.1, -0.2, -0.5, -1, -2, -5, -10, -20]) {
    if (place(value) >= 0 && place(lines.at(-1)) - place(value) > 0.13) lines.push(value);
  }
  return { place, lines };
};

class Chart {
  constructor(figure) {
    this.canvas = new Canvas(figure.querySelector(".canvas"));
  }

  /** Draws the frame of a chart, and in it what `inside` draws. */
  draw({ x, y, xLabel, yLabel, about }, inside) {
    const { canvas } = this;
    canvas.svg.setAttribute("aria-label", about);
    const { left, right, top, bottom } = MARGIN;
    const [width, height] = [canvas.width - left - right, canvas.height - top - bottom];
    this.x = (value) => left + width * x.place(value);
    this.y = (value) => top + height * (1 - y.place(value));
    canvas.draws(() => {
      const across = x.lines.map((value) => `M${this.x(value).toFixed(1)} ${top}v${height}`);
      const along = y.lines.map((value) => `M${left} ${this.y(value).toFixed(1)}h${width}`);
      canvas.keep("grid", "path", { class: "grid", d: across.concat(along).join("") });
      canvas.keep("frame", "rect", { class: "axis", x: left, y: top, width, height });
      x.lines.forEach((value, k) => this.number(`x${k}`, value, this.x(value), top + height + 16, "middle"));
      y.lines.forEach((value, k) => this.number(`y${k}`, value, left - 6, this.y(value) + 4, "end"));
      canvas.keep("xLabel", "text", { x: left + width / 2, y: top + height + 36, "text-anchor": "middle" }, xLabel);
      const turned = { x: 0, y: 0, "text-anchor": "middle", transform: `translate(14 ${top + height / 2}) rotate(-90)` };
      canvas.keep("yLabel", "text", turned, yLabel);
      inside();
    });
  }

  number(key, value, x, y, anchor) {
    this.canvas.keep(key, "text", { x: x.toFixed(1), y: y.toFixed(1), "text-anchor": anchor }, readable(value));
  }

  /** A line through values, or dots at them. */
  line(key, className, values) {
    this.canvas.keep(key, "path", { class: className, d: pathThrough(values.map(([x, y]) => [this.x(x), this.y(y)])) });
  }

  dots(key, className, values) {
    const d = values.map(([x, y]) => `M${this.x(x).toFixed(1)} ${this.y(y).toFixed(1)}h0`).join("");
    this.canvas.keep(key, "path", { class: className, d });
  }

  circle(key, className, [x, y], r) {
    this.canvas.keep(key, "circle", { class: className, cx: this.x(x).toFixed(2), cy: this.y(y).toFixed(2), r });
  }

  words(key, [x, y], text, away) {
    this.canvas.keep(key, "text", { class: "key", x: (this.x(x) + away).toFixed(1), y: (this.y(y) + 4).toFixed(1) }, text);
  }
}
