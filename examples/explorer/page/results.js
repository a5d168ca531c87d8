// Tables of certified roots.
"use strict";

/** What two numbers have in common of their digits, and what follows in each. */
function interval(lower, upper) {
  const [low, high] = [lower.toPrecision(17), upper.toPrecision(17)];
  let same = 0;
  while (same < low.length && low[same] === high[same]) same++;
  return [low.slice(0, same), low.slice(same), high.slice(same)];
}

function element(tag, children) {
  const made = document.createElement(tag);
  made.append(...children);
  return made;
}

function table(title, about, head, rows) {
  const row = (tag) => (cells) => element("tr", cells.map((cell) => element(tag, [].concat(cell))));
  const scroll = element("div", [element("table", [element("thead", [row("th")(head)]), element("tbody", rows.map(row("td")))])]);
  scroll.className = "scroll";
  scroll.tabIndex = 0;
  scroll.setAttribute("role", "region");
  scroll.setAttribute("aria-label", title);
  const note = element("p", [about]);
  note.className = "note";
  return element("div", [element("h2", [title]), scroll, note]);
}

/** A frequency, with the number of roots that lie there, if there are several. */
const named = (omega, multiplicity) => `${readable(omega * HERTZ, 6)}${multiplicity > 1 ? ` × ${multiplicity}` : ""}`;

/** Shows the roots of an answer; tables change only as fast as they can be read. */
function showResults(section, { frequencies, eigenvalues }) {
  const tables = [];
  if (eigenvalues.length > 0) {
    const rows = eigenvalues.map(({ re, im, error, ratio, multiplicity }) => [
      named(im, multiplicity), `${readable(100 * ratio, 4)} %`, [`${re.toFixed(13).replace("-", "−")} `, element("span", [`+ ${im.toFixed(13)} i`])],
      readable(error, 2),
    ]);
    tables.push(table("Eigenvalues", "The eigenvalue is no farther from λ than the radius says, and no other one is in that circle: they are counted along its edge.",
      ["f [Hz]", "damping", "λ [1/s]", "radius"], rows));
  }
  const rows = frequencies.map(({ omega, lower, upper, multiplicity }) => {
    const [same, low, high] = interval(lower, upper);
    return [named(omega, multiplicity), [same, element("em", [`${low} to ${high}`])], readable((upper - lower) / omega, 2)];
  });
  const title = eigenvalues.length > 0 ? "Natural frequencies without any damping" : "Natural frequencies";
  tables.push(table(title, "Each lies between two numbers with the coloured digits at their ends: counts say that one more frequency is below the second than below the first.",
    ["f [Hz]", "ω [rad/s]", "width / ω"], rows));
  section.replaceChildren(...tables);
}
