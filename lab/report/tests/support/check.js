// Tells the frame around the page what is wrong with it: run by a test in a copy of the page.
const faults = [];
addEventListener("error", (event) => faults.push(event.message));
addEventListener("load", () => {
  const fault = (text) => faults.push(`${innerWidth} px: ${text}`);
  const width = document.documentElement.scrollWidth;
  if (width > innerWidth) fault(`the page is ${width} px wide`);
  for (const part of document.querySelectorAll("body *")) {
    const { left, right } = part.getBoundingClientRect();
    const isFramed = part.closest(".scroll, svg");
    if (right === left) continue;
    // a table fills its column at most
    const table = part.localName === "table" && !isFramed ? part.parentElement.getBoundingClientRect().right : Infinity;
    if (right > table + 0.5) fault("a table leaves its column");
    if (!isFramed && (left < 0 || right > innerWidth + 0.5)) fault(`<${part.localName}> leaves the page`);
  }
  const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
  const figures = [...document.querySelectorAll("figure")];
  const frames = figures.map((figure) => figure.getBoundingClientRect());
  frames.forEach((a, n) => frames.slice(n + 1).forEach((b) => meet(a, b) && fault("figures overlap")));
  for (const svg of document.querySelectorAll("figure svg")) {
    const name = svg.closest("figure").querySelector("figcaption").textContent;
    const frame = svg.getBoundingClientRect();
    const scale = frame.width / svg.viewBox.baseVal.width;
    const visible = [...svg.querySelectorAll("text")].filter((text) => text.getClientRects().length > 0);
    const texts = visible.map((text) => {
      const box = text.getBoundingClientRect();
      const size = scale * parseFloat(getComputedStyle(text).fontSize);
      if (size < 10) fault(`${name}: "${text.textContent.trim()}" is ${size.toFixed(1)} px high`);
      // letters do not fill their line
      const room = box.height / 8;
      return { text: text.textContent.trim(), left: box.left, right: box.right, top: box.top + room, bottom: box.bottom - room };
    });
    for (const [n, one] of texts.entries()) {
      const isInside = one.left >= frame.left && one.right <= frame.right && one.top >= frame.top && one.bottom <= frame.bottom;
      if (!isInside) fault(`${name}: "${one.text}" leaves its drawing`);
      for (const other of texts.slice(n + 1)) if (meet(one, other)) fault(`${name}: "${one.text}" meets "${other.text}"`);
    }
  }
  // a table that is wider than its place says so, and wherever it comes to rest its edges cut no text
  for (const scroller of document.querySelectorAll(".scroll")) {
    const name = scroller.closest("section").id;
    const hint = scroller.parentElement.querySelector(".hint");
    const isWide = scroller.scrollWidth > scroller.clientWidth + 1;
    if (isWide !== hint.getClientRects().length > 0) fault(`${name}: a table ${isWide ? "scrolls and does not say so" : "says that it scrolls"}`);
    if (!isWide || !hint.getClientRects().length) continue;
    const cells = [...scroller.querySelectorAll("thead th, td")];
    const pinned = cells.find((cell) => getComputedStyle(cell).position === "sticky");
    for (const head of scroller.querySelectorAll("thead th:not(:first-child)")) {
      scroller.scrollLeft = head.offsetLeft - pinned.offsetWidth;
      const edge = { left: pinned.getBoundingClientRect().right, right: scroller.getBoundingClientRect().right };
      for (const cell of cells.filter((cell) => cell.textContent && getComputedStyle(cell).position !== "sticky")) {
        const range = document.createRange();
        range.selectNodeContents(cell);
        const { left, right } = range.getBoundingClientRect();
        const isCut = (x) => left < x - 0.5 && x + 0.5 < right;
        if (isCut(edge.left) || isCut(edge.right)) fault(`${name}: the edge of a table cuts "${cell.textContent}"`);
      }
    }
    scroller.scrollLeft = 0;
  }
  parent.postMessage({ width: innerWidth, figures: figures.length, faults }, "*");
});
