// The response curve, beside that of the system without what the sliders are about.
"use strict";

/** Millimetres per kilonewton in a metre per newton. */
const MM_PER_KN = 1e6;
const HERTZ = 1 / (2 * Math.PI);

/** Between two samples a response is as good as straight, and its size is not: how many points its size takes. */
const BETWEEN = 3;

function sizes(samples) {
  const points = [];
  samples.forEach((a, k) => {
    const b = samples[k + 1];
    for (let step = 0; step < (b ? BETWEEN : 1); step++) {
      const t = step / BETWEEN;
      const at = (name) => (t > 0 ? a[name] * (1 - t) + b[name] * t : a[name]);
      points.push([at("omega") * HERTZ, MM_PER_KN * Math.hypot(at("re"), at("im"))]);
    }
  });
  return points;
}

class ResponseChart {
  constructor(figure) {
    this.chart = new Chart(figure);
    this.note = figure.querySelector(".note");
  }

  draw({ response, bare }, model) {
    const [curve, other] = [sizes(response), sizes(bare)];
    const first = curve[0][1];
    const largest = (points) => Math.max(...points.map(([, size]) => size));
    const [own, without] = [largest(curve), bare.length ? largest(other) : 0];
    const smallest = Math.min(...curve.map(([, size]) => size));
    const range = [0.7 * Math.max(smallest, first / 200), 1.5 * Math.min(Math.max(own, without), 200 * first)];
    const inside = ([hertz, size]) => [hertz, Math.min(Math.max(size, range[0]), range[1])];
    const axes = {
      x: linear([curve[0][0], curve.at(-1)[0]]),
      y: logarithmic(range),
      xLabel: "f [Hz]",
      yLabel: "mm/kN",
      about: `Response curve, largest ${readable(own)} millimetres per kilonewton`,
    };
    this.chart.draw(axes, () => {
      if (bare.length) this.chart.line("bare", "bare", other.map(inside));
      this.chart.line("curve", "curve", curve.map(inside));
    });
    const text = bare.length
      ? `${model.response}. Largest: ${own.toPrecision(3)} mm/kN; ${model.bare} (dashed): ${without.toPrecision(3)} mm/kN, ${(without / own).toPrecision(3)} times as much.`
      : `${model.response}.`;
    if (this.note.textContent !== text) this.note.textContent = text;
  }
}
