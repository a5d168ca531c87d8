// Runs the module in Node: against what this machine finds, against exact values, and how long a solve takes.
//   node module.mjs MODULE VALUES ROOTS FRAMES
// VALUES are what the example `values` prints; ROOTS of the bridge are written, for exact.py; FRAMES are the reference cases.
import { readFileSync, writeFileSync } from "node:fs";
import { cpuUsage } from "node:process";
import { runInThisContext } from "node:vm";

for (const script of ["engine.js", "response.js"]) runInThisContext(readFileSync(new URL(`../page/${script}`, import.meta.url), "utf8"));
const [module, values, asked, frames] = process.argv.slice(2);
const lines = readFileSync(values, "utf8").trim().split("\n").map((line) => JSON.parse(line));

/** The largest difference of numbers, beside the largest of their column. */
function difference(rows, numbers) {
  const own = rows.flatMap((row) => Object.values(row));
  if (own.length !== numbers.length) throw new Error(`${own.length} numbers, not ${numbers.length}`);
  const width = rows.length ? Object.keys(rows[0]).length : 1;
  const largest = Array(width).fill(0);
  numbers.forEach((number, k) => (largest[k % width] = Math.max(largest[k % width], Math.abs(number))));
  return own.reduce((worst, number, k) => Math.max(worst, Math.abs(number - numbers[k]) / (largest[k % width] || 1)), 0);
}

function checkAgainstMachine(engine) {
  const worst = {};
  for (const { model, values, tables } of lines) {
    const answer = engine.show(model, values);
    if (answer.problem) throw new Error(answer.problem);
    for (const [name, numbers] of Object.entries(tables)) {
      worst[name] = Math.max(worst[name] ?? 0, difference(answer[name], numbers));
    }
  }
  for (const [name, error] of Object.entries(worst)) {
    console.log(`${name.padEnd(12)} differs from this machine's by ${error.toExponential(1)} at most, of its largest number`);
    if (!(error < 1e-12)) throw new Error(`${name} differs`);
  }
}

/** The symmetric portal of the reference cases. */
function checkAgainstReference(engine) {
  const { omega } = JSON.parse(readFileSync(frames, "utf8")).portal.wanted;
  const { frequencies } = engine.show(1, [2, 35, 2, 0, 1]);
  const errors = frequencies.map((root, k) => Math.abs(root.omega / omega[k] - 1));
  const held = frequencies.filter(({ lower, upper }, k) => lower <= omega[k] && omega[k] <= upper).length;
  console.log(`portal: ${errors.length} frequencies differ from 24 digits by ${Math.max(...errors).toExponential(1)} at most; ${held} intervals hold them`);
  if (!(errors.length === 5 && held === 5 && Math.max(...errors) < 1e-14)) throw new Error("the portal is not exact");
}

/** The roots of bridges, for the check that knows their closed form. */
function writeRoots(engine) {
  const roots = lines.filter(({ model }) => model === 0).map(({ model, values }) => {
    const { eigenvalues, frequencies } = engine.show(model, values);
    return { values, eigenvalues, frequencies };
  });
  writeFileSync(asked, JSON.stringify(roots));
}

/** Values of sliders as a hand would leave them, the same at each run. */
function* places(sliders, count) {
  let state = 1;
  const next = () => (state = (state * 16807) % 2147483647) / 2147483647;
  for (let k = 0; k < count; k++) yield sliders.map(({ min, max, step }) => min + Math.round((next() * (max - min)) / step) * step);
}

/** Curves between samples: of every other sample the page's curve meets the others, beside poles too. */
function checkCurves(engine) {
  engine.models.forEach(({ name, sliders }, model) => {
    const worst = { own: 0, bare: 0 };
    for (const values of [sliders.map(({ start }) => start), ...places(sliders, 60)]) {
      const answer = engine.show(model, values);
      if (answer.problem) throw new Error(answer.problem);
      for (const [key, samples, poles] of [["own", answer.response, answer.poles], ["bare", answer.bare, answer.barePoles]]) {
        if (samples.length === 0) continue;
        const whole = new ResponseCurve(samples, poles);
        const half = new ResponseCurve(samples.filter(({ omega }, k) => k % 2 === 0 || omega === samples.at(-1).omega), poles);
        const static_ = whole.size(whole.range()[0]);
        for (const omega of whole.omegas) {
          const [exact, found] = [whole.size(omega), half.size(omega)];
          // a pixel of the picture is some hundredth of a decade
          const error = Math.abs(found - exact) / (exact + 0.01 * static_);
          worst[key] = Math.max(worst[key], error);
        }
      }
    }
    console.log(`${name}: from half of its samples the curve differs by ${worst.own.toExponential(1)} at most from the others,`
      + ` the dashed one by ${worst.bare.toExponential(1)}`);
    if (!(worst.own < 2e-2 && worst.bare < 2e-2)) throw new Error("the curve is not that of its samples");
  });
}

function measure(engine) {
  engine.models.forEach(({ name, sliders }, model) => {
    const [times, problems] = [[], []];
    for (const values of places(sliders, 1000)) {
      const before = cpuUsage();
      const { problem } = engine.show(model, values);
      times.push(cpuUsage(before).user / 1e3);
      if (problem) problems.push(`${problem} at ${values}`);
    }
    const sorted = times.slice(200).sort((a, b) => a - b);
    const at = (part) => sorted[Math.floor(part * (sorted.length - 1))].toFixed(2);
    console.log(`${name}: ${at(0.5)} ms of the processor a solve, nine of ten below ${at(0.9)} ms, at 1000 random places; ${problems.length} refused`);
    if (problems.length > 0) throw new Error(problems[0]);
  });
}

const engine = await startEngine(readFileSync(module));
checkAgainstMachine(engine);
checkAgainstReference(engine);
writeRoots(engine);
checkCurves(engine);
measure(engine);
