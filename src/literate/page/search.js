// SPDX-License-Identifier: GPL-3.0-or-later
// Search: every paragraph, item, caption, formula, row and line of code that holds all the words, with its section.

const searched = "main :is(h1, h2, h3, h4, p, li, dt, dd, figcaption, tr, .lit-line)";

/// What is searched: the innermost blocks, each with its words and its section's heading.
function blocksOfPage() {
  return [...document.querySelectorAll(searched)]
    .filter((block) => !block.querySelector(searched.slice("main ".length)) && !block.closest(".lit-card, .lit-data"))
    .map((block) => {
      const heading = block.closest("section")?.querySelector("h1, h2, h3, h4");
      const words = lit.words(block);
      return {block, words, small: words.toLowerCase(), section: heading && heading !== block ? lit.words(heading) : ""};
    }).filter(({words}) => words);
}

/// The words around the first hit, with the hit marked.
function excerptOf(words, wanted) {
  const at = Math.max(0, words.toLowerCase().indexOf(wanted));
  const from = Math.max(0, at - 50);
  const hit = words.slice(at, at + wanted.length);
  return [from > 0 ? "…" : "", words.slice(from, at), lit.make("mark", {}, hit), words.slice(at + hit.length, at + 90)];
}

/// The search box with its list of hits; Tab goes through them, and Enter to the first.
function makeSearch() {
  const mostHits = 40;
  let blocks = null;
  const list = lit.make("ol", {class: "lit-hits", hidden: true, pointerdown: (event) => event.preventDefault()});
  const input = lit.make("input", {type: "search", placeholder: "Search", "aria-label": "Search this page", autocomplete: "off", spellcheck: "false"});

  function go(block) {
    list.hidden = true;
    for (let box = block.closest("details"); box; box = box.parentElement.closest("details")) box.open = true;
    block.classList.add("lit-hit");
    block.tabIndex = -1;
    block.focus({preventScroll: true});
    block.scrollIntoView({block: "center"});
    block.addEventListener("blur", () => {
      block.classList.remove("lit-hit");
      block.removeAttribute("tabindex");
    }, {once: true});
  }
  function search() {
    blocks ??= blocksOfPage();
    const wanted = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    const hits = wanted.join("").length < 2 ? [] : blocks.filter(({small}) => wanted.every((word) => small.includes(word)));
    list.replaceChildren(...hits.slice(0, mostHits).map(({block, words, section}) => lit.make("li", {},
      lit.button([lit.make("span", {class: "lit-where"}, section), excerptOf(words, wanted[0])], () => go(block)))));
    list.hidden = hits.length === 0;
    const more = hits.length > mostHits ? `, the first ${mostHits} shown` : "";
    if (wanted.length > 0) lit.say(hits.length === 0 ? "nothing found" : `${hits.length} places${more}`);
  }
  const box = lit.make("div", {class: "lit-search", role: "search", input: search, keydown: (event) => {
    if (event.key === "Enter" && event.target === input) list.querySelector("button")?.click();
    else if (event.key === "Escape") list.hidden = true;
    else return;
    event.preventDefault();
  }, focusin: (event) => { if (event.target === input && input.value) search(); },
  focusout: (event) => { if (!box.contains(event.relatedTarget)) list.hidden = true; }}, input, list);
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.target.closest?.("input, textarea, select")) return;
    event.preventDefault();
    input.focus();
  });
  return box;
}
