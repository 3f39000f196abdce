// SPDX-License-Identifier: GPL-3.0-or-later
// Listings: long ones are folded, each can be copied without its line numbers.

/// The text of a listing as the file has it; line numbers are drawn by the style.
function codeOf(listing) {
  return listing.querySelector("pre").textContent.replace(/\n*$/, "\n");
}

lit.part(function listings() {
  const mostLines = 24;
  let n = 0;
  for (const pre of document.querySelectorAll(".lit-cite-page pre")) {
    pre.before(lit.make("div", {class: "lit-listing-bar"},
      lit.button("Copy", (event) => lit.clip(pre.textContent, event.currentTarget), {"aria-label": "Copy the entry for BibTeX"})));
  }
  for (const listing of document.querySelectorAll("[data-listing]")) {
    const box = listing.querySelector("pre");
    if (!box) continue;
    const nLines = codeOf(listing).split("\n").length - 1;
    const file = listing.dataset.listing;
    const bar = lit.make("div", {class: "lit-listing-bar"},
      lit.button("Copy", (event) => lit.clip(codeOf(listing), event.currentTarget), {"aria-label": `Copy ${file}`}));
    box.before(bar);
    if (nLines <= mostLines) continue;
    if (!box.id) box.id = `lit-listing-${++n}`;
    const fold = lit.button("", () => setFolded(!box.classList.contains("lit-folded")), {"aria-controls": box.id});
    const setFolded = (isFolded) => {
      box.classList.toggle("lit-folded", isFolded);
      fold.textContent = isFolded ? `Show all ${nLines} lines` : "Fold";
      fold.setAttribute("aria-expanded", String(!isFolded));
    };
    bar.prepend(fold);
    setFolded(true);
    // Whoever comes to a line of it, by a link, a search or the Tab key, sees the line.
    const unfold = () => setFolded(false);
    box.addEventListener("lit-show", unfold);
    box.addEventListener("focusin", unfold);
  }

  function arrive() {
    const target = lit.target({getAttribute: () => location.hash});
    lit.reveal(target);
  }
  addEventListener("hashchange", arrive);
  arrive();
});

/// Unfolds what hides an element.
lit.reveal = (element) => {
  const folded = element?.closest(".lit-folded");
  if (!folded) return;
  folded.dispatchEvent(new Event("lit-show"));
  element.scrollIntoView();
};
