// The page: sliders ask, the next frame answers.
"use strict";

/** The module, out of its Base64 and gzip. */
async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** Turns per second that the first mode is shown at; others by the square root of their frequency. */
const TURNS = 0.5;

/** For so many frames a new model is solved again and again: browsers compile well what has run often. */
const WARM = 40;

async function start() {
  const engine = await startEngine(await unpacked(MODEL));
  const part = (id) => document.getElementById(id);
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const state = { model: 0, values: [], mode: 0, active: 0, isNew: true, plays: !still.matches, phase: 0, tabled: 0 };
  const drawing = new Drawing(part("motion"), engine.kinds);
  const response = new ResponseChart(part("response"));
  const roots = new RootsChart(part("roots"), engine);
  const models = new Choice(part("models"), (model) => choose({ model }));
  const modes = new Choice(part("modes"), (mode) => {
    Object.assign(state, { mode, isNew: true });
    remember();
  });
  for (const { canvas } of [drawing, response.chart, roots.chart]) canvas.onResize = () => (state.isNew = true);

  /** How many milliseconds the last answers took. */
  const took = [];

  /** Writes what is shown into the address, a little later: browsers refuse to do it many times a second. */
  function remember() {
    clearTimeout(state.remembers);
    state.remembers = setTimeout(() => history.replaceState(null, "", addressOf(engine.models, state)), 250);
  }

  function choose({ model, values = engine.models[model].sliders.map(({ start }) => start), mode = 0 }) {
    const { sliders, about } = engine.models[model];
    Object.assign(state, { model, values, mode, active: 0, isNew: true, tabled: 0, warm: WARM });
    took.length = 0;
    models.show(engine.models.map(({ name }) => name), model);
    part("about").textContent = about;
    makeSliders(part("fields"), sliders, state.values, (index, value) => {
      state.values[index] = value;
      Object.assign(state, { active: index, isNew: true });
      remember();
    });
    remember();
  }

  function show() {
    const began = performance.now();
    const answer = engine.show(state.model, state.values);
    took.push(performance.now() - began);
    if (took.length > 15) took.shift();
    part("problem").hidden = !answer.problem;
    if (answer.problem) {
      part("problem").textContent = `No certified answer here: ${answer.problem}.`;
      return;
    }
    state.answer = answer;
    const shown = answer.plane.length > 0 ? answer.eigenvalues : answer.frequencies;
    state.mode = Math.min(state.mode, Math.max(shown.length - 1, 0));
    state.speeds = shown.map(({ omega, re, im }) => omega ?? Math.hypot(re, im));
    const names = shown.map(({ omega, im, ratio }, k) =>
      `${k + 1}: ${((omega ?? im) * HERTZ).toFixed(2)} Hz${ratio === undefined ? "" : `, ${(100 * ratio).toFixed(1)} %`}`);
    modes.show(names, state.mode);
    drawing.take(answer, state.mode, `Shape of mode ${names[state.mode]}`);
    response.draw(answer, engine.models[state.model]);
  }

  function frame(now) {
    const isNew = state.isNew || state.warm > 0;
    Object.assign(state, { isNew: false, warm: state.warm - 1 });
    if (isNew) show();
    const { model, values, active, answer } = state;
    if (answer) {
      if (roots.follow(model, values, active, isNew ? 1 : 5) || isNew) {
        roots.draw(answer, engine.models[model].sliders[active], values[active], state.mode);
      }
      if (state.plays) state.phase += ((now - (state.last ?? now)) / 1e3) * turns(state) * 2 * Math.PI;
      if (state.plays || isNew) drawing.draw(state.plays ? state.phase : 0, !state.plays);
      if (isNew) state.untabled = true;
      if (state.untabled && now - state.tabled > 120) {
        showResults(part("results"), answer);
        part("status").textContent = `Solved in ${took.toSorted((a, b) => a - b)[took.length >> 1].toFixed(1)} ms.`;
        Object.assign(state, { tabled: now, untabled: false });
      }
    }
    state.last = now;
    requestAnimationFrame(frame);
  }

  const turns = ({ speeds, mode }) => TURNS * Math.min(Math.sqrt(speeds[mode] / speeds[0]) || 1, 4);

  function play(plays) {
    Object.assign(state, { plays, isNew: true });
    part("play").textContent = plays ? "Pause" : "Play";
  }
  part("play").addEventListener("click", () => play(!state.plays));
  part("reset").addEventListener("click", () => choose({ model: state.model }));
  part("copy").addEventListener("click", () => {
    history.replaceState(null, "", addressOf(engine.models, state));
    navigator.clipboard?.writeText(location.href).then(() => (part("status").textContent = "Link copied."), () => {});
  });
  addEventListener("hashchange", () => {
    const asked = stateOf(engine.models, location.hash);
    if (asked && location.hash !== addressOf(engine.models, state)) choose(asked);
  });
  still.addEventListener("change", () => play(!still.matches));

  choose(stateOf(engine.models, location.hash) ?? { model: 0 });
  play(state.plays);
  requestAnimationFrame(frame);
}

start();
