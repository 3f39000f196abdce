// SPDX-License-Identifier: GPL-3.0-or-later
// The bar above the text: contents on a small screen, search, light and dark, which is the system's until the reader chooses.

const themes = {
  root: document.documentElement,
  kept(theme) {
    try {
      return theme ? localStorage.setItem("lit-theme", theme) : localStorage.getItem("lit-theme");
    } catch { /* a page from a file may not be allowed to */ }
    return null;
  },
  isDark: () => (themes.root.dataset.theme ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")) === "dark",
};
// Set before the first paint, so that nothing flashes.
if (themes.kept()) themes.root.dataset.theme = themes.kept();

lit.part(function tools() {
  const dark = lit.button("Dark", () => {
    themes.root.dataset.theme = themes.isDark() ? "light" : "dark";
    themes.kept(themes.root.dataset.theme);
    tell();
  });
  const tell = () => dark.setAttribute("aria-pressed", String(themes.isDark()));
  tell();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", tell);
  const contents = document.getElementById("contents") && lit.button("Contents", () => {
    contents.setAttribute("aria-expanded", String(themes.root.classList.toggle("lit-contents-open")));
  }, {class: "lit-contents-button", "aria-expanded": "false", "aria-controls": "contents"});
  document.querySelector("body > .lit-skip").after(lit.make("header", {class: "lit-tools"}, contents, makeSearch(), dark));
});
