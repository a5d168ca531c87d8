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
  const sliders = await page.$$("#fields input");
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
  const told = () => page.evaluate(() => [...document.querySelectorAll("#fields output, #results td")].map((part) => part.textContent).join());
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
await open(1280, "light", "reduce");
await passes(3000);
if (await moves()) faults.push("moves where reduced motion is preferred");
console.log("where reduced motion is preferred, shapes stand still");
await browser.close();

faults.forEach((fault) => console.error(fault));
process.exitCode = faults.length > 0 ? 1 : 0;
