// The response curve, beside that of the system without what the sliders are about.
"use strict";

/** Millimetres per kilonewton in a metre per newton. */
const MM_PER_KN = 1e6;
const HERTZ = 1 / (2 * Math.PI);

/** How many samples around a frequency give the value there. */
const AROUND = 6;

/** So near to an undamped pole, as a part of its frequency, a sample has lost its digits. */
const NEAR_POLE = 1e-9;

/** Distances from a peak at which its curve has points, in half widths of the peak and in pixels. */
const BESIDE = [0, 0.25, 0.5, 1, 1.5, 2, 3, 4, 6, 9, 14];
const BESIDE_POLE = [1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.25];

const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
const over = ([a, b], [c, d]) => [(a * c + b * d) / (c * c + d * d), (b * c - a * d) / (c * c + d * d)];

/** A response between its samples: its poles are divided out, and what is left is smooth, a polynomial from sample to sample. */
class ResponseCurve {
  constructor(samples, poles) {
    this.poles = poles.filter(({ re, im }) => re !== 0 || im !== 0);
    const apart = samples.filter(({ omega }, k) => this.isApart(omega) && !(k > 0 && omega <= samples[k - 1].omega));
    this.omegas = apart.map(({ omega }) => omega);
    this.smooth = apart.map(({ omega, re, im }) => times([re, im], this.factor(omega)));
  }

  /** Whether a frequency is at no undamped pole. */
  isApart(omega) {
    return this.poles.every(({ re, im }) => re !== 0 || Math.abs(omega / im - 1) > NEAR_POLE);
  }

  /** `∏ (iω - λ)(iω - λ̄)/|λ|²` over all poles. */
  factor(omega) {
    const one = ({ re, im }) => {
      const square = re * re + im * im;
      return [1 - (omega * omega) / square, (-2 * re * omega) / square];
    };
    return this.poles.reduce((product, pole) => times(product, one(pole)), [1, 0]);
  }

  /** The value at a frequency, in metres per newton. */
  at(omega) {
    const { omegas, smooth } = this;
    let [low, high] = [0, omegas.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (omegas[middle] <= omega) low = middle;
      else high = middle;
    }
    const first = Math.max(0, Math.min(low - AROUND / 2 + 1, omegas.length - AROUND));
    const last = Math.min(first + AROUND, omegas.length);
    const value = [0, 0];
    for (let k = first; k < last; k++) {
      let weight = 1;
      for (let other = first; other < last; other++) {
        if (other !== k) weight *= (omega - omegas[other]) / (omegas[k] - omegas[other]);
      }
      value[0] += weight * smooth[k][0];
      value[1] += weight * smooth[k][1];
    }
    return over(value, this.factor(omega));
  }

  /** Its size, in millimetres per kilonewton; infinite at an undamped pole. */
  size(omega) {
    return this.isApart(omega) ? MM_PER_KN * Math.hypot(...this.at(omega)) : Infinity;
  }

  /** From where to where it is known. */
  range() {
    return [this.omegas[0], this.omegas.at(-1)];
  }

  /** Points of the curve of its size, over the frequency in Hz: one for each of so many pixels, and more around peaks and where it vanishes. */
  points(pixels) {
    const [from, to] = this.range();
    const pixel = (to - from) / pixels;
    const omegas = Array.from({ length: Math.round(pixels) + 1 }, (_, k) => from + k * pixel);
    for (const { re, im } of this.poles) {
      const steps = re === 0 ? BESIDE_POLE.map((part) => part * pixel) : BESIDE.map((part) => part * Math.abs(re));
      omegas.push(...steps.flatMap((step) => [im - step, im + step]));
    }
    const isThere = (omega, k, all) => omega >= from && omega <= to && !(k > 0 && omega === all[k - 1]) && this.isApart(omega);
    const sorted = omegas.sort((a, b) => a - b).filter(isThere);
    return this.withZeros(sorted.map((omega) => [omega, this.at(omega)])).map(([omega, value]) => [omega * HERTZ, MM_PER_KN * Math.hypot(...value)]);
  }

  /** Points with those between them at which a real response goes through zero; at a pole it changes its sign, too. */
  withZeros(points) {
    const isPole = (from, to) => this.poles.some(({ re, im }) => re === 0 && from < im && im < to);
    return points.flatMap(([omega, value], k) => {
      const [next, after] = points[k + 1] ?? [omega, value];
      const crosses = value[0] * after[0] < 0 && value[1] === 0 && after[1] === 0 && !isPole(omega, next);
      return crosses ? [[omega, value], [omega + ((next - omega) * value[0]) / (value[0] - after[0]), [0, 0]]] : [[omega, value]];
    });
  }
}

class ResponseChart {
  constructor(figure) {
    this.chart = new Chart(figure);
    this.note = figure.querySelector(".note");
  }

  draw(answer, model) {
    const own = new ResponseCurve(answer.response, answer.poles);
    const bare = answer.bare.length > 0 ? new ResponseCurve(answer.bare, answer.barePoles) : undefined;
    const pixels = Math.max(this.chart.innerWidth(), 100);
    const [curve, other] = [own.points(pixels), bare?.points(pixels) ?? []];
    const first = curve[0][1];
    const largest = (points) => Math.max(...points.map(([, size]) => size));
    const [most, without] = [largest(curve), bare ? largest(other) : 0];
    const smallest = Math.min(...curve.map(([, size]) => size));
    const range = [0.7 * Math.max(smallest, first / 200), 1.5 * Math.min(Math.max(most, without), 200 * first)];
    const inside = ([hertz, size]) => [hertz, Math.min(Math.max(size, range[0]), range[1])];
    const axes = {
      x: linear(own.range().map((omega) => omega * HERTZ)),
      y: logarithmic(range),
      xLabel: "f [Hz]",
      yLabel: "mm/kN",
      about: `Response curve, largest ${readable(most)} millimetres per kilonewton`,
      told: ([hertz]) => ({
        at: [hertz, inside([hertz, own.size(hertz / HERTZ)])[1]],
        text: `${hertz.toFixed(2)} Hz: ${readable(own.size(hertz / HERTZ))} mm/kN`
          + (bare ? `, ${model.bare} ${readable(bare.size(hertz / HERTZ))}` : ""),
      }),
    };
    this.chart.draw(axes, () => {
      if (bare) this.chart.line("bare", "bare", other.map(inside));
      this.chart.line("curve", "curve", curve.map(inside));
    });
    const text = bare
      ? `${model.response}. Largest: ${most.toPrecision(3)} mm/kN; ${model.bare} (dashed): ${without.toPrecision(3)} mm/kN, ${(without / most).toPrecision(3)} times as much.`
      : `${model.response}.`;
    if (this.note.textContent !== text) this.note.textContent = text;
  }
}
