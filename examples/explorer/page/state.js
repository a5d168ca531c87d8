// What is shown, as the part of the address behind `#`: who opens a copied address sees the same.
"use strict";

/** What the address calls a model: the first word of its name. */
const slug = ({ name }) => name.toLowerCase().split(" ")[0];

/** The address of a model at values of its sliders, with one of its modes. */
const addressOf = (models, { model, values, mode }) => `#${slug(models[model])}=${values.join(",")}&mode=${mode + 1}`;

/** What an address asks for; none where it names no model. Values that are missing or no numbers stand where they do at first. */
function stateOf(models, address) {
  const asked = new URLSearchParams(address.replace(/^#/, ""));
  const model = models.findIndex((model) => asked.has(slug(model)));
  if (model < 0) return undefined;
  const given = asked.get(slug(models[model])).split(",");
  const values = models[model].sliders.map(({ min, max, start }, k) => {
    const value = given[k]?.trim() ? Number(given[k]) : NaN;
    return Number.isFinite(value) ? Math.min(Math.max(value, min), max) : start;
  });
  const mode = Number(asked.get("mode")) - 1;
  return { model, values, mode: Number.isInteger(mode) && mode >= 0 ? mode : 0 };
}
