// The page in Chromium: nothing overlaps or leaves its place, nothing is said on the console, sliders are dragged and counted in frames.
//   node page.mjs PAGE CHROMIUM FOLDER        puppeteer-core is taken from the working directory
import { createRequire } from "node:module";
import { join } from "node:path";
import { readFileSync } from "node:fs";
import { setTimeout as passes } from "node:timers/promises";
import { pathToFileURL } from "node:url";

const { default: puppeteer } = await import(pathToFileURL(createRequire(`${process.cwd()}/`).resolve("puppeteer-core")));
const [file, executablePath, folder] = process.argv.slice(2);
const inPage = readFileSync(new URL("in_page.js", import.meta.url), "utf8");
const faults = [];

const browser = await puppeteer.launch({ executablePath, args: ["--no-sandbox"] });
const page = await browser.newPage();
page.on("console", (message) => faults.push(`console: ${message.text()}`));
page.on("pageerror", (error) => faults.push(`error: ${error.message}`));
page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || faults.push(`asks for ${request.url()}`));
await page.evaluateOnNewDocument(inPage);

async function open(width, scheme, motion) {
  await page.setViewport({ width, height: 900 });
  await page.emulateMediaFeatures([
    { name: "prefers-color-scheme", value: scheme },
    { name: "prefers-reduced-motion", value: motion },
  ]);
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector("#results table");
}

const choose = async (model) => {
  await page.evaluate((model) => document.querySelectorAll("#models input")[model].click(), model);
  await passes(3000);
};

/** Looks at both models with every slider at its start and at both ends. */
async function looksAtAll(width, scheme) {
  await open(width, scheme, "no-preference");
  for (const model of [0, 1]) {
    await choose(model);
    await page.screenshot({ path: join(folder, `${["bridge", "portal"][model]}_${width}_${scheme}.png`), fullPage: true });
    const found = await page.evaluate(() => checks.everyEnd());
    faults.push(...found.faults.map((fault) => `${width} px, model ${model}: ${fault}`));
    console.log(`${width} px, ${scheme}, model ${model}: ${found.looks} looks at ${found.texts} texts, ${found.faults.length} faults`);
  }
}

/** How many frames a second this machine draws of a page on which one line moves. */
async function framesOfAnEmptyPage() {
  await page.goto("data:text/html,<div id=line style='height:2px;background:black'></div>");
  const frames = await page.evaluate(async () => {
    const line = document.getElementById("line");
    const end = performance.now() + 3000;
    let frames = 0;
    await new Promise((resolve) => requestAnimationFrame(function frame(now) {
      line.style.width = `${++frames % 100}px`;
      if (now < end) requestAnimationFrame(frame);
      else resolve();
    }));
    return frames;
  });
  console.log(`a page on which one line moves has ${(frames / 3).toFixed(1)} frames a second here`);
}

/** Drags each slider by the mouse, and counts frames and answers. */
async function drags(model) {
  await choose(model);
  const sliders = await page.$$("#fields input[type=range]");
  const counts = { frames: 0, answers: 0, seconds: 0, works: [] };
  for (const slider of sliders) {
    const { x, y, width, height } = await slider.boundingBox();
    const at = (part) => [x + 8 + part * (width - 16), y + height / 2];
    await page.mouse.move(...at(await slider.evaluate(({ valueAsNumber, min, max }) => (valueAsNumber - min) / (max - min))));
    await page.mouse.down();
    await page.evaluate(() => checks.begin());
    const end = performance.now() + 2000;
    for (let step = 0; performance.now() < end; step++) {
      await page.mouse.move(...at(0.5 + 0.45 * Math.sin(step / 25)));
      await passes(4);
    }
    const { frames, answers, seconds, works } = await page.evaluate(() => checks.end());
    await page.mouse.up();
    Object.assign(counts, { frames: counts.frames + frames, answers: counts.answers + answers, seconds: counts.seconds + seconds });
    counts.works.push(...works);
  }
  const works = counts.works.sort((a, b) => a - b);
  const at = (part) => works[Math.floor(part * (works.length - 1))].toFixed(1);
  const rate = (count) => (count / counts.seconds).toFixed(1);
  console.log(`model ${model}, ${sliders.length} sliders dragged for ${counts.seconds.toFixed(1)} s: ${rate(counts.frames)} frames a second,`
    + ` ${rate(counts.answers)} of them with a new answer; scripts take ${at(0.5)} ms of a frame, nine of ten below ${at(0.9)} ms`);
  if (counts.answers < counts.frames / 4) faults.push(`model ${model}: ${counts.answers} answers in ${counts.frames} frames while dragging`);
}

/** An arrow key moves a slider by a step, and all that follows from it. */
async function keys() {
  const told = () => page.evaluate(() => [...document.querySelectorAll("#fields .value input, #results td")].map((part) => part.value ?? part.textContent).join());
  const before = await told();
  await page.focus("#field-1");
  await page.keyboard.press("ArrowRight");
  await passes(1000);
  if ((await told()) === before) faults.push("an arrow key changes nothing");
  await page.focus("#models input:checked");
  await page.keyboard.press("ArrowRight");
  await passes(1000);
  if (!(await page.$eval("#models input:last-of-type", () => document.querySelectorAll("#models input")[1].checked))) faults.push("models cannot be chosen by keys");
  console.log("keys move sliders and choose models");
}

/** What the page shows of a model: choice, values, results, curves. */
const shown = () => page.evaluate(() => ({
  model: [...document.querySelectorAll("#models input")].findIndex(({ checked }) => checked),
  mode: [...document.querySelectorAll("#modes input")].findIndex(({ checked }) => checked),
  values: [...document.querySelectorAll("#fields input[type=number]")].map(({ value }) => value),
  sliders: [...document.querySelectorAll("#fields input[type=range]")].map(({ value }) => value),
  results: [...document.querySelectorAll("#results td")].map(({ textContent }) => textContent),
  curve: document.querySelector("#response .curve").getAttribute("d"),
}));

/** A value that is typed is taken, within the ends of its slider; what is no number is not. */
async function types() {
  await choose(0);
  const type = async (text) => {
    await page.click("#fields .field:nth-child(5) input[type=number]", { clickCount: 3 });
    await page.keyboard.type(text);
    await page.keyboard.press("Enter");
    await passes(1000);
    return shown();
  };
  const before = await shown();
  const typed = await type("24.137");
  if (typed.values[4] !== "24.137" || typed.results.join() === before.results.join()) faults.push(`a typed value is shown as ${typed.values[4]}`);
  const beyond = await type("1000");
  if (beyond.values[4] !== "36.0" || beyond.sliders[4] !== "36") faults.push(`a value beyond its slider is ${beyond.values[4]}`);
  const none = await type("e");
  if (none.values[4] !== "36.0") faults.push(`what is no number is ${none.values[4]}`);
  console.log("typed values are taken, within the ends of their sliders");
}

/** An address that is copied shows the same to who opens it; an odd one shows what can be shown of it. */
async function shares() {
  await choose(1);
  await page.$$eval("#fields input[type=range]", (sliders) => sliders.forEach((slider, k) => {
    slider.value = Number(slider.min) + (0.2 + 0.1 * k) * (slider.max - slider.min);
    slider.dispatchEvent(new Event("input"));
  }));
  await page.$eval("#fields .field:first-child input[type=number]", (box) => {
    box.value = 3.2143;
    box.dispatchEvent(new Event("change"));
  });
  await passes(500);
  await page.$$eval("#modes input", (modes) => modes[2].click());
  await passes(1500);
  const [address, own] = [await page.evaluate(() => location.href), await shown()];
  const opened = async (address) => {
    await page.goto("about:blank");
    await page.goto(address);
    await page.waitForSelector("#results table");
    await passes(1500);
    return shown();
  };
  const same = await opened(address);
  for (const key of Object.keys(own)) {
    if (JSON.stringify(same[key]) !== JSON.stringify(own[key])) faults.push(`a copied address shows another ${key}: ${same[key]} and not ${own[key]}`);
  }
  const odd = await opened(address.replace(/#.*/, "#portal=abc,1e9,,-5&mode=77"));
  if (odd.model !== 1 || odd.values.join() !== "4.00,95.0,3.00,0,1.00") faults.push(`an odd address shows ${odd.model}: ${odd.values}`);
  const none = await opened(address.replace(/#.*/, "#tower=1"));
  if (none.model !== 0) faults.push("an address of no model shows another than the first");
  // an address that changes while the page is open
  await page.evaluate((hash) => (location.hash = hash), address.replace(/.*#/, "#"));
  await passes(1500);
  if ((await shown()).results.join() !== own.results.join()) faults.push("an address that changes shows nothing new");
  console.log(`a copied address shows the same: ${address.replace(/.*#/, "#")}`);
}

/** Curves have a point for each pixel, more of them at peaks, and no leap across a peak of what is not damped. */
async function curves() {
  for (const model of [0, 1]) {
    await choose(model);
    const { points, width, ends } = await page.evaluate(() => {
      const svg = document.querySelector("#response svg");
      const d = svg.querySelector(".curve").getAttribute("d");
      const frame = svg.querySelector("rect.axis");
      const number = (name) => Number(frame.getAttribute(name));
      return {
        points: d.split(/[ML]/).slice(1).map((pair) => pair.split(" ").map(Number)),
        width: number("width"),
        ends: [number("y"), number("y") + number("height")],
      };
    });
    const steps = points.slice(1).map(([x, y], k) => [x - points[k][0], Math.abs(y - points[k][1])]);
    const widest = Math.max(...steps.map(([x]) => x));
    if (!(points.length > width && widest < 1.3)) faults.push(`model ${model}: ${points.length} points on ${width} px, ${widest} px apart`);
    if (steps.some(([x]) => x < 0)) faults.push(`model ${model}: the curve goes back`);
    const top = Math.min(...points.map(([, y]) => y));
    const at = points.findIndex(([, y]) => y === top);
    const near = points.filter(([x]) => Math.abs(x - points[at][0]) < 1).length;
    if (near < 6) faults.push(`model ${model}: ${near} points within a pixel of a peak`);
    // upwards to a peak and down again, never from the top to the bottom at once
    const leaps = steps.filter(([, y]) => y > 0.6 * (ends[1] - ends[0])).length;
    if (leaps > 0) faults.push(`model ${model}: ${leaps} bars`);
    console.log(`model ${model}: ${points.length} points on ${width} px, ${near} of them within a pixel of the highest peak`);
  }
}

/** Under the pointer charts say their values, and nothing where it has left. */
async function reads() {
  for (const [model, chart] of [[0, "response"], [1, "response"], [1, "roots"]]) {
    await choose(model);
    const canvas = await page.$(`#${chart} .canvas`);
    await canvas.scrollIntoView();
    const { x, y, width, height } = await canvas.boundingBox();
    const reading = () => page.$eval(`#${chart} svg`, (svg) => svg.querySelector(".reading")?.textContent);
    const at = async (part, level) => {
      await page.mouse.move(x + 58 + part * (width - 74), y + 16 + level * (height - 60));
      await passes(200);
      return reading();
    };
    const texts = [];
    for (const part of [0.2, 0.5, 0.8]) texts.push(await at(part, 0.5));
    if (chart === "response" && !texts.every((text) => /^[\d.]+ Hz: [\d.e−]+ mm\/kN/.test(text ?? ""))) faults.push(`${chart}: reads ${texts}`);
    if (chart === "response" && new Set(texts).size < 3) faults.push(`${chart}: reads the same everywhere`);
    if (chart === "roots") {
      const { cx, cy } = await page.$eval("#roots circle.root", (root) => ({ cx: +root.getAttribute("cx"), cy: +root.getAttribute("cy") }));
      await page.mouse.move(x + cx, y + cy);
      await passes(200);
      if (!/ Hz$/.test((await reading()) ?? "")) faults.push(`roots: read ${await reading()}`);
    }
    faults.push(...(await page.evaluate(() => checks.faultsNow())).map((fault) => `under the pointer: ${fault}`));
    await page.mouse.move(x + 5, y - 40);
    await passes(200);
    if (await reading()) faults.push(`${chart}: reads where there is no pointer`);
  }
  console.log("charts say what is under the pointer");
}

/** Whether the drawing moves by itself. */
async function moves() {
  const drawn = () => page.$eval("#motion .beam", (beam) => beam.getAttribute("d"));
  const first = await drawn();
  await passes(700);
  return (await drawn()) !== first;
}

for (const [width, scheme] of [[1280, "light"], [1280, "dark"], [400, "light"], [400, "dark"]]) await looksAtAll(width, scheme);
await framesOfAnEmptyPage();
await open(1280, "light", "no-preference");
if (!(await moves())) faults.push("nothing moves");
for (const model of [0, 1]) await drags(model);
await choose(0);
await keys();
await types();
await curves();
await reads();
await shares();
await open(1280, "light", "reduce");
await passes(3000);
if (await moves()) faults.push("moves where reduced motion is preferred");
console.log("where reduced motion is preferred, shapes stand still");
await browser.close();

faults.forEach((fault) => console.error(fault));
process.exitCode = faults.length > 0 ? 1 : 0;
