// SPDX-License-Identifier: GPL-3.0-or-later
// The data at hand: below each figure and table its data and script, to copy and to save, and the line of code that made it.
// All of it is in the page. Code can be copied too, without its line numbers, which the style draws.

/// A line of buttons for one file; its address is made when the list is opened.
function fileLine(file) {
  const address = URL.createObjectURL(new Blob([file.text], {type: "text/plain;charset=utf-8"}));
  return lit.make("li", {}, lit.make("span", {}, lit.make("code", {}, file.name)),
    lit.button("Copy", (event) => lit.clip(file.text, event.currentTarget), {"aria-label": `Copy ${file.name}`}),
    lit.make("a", {href: address, download: file.name, "aria-label": `Save ${file.name}`}, "Save"));
}

/// Two of one figure stand below their own drawing or table, and say of which they are.
lit.part(function data() {
  for (const shown of document.querySelectorAll("main :is(img[data-drawing], table[data-table])")) {
    const {drawing, table} = shown.dataset;
    if (drawing !== undefined) {
      const drawn = lit.make("div", {class: "lit-drawn"});
      shown.replaceWith(drawn);
      drawn.append(shown);
    }
    const facts = drawing === undefined ? lit.facts.tables[table] : lit.facts.figures[drawing];
    if (!facts) continue;
    const files = [...facts.data, facts.script, drawing !== undefined && lit.facts.style].filter(Boolean);
    const figure = shown.closest("figure");
    const beside = [...(figure || shown.parentNode).querySelectorAll("[data-drawing], [data-table]")];
    const alike = beside.filter(({tagName}) => tagName === shown.tagName);
    const kind = drawing === undefined ? "table" : "drawing";
    const which = alike.length > 1 ? ` of ${kind} ${alike.indexOf(shown) + 1}` : "";
    const list = lit.make("ul", {});
    const box = lit.make("details", {class: "lit-data", toggle: () => {
      if (!list.firstChild) list.append(...files.map(fileLine), lit.make("li", {}, lit.make("span", {}, "made by ", lit.make("code", {}, facts.place))));
    }}, lit.make("summary", {}, (drawing === undefined ? "Data" : "Data and script") + which,
                 which ? "" : lit.make("span", {class: "lit-said"}, ` of ${drawing === undefined ? "table" : "figure"} ${drawing ?? table}`)), list);
    if (figure && beside.length < 2) figure.append(box);
    else if (drawing === undefined) (shown.closest(".lit-scroll") || shown).after(box);
    else shown.parentNode.append(box);
  }

  for (const code of document.querySelectorAll("main pre")) {
    const copied = code.closest("[data-listing]")?.dataset.listing || "the entry for BibTeX";
    if (!code.closest("[data-listing], .lit-cite-page")) continue;
    code.before(lit.make("div", {class: "lit-listing-bar"},
      lit.button("Copy", (event) => lit.clip(code.textContent.replace(/\n*$/, "\n"), event.currentTarget), {"aria-label": `Copy ${copied}`})));
  }
});
