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

/** Makes a slider of each field; `onChange(index, value)` hears where one goes. */
function makeSliders(host, sliders, values, onChange) {
  host.replaceChildren(...sliders.map((slider, index) => {
    const { label, unit, min, max, step } = slider;
    const id = `field-${index}`;
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const input = Object.assign(document.createElement("input"), { type: "range", id, min, max, step });
    const output = Object.assign(document.createElement("output"), { htmlFor: id, ariaLive: "off" });
    const tell = () => {
      const text = `${input.valueAsNumber.toFixed(decimals)} ${unit}`;
      output.textContent = text;
      input.setAttribute("aria-valuetext", text);
    };
    input.value = values[index];
    tell();
    input.addEventListener("input", () => {
      tell();
      onChange(index, input.valueAsNumber);
    });
    const name = element("label", [label]);
    name.htmlFor = id;
    const field = element("div", [name, output, input]);
    field.className = "field";
    return field;
  }));
}
