// SPDX-License-Identifier: GPL-3.0-or-later
// The contents beside the text: they show where one is, and open the part that one reads.

lit.part(function contents() {
  const nav = document.getElementById("contents");
  if (!nav) return;
  if (!nav.hasAttribute("aria-label")) nav.setAttribute("aria-label", "Contents");
  const places = [...nav.querySelectorAll("a[href^='#']")].map((link) => ({link, target: lit.target(link)}))
    .filter(({target}) => target);
  // In a list of one level the subsections follow their section.
  const items = [...nav.querySelectorAll("li")];
  const isSub = (item) => item.classList.contains("lit-toc-subsection");
  function familyOf(item) {
    const family = [];
    for (let above = item; above; above = above.parentElement.closest("li")) family.push(above);
    let first = items.indexOf(item);
    while (first > 0 && isSub(items[first])) --first;
    for (let i = first + 1; i < items.length && isSub(items[i]); ++i) family.push(items[i]);
    return family;
  }
  let here = null;

  function mark(place) {
    if (place === here) return;
    here = place;
    for (const {link} of places) link.removeAttribute("aria-current");
    for (const item of nav.querySelectorAll("li[data-here]")) item.removeAttribute("data-here");
    if (!place) return;
    place.link.setAttribute("aria-current", "true");
    for (const item of familyOf(place.link.closest("li"))) item.dataset.here = "";
    const top = place.link.offsetTop - nav.offsetTop;
    if (top < nav.scrollTop || top > nav.scrollTop + nav.clientHeight - 60) nav.scrollTop = top - nav.clientHeight / 3;
  }

  // The last heading above a third of the window.
  function look() {
    let last = null;
    for (const place of places) {
      if (place.target.getBoundingClientRect().top > innerHeight / 3) break;
      last = place;
    }
    mark(last);
  }
  let asked = false;
  addEventListener("scroll", () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      look();
    });
  }, {passive: true});
  look();
  nav.addEventListener("click", (event) => {
    if (event.target.closest("a")) document.documentElement.classList.remove("lit-contents-open");
  });
});
