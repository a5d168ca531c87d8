// Put into the page before its scripts: what overlaps, and how long its frames take.
"use strict";

const checks = (() => {
  let [frames, answers, began, works] = [0, 0, 0, []];
  const own = requestAnimationFrame;
  window.requestAnimationFrame = (callback) => own((now) => {
    const start = performance.now();
    callback(now);
    works.push(performance.now() - start);
    frames++;
  });
  // each answer is read from memory once
  const { instantiate } = WebAssembly;
  WebAssembly.instantiate = async (...given) => {
    const { instance } = await instantiate(...given);
    const exports = { ...instance.exports, show: (model) => (answers++, instance.exports.show(model)) };
    return { instance: { exports } };
  };

  const begin = () => ([frames, answers, began, works] = [0, 0, performance.now(), []]);
  const end = () => ({ frames, answers, seconds: (performance.now() - began) / 1e3, works });
  const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

  /** What is wrong with the page as it stands. */
  function faultsNow() {
    const faults = [];
    const width = document.documentElement.scrollWidth;
    if (width > innerWidth) faults.push(`the page is ${width} px wide`);
    for (const part of document.querySelectorAll("body *:not(script, .hidden)")) {
      const { left, right } = part.getBoundingClientRect();
      if (!part.closest("svg") && (left < -0.5 || right > innerWidth + 0.5)) faults.push(`<${part.localName}> leaves the page`);
    }
    for (const scroll of document.querySelectorAll(".scroll")) {
      if (scroll.scrollWidth > scroll.clientWidth) faults.push(`a table is ${scroll.scrollWidth} px wide in ${scroll.clientWidth}`);
    }
    const parts = [...document.querySelectorAll("figure, form, section > div")].map((part) => part.getBoundingClientRect());
    parts.forEach((a, n) => parts.slice(n + 1).forEach((b) => meet(a, b) && faults.push("parts of the page overlap")));
    for (const svg of document.querySelectorAll("svg")) faults.push(...faultsOf(svg));
    return faults;
  }

  function faultsOf(svg) {
    const faults = [];
    const frame = svg.getBoundingClientRect();
    const name = svg.closest("figure").id;
    const texts = [...svg.querySelectorAll("text")].map((text) => {
      const { left, right, top, bottom, height } = text.getBoundingClientRect();
      // letters do not fill their line
      return { text: text.textContent, left, right, top: top + height / 8, bottom: bottom - height / 8 };
    });
    const isInside = (a) => a.left >= frame.left && a.right <= frame.right && a.top >= frame.top && a.bottom <= frame.bottom;
    texts.forEach((one, n) => {
      if (!isInside(one)) faults.push(`${name}: "${one.text}" leaves its drawing`);
      for (const other of texts.slice(n + 1)) if (meet(one, other)) faults.push(`${name}: "${one.text}" meets "${other.text}"`);
    });
    for (const shape of svg.querySelectorAll(".beam, .mass, .support, circle")) {
      if (!isInside(shape.getBoundingClientRect())) faults.push(`${name}: <${shape.localName} class="${shape.getAttribute("class")}"> leaves its drawing`);
    }
    return faults;
  }

  const frame = () => new Promise((resolve) => own(() => own(resolve)));

  /** The faults with each slider at its start and at both ends, the others at their start. */
  async function everyEnd() {
    const faults = new Set();
    let [looks, texts] = [0, 0];
    for (const slider of document.querySelectorAll("#fields input[type=range]")) {
      const start = slider.value;
      for (const value of [slider.min, slider.max, start]) {
        slider.value = value;
        slider.dispatchEvent(new Event("input"));
        for (let k = 0; k < 12; k++) await frame();
        const problem = document.getElementById("problem");
        if (!problem.hidden) faults.add(`${slider.getAttribute("aria-valuetext")}: ${problem.textContent}`);
        faultsNow().forEach((fault) => faults.add(`${slider.getAttribute("aria-valuetext")}: ${fault}`));
        looks++;
        texts += document.querySelectorAll("svg text").length;
      }
    }
    return { faults: [...faults], looks, texts };
  }

  return { begin, end, everyEnd, faultsNow };
})();
