// Where the roots are, and where they go as the slider that was touched last moves: in the complex plane, or against that slider.
"use strict";

/** How many values of the slider the ways of roots are followed at. */
const STEPS = 64;

class RootsChart {
  constructor(figure, engine) {
    this.chart = new Chart(figure);
    [this.engine, this.caption, this.note] = [engine, figure.querySelector("figcaption"), figure.querySelector(".note")];
    this.way = [];
    this.key = "";
  }

  /** Follows the roots further along the slider, for so many milliseconds; whether there is something new. */
  follow(model, values, active, milliseconds) {
    const key = JSON.stringify([model, active, values.map((value, k) => (k === active ? 0 : value))]);
    if (key !== this.key) [this.key, this.way] = [key, []];
    const { min, max } = this.engine.models[model].sliders[active];
    const end = performance.now() + milliseconds;
    const before = this.way.length;
    while (this.way.length <= STEPS && performance.now() < end) {
      const value = min + ((max - min) * this.way.length) / STEPS;
      const answer = this.engine.showRoots(model, values.map((own, k) => (k === active ? value : own)));
      this.way.push({ value, roots: answer.problem ? [] : answer.eigenvalues, frequencies: answer.problem ? [] : answer.frequencies });
    }
    return this.way.length > before;
  }

  draw(answer, slider, value, mode) {
    if (answer.eigenvalues.length > 0 || answer.plane.length > 0) this.drawPlane(answer, slider, mode);
    else this.drawAgainst(answer.frequencies, slider, value, mode);
  }

  say(caption, more, note) {
    const text = `${caption} ${more}`;
    if (this.caption.textContent !== text) {
      this.caption.replaceChildren(`${caption} `, Object.assign(document.createElement("span"), { textContent: more }));
    }
    if (this.note.textContent !== note) this.note.textContent = note;
  }

  drawPlane({ eigenvalues, plane: [searched, pictured] }, slider, mode) {
    const { reMin, reMax, imMin, imMax } = pictured;
    const isInside = ({ re, im }) => re >= reMin && re <= reMax && im >= imMin && im <= imMax;
    const axes = {
      x: rooted([reMin, reMax]),
      y: linear([imMin, imMax]),
      xLabel: "Re λ [1/s], square-root scale",
      yLabel: "Im λ [rad/s]",
      told: (at, chart) => {
        const near = chart.nearest(at, eigenvalues.map(({ re, im }) => [re, im]));
        if (near === undefined) return undefined;
        const { re, im, ratio } = eigenvalues[near];
        return { at: [re, im], text: `${readable(re, 4)} + ${readable(im, 5)} i, ${readable(100 * ratio)} %` };
      },
      about: `Eigenvalues in the complex plane: ${eigenvalues.map(({ re, im }) => `${readable(re)} + ${readable(im)} i`).join(", ")}`,
    };
    this.chart.draw(axes, () => {
      this.chart.line("axis", "axis", [[0, imMin], [0, imMax]]);
      for (const ratio of [0.02, 0.1, 0.3]) this.ratioLine(ratio, pictured);
      const way = this.way.flatMap(({ roots }) => roots.filter(isInside));
      this.chart.dots("way", "dots", way.map(({ re, im }) => [re, im]));
      eigenvalues.forEach(({ re, im }, k) => {
        if (isInside({ re, im })) this.chart.circle(`root${k}`, `root${k === mode ? " chosen" : ""}`, [re, im], 6);
      });
    });
    const above = eigenvalues.filter((root) => !isInside(root)).length;
    const count = eigenvalues.reduce((sum, { multiplicity }) => sum + multiplicity, 0);
    this.say("Eigenvalues", "in the complex plane",
      `Dots: where they go with “${slider.label}”. Dashed: damping ratios. There are ${count} with Im λ up to ${readable(searched.imMax)} and`
      + ` Re λ from ${readable(searched.reMin)} on, and no others${above ? `; ${above} beyond the picture` : ""}.`);
  }

  /** The line of equal damping ratio. */
  ratioLine(ratio, { reMin, imMax }) {
    const slope = ratio / Math.sqrt(1 - ratio * ratio);
    const end = Math.min(imMax, -reMin / slope);
    const points = Array.from({ length: 25 }, (_, k) => (k / 24) ** 2 * end).map((im) => [-slope * im, im]);
    this.chart.line(`ratio${ratio}`, "bare", points);
    const at = 0.93 * end;
    this.chart.words(`ratioText${ratio}`, [-slope * at, at], `${100 * ratio} %`, 6);
  }

  drawAgainst(frequencies, slider, value, mode) {
    const hertz = ({ omega }) => omega * HERTZ;
    const highest = Math.max(...frequencies.map(hertz), ...this.way.flatMap(({ frequencies }) => frequencies.map(hertz)));
    const axes = {
      x: linear([slider.min, slider.max]),
      y: linear([0, 1.05 * highest]),
      xLabel: `${slider.label} [${slider.unit}]`,
      yLabel: "f [Hz]",
      told: (at, chart) => {
        const all = this.way.flatMap(({ value, frequencies }) => frequencies.map((root, k) => [value, hertz(root), k]));
        const near = chart.nearest(at, all);
        if (near === undefined) return undefined;
        const [value, f, k] = all[near];
        return { at: [value, f], text: `${readable(value)} ${slider.unit}: f${k + 1} = ${readable(f, 5)} Hz` };
      },
      about: `Natural frequencies against ${slider.label}`,
    };
    this.chart.draw(axes, () => {
      frequencies.forEach((_, k) => {
        const points = this.way.filter(({ frequencies }) => frequencies[k]);
        this.chart.line(`way${k}`, "trace", points.map(({ value, frequencies }) => [value, hertz(frequencies[k])]));
      });
      this.chart.line("here", "here", [[value, 0], [value, 1.05 * highest]]);
      frequencies.forEach((root, k) => {
        this.chart.circle(`root${k}`, `root${k === mode ? " chosen" : ""}`, [value, hertz(root)], 5);
      });
    });
    this.say("Natural frequencies", "as the slider moves",
      `The first ${frequencies.length}, counted: none is left out, also where curves meet.`);
  }
}
