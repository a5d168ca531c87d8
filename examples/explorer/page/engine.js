// The model in WebAssembly: values of sliders in, tables of numbers out. Names of tables and columns come from there.
"use strict";

/** A running model, given the bytes of its module. */
async function startEngine(bytes) {
  const { instance } = await WebAssembly.instantiate(bytes, {});
  const wasm = instance.exports;
  const text = (length) => new TextDecoder().decode(new Uint8Array(wasm.memory.buffer, wasm.text(), length));
  const { models, kinds, tables } = JSON.parse(text(wasm.description()));

  /** Rows of a table by its columns; the memory is read at once, since the next answer overwrites it. */
  function rows(index) {
    const { columns } = tables[index];
    const numbers = new Float64Array(wasm.memory.buffer, wasm.table(index), wasm.table_length(index));
    return Array.from({ length: numbers.length / columns.length }, (_, row) =>
      Object.fromEntries(columns.map((column, k) => [column, numbers[row * columns.length + k]])));
  }

  function answer(question, model, values) {
    wasm.clear();
    values.forEach((value) => wasm.push(value));
    const problem = question(model);
    if (problem > 0) return { problem: text(problem) };
    return Object.fromEntries(tables.map(({ name }, index) => [name, rows(index)]));
  }

  return {
    models,
    kinds,
    /** All that there is to show of a model at values of its sliders, or the problem that it meets. */
    show: (model, values) => answer(wasm.show, model, values),
    /** The roots alone. */
    showRoots: (model, values) => answer(wasm.show_roots, model, values),
  };
}
