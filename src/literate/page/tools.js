// SPDX-License-Identifier: GPL-3.0-or-later
// The bar above the text: contents on a small screen, search, light and dark.

// Set before the first paint, so that nothing flashes.
function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
}
const darkOutside = matchMedia("(prefers-color-scheme: dark)");
setTheme(lit.remember("theme") || (darkOutside.matches ? "dark" : "light"));
darkOutside.addEventListener("change", () => {
  if (!lit.remember("theme")) setTheme(darkOutside.matches ? "dark" : "light");
});

lit.part(function tools() {
  const root = document.documentElement;
  const dark = lit.button("Dark", () => {
    setTheme(root.dataset.theme === "dark" ? "light" : "dark");
    lit.remember("theme", root.dataset.theme);
    dark.setAttribute("aria-pressed", String(root.dataset.theme === "dark"));
  }, {"aria-pressed": String(root.dataset.theme === "dark")});
  darkOutside.addEventListener("change", () => dark.setAttribute("aria-pressed", String(root.dataset.theme === "dark")));
  const contents = document.getElementById("contents") && lit.button("Contents", () => {
    const isOpen = root.classList.toggle("lit-contents-open");
    contents.setAttribute("aria-expanded", String(isOpen));
  }, {class: "lit-contents-button", "aria-expanded": "false", "aria-controls": "contents"});
  const bar = lit.make("header", {class: "lit-tools"}, contents, makeSearch(), dark);
  const skip = document.querySelector("body > .lit-skip");
  if (skip) skip.after(bar);
  else document.body.prepend(bar);
});
