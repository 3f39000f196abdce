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
    const facts = Object.assign({values: {}, figures: {}, tables: {}}, JSON.parse(text));
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
      for (const name of ["id", "name", "tabindex", "aria-describedby"]) part.removeAttribute(name);
    }
    for (const part of copy.querySelectorAll(".lit-data, .lit-reading, .lit-pointed > svg, .lit-card")) part.remove();
    for (const button of copy.querySelectorAll("button")) button.replaceWith(...button.childNodes);
    return copy;
  },

  /// The words of an element, without what the script added.
  words(element) {
    const copy = lit.copy(element);
    for (const cell of copy.querySelectorAll("td, th")) cell.append(" ");
    return copy.textContent.replace(/\s+/g, " ").trim();
  },

  /// The element that a link within the page leads to.
  target(link) {
    const id = decodeURIComponent((link.getAttribute("href") || "").replace(/^#/, ""));
    return id ? document.getElementById(id) : null;
  },

  /// A number that a program wrote, such as -1.2e-6, as a reader knows it.
  number(text) {
    return text.replace(/e\+?(-?\d+)/, (whole, power) => " × 10" + power.replace(/[-\d]/g, (c) => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]))
      .replace(/^-/, "−");
  },

  /// Puts a text into the clipboard, and says on the button whether that worked.
  async clip(text, button) {
    const label = button.textContent;
    button.textContent = await navigator.clipboard.writeText(text).then(() => "Copied", () => "Not allowed");
    lit.say(button.textContent);
    setTimeout(() => { button.textContent = label; }, 1500);
  },

  /// Tells a screen reader what changed without a new page.
  say(text) {
    lit.said ??= document.querySelector("main").appendChild(lit.make("p", {class: "lit-said", role: "status"}));
    lit.said.textContent = text;
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
