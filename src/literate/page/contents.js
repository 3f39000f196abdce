// SPDX-License-Identifier: GPL-3.0-or-later
// The contents beside the text show where one is; the style opens the part that one reads.

lit.part(function contents() {
  const nav = document.getElementById("contents");
  if (!nav) return;
  const places = [...nav.querySelectorAll("a[href^='#']")].map((link) => ({link, target: lit.target(link)}))
    .filter(({target}) => target);
  let here = null;

  // The last heading above a third of the window.
  function look() {
    const last = places.findLast(({target}) => target.getBoundingClientRect().top <= innerHeight / 3)?.link;
    if (last === here) return;
    here?.removeAttribute("aria-current");
    here = last;
    here?.setAttribute("aria-current", "true");
    const top = here ? here.getBoundingClientRect().top - nav.getBoundingClientRect().top : 0;
    if (here && (top < 0 || top > nav.clientHeight - 60)) nav.scrollTop += top - nav.clientHeight / 3;
  }
  addEventListener("scroll", look, {passive: true});
  look();
  nav.addEventListener("click", (event) => {
    if (event.target.closest("a")) document.documentElement.classList.remove("lit-contents-open");
  });
});
