// Sliders, and choices of one of several.
"use strict";

/** Fills a fieldset with choices; `onChoice` hears the index. Names that change keep their place and the focus. */
class Choice {
  constructor(fieldset, onChoice) {
    [this.fieldset, this.onChoice, this.inputs] = [fieldset, onChoice, []];
  }

  show(names, chosen) {
    while (this.inputs.length > names.length) this.inputs.pop().parentElement.remove();
    names.forEach((name, k) => {
      const input = this.inputs[k] ?? this.add(k);
      const words = input.nextElementSibling;
      if (words.textContent !== name) words.textContent = name;
      if (input.checked !== (k === chosen)) input.checked = k === chosen;
    });
  }

  add(index) {
    const input = Object.assign(document.createElement("input"), { type: "radio", name: this.fieldset.id });
    input.addEventListener("change", () => this.onChoice(index));
    this.fieldset.append(element("label", [input, document.createElement("span")]));
    this.inputs.push(input);
    return input;
  }
}

/** The decimals that a step has. */
const decimalsOf = (step) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

/** Makes a slider of each field, with a box in which its value is typed; `onChange(index, value)` hears where one goes. */
function makeSliders(host, sliders, values, onChange) {
  host.replaceChildren(...sliders.map((slider, index) => {
    const { label, unit, min, max, step } = slider;
    const id = `field-${index}`;
    const input = Object.assign(document.createElement("input"), { type: "range", id, min, max, step });
    const box = Object.assign(document.createElement("input"), { type: "number", min, max, step: "any", ariaLabel: `${label} [${unit}]` });
    // a typed value may have more digits than the steps of the slider
    const tell = (value) => {
      const text = +value.toFixed(decimalsOf(step)) === value ? value.toFixed(decimalsOf(step)) : String(value);
      box.value = text;
      input.setAttribute("aria-valuetext", `${text} ${unit}`);
    };
    let own = values[index];
    const take = (value) => {
      own = value;
      tell(value);
      onChange(index, value);
    };
    input.value = own;
    tell(own);
    input.addEventListener("input", () => take(input.valueAsNumber));
    box.addEventListener("change", () => {
      const typed = box.valueAsNumber;
      if (!Number.isFinite(typed)) return tell(own);
      const value = Math.min(Math.max(typed, min), max);
      input.value = value;
      take(value);
    });
    const name = element("label", [label]);
    name.htmlFor = id;
    const value = element("span", [box, ` ${unit}`]);
    value.className = "value";
    const field = element("div", [name, value, input]);
    field.className = "field";
    return field;
  }));
}
