// Elements of drawings that stay while their attributes change, and numbers as people read them.
"use strict";

/** An SVG as large as its host, in pixels: `each(width, height)` draws it, now and whenever the host changes its size. */
class Canvas {
  constructor(host) {
    this.svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    this.svg.setAttribute("role", "img");
    host.append(this.svg);
    this.kept = new Map();
    this.onResize = () => {};
    new ResizeObserver(([{ contentRect: { width, height } }]) => {
      [this.width, this.height] = [width, height];
      this.onResize();
    }).observe(host);
    ({ clientWidth: this.width, clientHeight: this.height } = host);
  }

  /** The element of a key, made when it is first asked for, with attributes: those that are as before are left alone. */
  keep(key, tag, attributes, text) {
    let element = this.kept.get(key);
    if (!element) {
      element = document.createElementNS(this.svg.namespaceURI, tag);
      this.svg.append(element);
      element.known = {};
      this.kept.set(key, element);
    }
    for (const [name, value] of Object.entries(attributes)) {
      if (element.known[name] !== value) element.setAttribute(name, (element.known[name] = value));
    }
    if (text !== undefined && element.textContent !== text) element.textContent = text;
    this.used?.add(key);
    return element;
  }

  /** Runs what keeps elements, and drops those that it has not asked for. */
  draws(what) {
    this.used = new Set();
    what();
    for (const [key, element] of this.kept) {
      if (this.used.has(key)) continue;
      element.remove();
      this.kept.delete(key);
    }
    this.used = undefined;
  }
}

/** A path through points. */
const pathThrough = (points) => points.map(([x, y], k) => `${k ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");

/** About `count` round numbers in a range. */
function roundNumbers([from, to], count) {
  const raw = (to - from) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((step) => step >= raw * 0.999);
  const first = Math.ceil(from / step - 1e-9);
  const last = Math.floor(to / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, k) => (first + k) * step);
}

/** A number with a few digits, and a minus sign that is one. */
function readable(number, digits = 3) {
  if (number === Infinity) return "∞";
  const text = Math.abs(number) >= 1e4 || (number !== 0 && Math.abs(number) < 1e-3)
    ? number.toExponential(digits - 1).replace("e+", "e")
    : String(+number.toPrecision(digits));
  return text.replaceAll("-", "−");
}
