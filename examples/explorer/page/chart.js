// A chart: two axes with a grid, in which others draw.
"use strict";

const MARGIN = { left: 58, right: 16, top: 16, bottom: 44 };

/** Scales of an axis: a place between 0 and 1 of a value, the value at a place, and the values that have lines, some of them without a number. */
const linear = (range, count = 6) => ({
  place: (value) => (value - range[0]) / (range[1] - range[0]),
  value: (place) => range[0] + place * (range[1] - range[0]),
  lines: roundNumbers(range, count),
});

const logarithmic = (range) => {
  const [from, to] = range.map(Math.log10);
  const decades = roundNumbers([from, to], Math.ceil(to - from)).filter(Number.isInteger);
  const place = (value) => (Math.log10(value) - from) / (to - from);
  return { place, value: (place) => 10 ** (from + place * (to - from)), lines: decades.map((power) => 10 ** power) };
};

/** Square roots of distances from zero, on either side of it. Lines stand at 1, 2 and 5 times powers of ten, so that their spacing shows the scale. */
const rooted = (range) => {
  const root = (value) => Math.sign(value) * Math.sqrt(Math.abs(value));
  const [from, to] = range.map(root);
  const place = (value) => (root(value) - from) / (to - from);
  const lines = [0];
  const fine = [];
  for (const value of [-0.01, -0.02, -0.05, -0.1, -0.2, -0.5, -1, -2, -5, -10, -20, -50]) {
    if (place(value) >= 0) fine.push(value);
    if (place(value) >= 0 && place(lines.at(-1)) - place(value) > 0.13) lines.push(value);
  }
  const value = (place) => {
    const root_ = from + place * (to - from);
    return Math.sign(root_) * root_ * root_;
  };
  return { place, value, lines, fine };
};

class Chart {
  constructor(figure) {
    this.canvas = new Canvas(figure.querySelector(".canvas"));
    const { svg } = this.canvas;
    const follow = ({ clientX, clientY }) => {
      const { left, top } = svg.getBoundingClientRect();
      this.point([clientX - left, clientY - top]);
    };
    svg.addEventListener("pointermove", follow);
    svg.addEventListener("pointerdown", follow);
    svg.addEventListener("pointerleave", () => this.point(undefined));
  }

  /** How many pixels there are along x. */
  innerWidth() {
    return this.canvas.width - MARGIN.left - MARGIN.right;
  }

  /** Takes where the pointer is, and shows what the chart says there. */
  point(pointer) {
    this.pointer = pointer;
    if (this.drawn) this.draw(...this.drawn);
  }

  /** Draws the frame of a chart, and in it what `inside` draws; `told` says what is under the pointer. */
  draw({ x, y, xLabel, yLabel, about, told }, inside) {
    this.drawn = [{ x, y, xLabel, yLabel, about, told }, inside];
    const { canvas } = this;
    canvas.svg.setAttribute("aria-label", about);
    const { left, right, top, bottom } = MARGIN;
    const [width, height] = [canvas.width - left - right, canvas.height - top - bottom];
    this.x = (value) => left + width * x.place(value);
    this.y = (value) => top + height * (1 - y.place(value));
    canvas.draws(() => {
      const across = (x.fine ?? x.lines).map((value) => `M${this.x(value).toFixed(1)} ${top}v${height}`);
      const along = y.lines.map((value) => `M${left} ${this.y(value).toFixed(1)}h${width}`);
      canvas.keep("grid", "path", { class: "grid", d: across.concat(along).join("") });
      canvas.keep("frame", "rect", { class: "axis", x: left, y: top, width, height });
      x.lines.forEach((value, k) => this.number(`x${k}`, value, this.x(value), top + height + 16, "middle"));
      y.lines.forEach((value, k) => this.number(`y${k}`, value, left - 6, this.y(value) + 4, "end"));
      canvas.keep("xLabel", "text", { x: left + width / 2, y: top + height + 36, "text-anchor": "middle" }, xLabel);
      const turned = { x: 0, y: 0, "text-anchor": "middle", transform: `translate(14 ${top + height / 2}) rotate(-90)` };
      canvas.keep("yLabel", "text", turned, yLabel);
      inside();
      if (this.pointer) this.tell(x, y, told);
    });
  }

  /** What is under the pointer: a mark, and its values in a corner. */
  tell(x, y, told) {
    const { left, right, top, bottom } = MARGIN;
    const place = [(this.pointer[0] - left) / this.innerWidth(), 1 - (this.pointer[1] - top) / (this.canvas.height - top - bottom)];
    if (!place.every((part) => part >= 0 && part <= 1)) return;
    const found = told([x.value(place[0]), y.value(place[1])], this);
    if (!found) return;
    this.circle("told", "told", found.at, 4);
    const at = { class: "key reading", x: this.canvas.width - right - 8, y: top + 16, "text-anchor": "end" };
    this.canvas.keep("reading", "text", at, found.text);
  }

  /** The nearest of some values to a place of the axes, unless all are farther than so many pixels. */
  nearest([x, y], values, within = 24) {
    const beside = ([u, v]) => Math.hypot(this.x(u) - this.x(x), this.y(v) - this.y(y));
    const distances = values.map(beside);
    const least = distances.indexOf(Math.min(...distances));
    return distances[least] <= within ? least : undefined;
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
