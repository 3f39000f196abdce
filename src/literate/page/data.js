// SPDX-License-Identifier: GPL-3.0-or-later
// The data at hand: below each figure and table its data and script, to copy and to save, and the line of code that
// registered it. All of it is in the page.

lit.part(function data() {
  for (const shown of document.querySelectorAll("main :is(img[data-drawing], table[data-table])")) {
    const isFigure = shown.dataset.drawing !== undefined;
    const name = isFigure ? shown.dataset.drawing : shown.dataset.table;
    const facts = (isFigure ? lit.facts.figures : lit.facts.tables)[name];
    if (!facts) continue;
    const files = [...facts.data, ...(facts.script ? [facts.script] : []),
                   ...(isFigure && lit.facts.style ? [lit.facts.style] : [])];
    const lines = files.map((file) => lit.make("li", {}, lit.make("span", {}, lit.make("code", {}, file.name)),
      lit.button(file.name.endsWith(".csv") ? "Copy as CSV" : "Copy", (event) => lit.clip(file.text, event.currentTarget),
                 {"aria-label": `Copy ${file.name}`}),
      lit.button("Save", () => lit.save(file.name, file.text), {"aria-label": `Save ${file.name}`})));
    lines.push(lit.make("li", {}, lit.make("span", {}, "registered at ", lit.place(facts.place))));
    const box = lit.make("details", {class: "lit-data"},
      lit.make("summary", {}, isFigure ? "Data and script" : "Data", lit.make("span", {class: "lit-said"}, ` of ${isFigure ? "figure" : "table"} ${name}`)),
      lit.make("ul", {}, lines));
    const figure = shown.closest("figure");
    if (figure) figure.append(box);
    else (shown.closest(".lit-scroll, .lit-pointed") || shown).after(box);
  }
});
