// SPDX-License-Identifier: GPL-3.0-or-later
// Search: every paragraph, item, caption, formula, row and listing that holds all the words, with its section.

const searched = "main :is(h1, h2, h3, h4, p, li, dt, dd, figcaption, tr, .lit-line)";

/// What is searched: the innermost blocks, each with its words and its section's heading.
function blocksOfPage() {
  const all = [...document.querySelectorAll(searched)].filter((block) => !block.closest(".lit-card, .lit-tools, .lit-data, .lit-filter"));
  const outer = new Set();
  for (const block of all) {
    for (let above = block.parentElement?.closest(searched); above; above = above.parentElement?.closest(searched)) outer.add(above);
  }
  return all.filter((block) => !outer.has(block)).map((block) => {
    const heading = block.closest("section")?.querySelector("h1, h2, h3, h4");
    const words = lit.words(block);
    return {block, words, small: words.toLowerCase(), section: heading && heading !== block ? lit.words(heading) : ""};
  }).filter(({words}) => words);
}

/// The words around the first hit, with the hit marked.
function excerptOf(words, wanted) {
  const at = Math.max(0, words.toLowerCase().indexOf(wanted[0]));
  const from = Math.max(0, at - 50);
  const hit = words.slice(at, at + wanted[0].length);
  return [from > 0 ? "…" : "", words.slice(from, at), lit.make("mark", {}, hit), words.slice(at + hit.length, at + 90)];
}

/// The search box with its list of hits.
function makeSearch() {
  const mostHits = 40;
  let blocks = null, hits = [], at = -1;
  const list = lit.make("ul", {class: "lit-hits", id: "lit-hits", role: "listbox", "aria-label": "Places found", hidden: true});
  const input = lit.make("input", {type: "search", placeholder: "Search", "aria-label": "Search this page", role: "combobox",
    "aria-expanded": "false", "aria-controls": "lit-hits", "aria-autocomplete": "list", autocomplete: "off", spellcheck: "false"});

  function close() {
    list.hidden = true;
    input.setAttribute("aria-expanded", "false");
    input.removeAttribute("aria-activedescendant");
  }
  function choose(i) {
    at = i;
    [...list.children].forEach((item, k) => item.setAttribute("aria-selected", String(k === i)));
    list.children[i]?.scrollIntoView({block: "nearest"});
    if (list.children[i]?.id) input.setAttribute("aria-activedescendant", list.children[i].id);
  }
  function go(i) {
    const hit = hits[i];
    if (!hit) return;
    close();
    for (const former of document.querySelectorAll(".lit-hit")) former.classList.remove("lit-hit");
    lit.reveal(hit.block);
    const filtered = hit.block.closest(".lit-ledger-entry[hidden]");
    if (filtered) location.hash = filtered.id;
    for (let box = hit.block.closest("details"); box; box = box.parentElement.closest("details")) box.open = true;
    hit.block.classList.add("lit-hit");
    hit.block.tabIndex = -1;
    hit.block.focus({preventScroll: true});
    hit.block.scrollIntoView({block: "center"});
    hit.block.addEventListener("blur", () => {
      hit.block.classList.remove("lit-hit");
      hit.block.removeAttribute("tabindex");
    }, {once: true});
  }
  function search() {
    blocks ??= blocksOfPage();
    const wanted = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    hits = wanted.join("").length < 2 ? [] : blocks.filter(({small}) => wanted.every((word) => small.includes(word)));
    const more = hits.length - mostHits;
    hits = hits.slice(0, mostHits);
    list.replaceChildren(...hits.map(({words, section}, i) => lit.make("li", {id: `lit-hit-${i}`, role: "option", "aria-selected": "false",
      pointerdown: (event) => event.preventDefault(), click: () => go(i)}, lit.make("span", {class: "lit-where"}, section), excerptOf(words, wanted))));
    const isOpen = wanted.length > 0;
    list.hidden = hits.length === 0;
    input.setAttribute("aria-expanded", String(!list.hidden));
    if (hits.length > 0) choose(0);
    if (isOpen) lit.say(hits.length === 0 ? "nothing found" : more > 0 ? `${hits.length + more} places, the first ${mostHits} shown` : `${hits.length} places`);
  }
  input.addEventListener("input", search);
  input.addEventListener("focus", () => { if (input.value) search(); });
  input.addEventListener("blur", close);
  input.addEventListener("keydown", (event) => {
    const step = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (step && hits.length > 0) choose((at + step + hits.length) % hits.length);
    else if (event.key === "Enter") go(at);
    else if (event.key === "Escape" && !list.hidden) close();
    else return;
    event.preventDefault();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.target.closest?.("input, textarea, select")) return;
    event.preventDefault();
    input.focus();
  });
  return lit.make("div", {class: "lit-search", role: "search"}, input, list);
}
