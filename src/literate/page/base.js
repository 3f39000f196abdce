// SPDX-License-Identifier: GPL-3.0-or-later
// What all parts of the page's script share. Without it the page is whole: every part only adds. The files of this folder
// are joined in the order of their names into one script in the head.
"use strict";

const lit = {
  starts: [],
  /// Has a part start when the document is there. One that fails leaves the others alone.
  part(start) {
    lit.starts.push(start);
  },

  /// What `page-data` wrote, read when it is first asked for; empty parts where there is none.
  get facts() {
    const text = document.getElementById("lit-data")?.textContent.trim() || "{}";
    const facts = Object.assign({claims: {}, values: {}, figures: {}, tables: {}}, JSON.parse(text));
    Object.defineProperty(lit, "facts", {value: facts});
    return facts;
  },

  /// Makes an element with attributes, of which functions listen, and children: elements, texts, or nothing.
  make(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
      if (typeof value === "function") made.addEventListener(key, value);
      else if (value !== undefined && value !== false) made.setAttribute(key, value === true ? "" : value);
    }
    made.append(...children.flat(Infinity).filter((child) => child !== undefined && child !== null && child !== ""));
    return made;
  },

  button(label, click, attributes = {}) {
    return lit.make("button", {type: "button", click, ...attributes}, label);
  },

  /// A copy to show elsewhere: no id is given twice, nothing in it takes the focus or is told twice to a screen reader.
  copy(element) {
    const copy = element.cloneNode(true);
    for (const part of [copy, ...copy.querySelectorAll("*")]) {
      for (const name of ["id", "name", "tabindex", "aria-controls", "aria-describedby"]) part.removeAttribute(name);
    }
    for (const part of copy.querySelectorAll(".lit-data, .lit-bar, .lit-listing-bar, .lit-filter, .lit-legend, .lit-reading, " +
                                             ".lit-pointed > svg, .lit-card, .lit-source-mark, annotation")) part.remove();
    for (const button of copy.querySelectorAll("button")) button.replaceWith(...button.childNodes);
    for (const folded of [copy, ...copy.querySelectorAll(".lit-folded")]) folded.classList.remove("lit-folded");
    copy.hidden = false;
    return copy;
  },

  /// The words of an element, without the TeX of its formulas and what the script added.
  words(element) {
    const copy = lit.copy(element);
    return copy.textContent.replace(/\s+/g, " ").trim();
  },

  /// The element that a link within the page leads to.
  target(link) {
    const id = decodeURIComponent((link.getAttribute("href") || "").replace(/^#/, ""));
    return id ? document.getElementById(id) : null;
  },

  /// The listing that shows a line of code, «src/x.cpp:12», if one does.
  listingOf(place) {
    const [, file, line] = /^(.*?):(\d+)/.exec(place || "") || [];
    if (!file) return null;
    return [...document.querySelectorAll("[data-listing]")].find((listing) => {
      const [, path, from, to] = /^(.*):(\d+)-(\d+)$/.exec(listing.dataset.listing) || [];
      return path === file && Number(from) <= Number(line) && Number(line) <= Number(to);
    }) || null;
  },

  /// A line of code as text, with a link to the listing that shows it.
  place(place) {
    const listing = lit.listingOf(place);
    const code = lit.make("code", {}, place || "");
    return listing?.id ? lit.make("a", {href: "#" + listing.id}, code) : code;
  },

  /// Tells a screen reader what changed without a new page.
  say(text) {
    if (!lit.said) {
      lit.said = lit.make("p", {class: "lit-said", role: "status"});
      (document.querySelector("main") || document.body).append(lit.said);
    }
    lit.said.textContent = text;
  },

  /// Puts a text into the clipboard, and says on the button whether that worked.
  async clip(text, button) {
    const label = button.textContent;
    let done = true;
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      const area = lit.make("textarea", {class: "lit-said", "aria-hidden": "true"});
      area.value = text;
      document.body.append(area);
      area.select();
      done = document.execCommand("copy");
      area.remove();
      button.focus();
    }
    button.textContent = done ? "Copied" : "Not allowed";
    lit.say(button.textContent);
    setTimeout(() => { button.textContent = label; }, 1500);
  },

  /// Saves a text as a file, from the page itself.
  save(name, text) {
    const type = name.endsWith(".csv") ? "text/csv" : "text/plain";
    const address = URL.createObjectURL(new Blob([text], {type: type + ";charset=utf-8"}));
    const link = lit.make("a", {href: address, download: name});
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  },

  remember(key, value) {
    try {
      if (value === undefined) return localStorage.getItem("lit-" + key);
      localStorage.setItem("lit-" + key, value);
    } catch { /* a page from a file may not be allowed to */ }
    return null;
  },
};

document.documentElement.classList.add("lit-scripted");
document.addEventListener("DOMContentLoaded", () => {
  for (const start of lit.starts) {
    try {
      start();
    } catch (error) {
      setTimeout(() => { throw error; });
    }
  }
});
