// SPDX-License-Identifier: GPL-3.0-or-later
// Cards: what is behind a claim, a value, a reference, an equation or a citation, shown where one points at it, tabs to it or
// touches it: a copy of what the page has elsewhere, so that the two cannot differ. One card is open at a time, as a popover
// of the browser, which closes it by Escape or a touch elsewhere; it stands behind its mark, so that Tab leads into it.

/// What has a card, the innermost first, and who writes it. A writer returns nothing where there is nothing to show.
const cardKinds = [
  [".lit-number-button", equationCard],
  [".lit-value", valueCard],
  ["a.lit-claim, a.lit-cite, a.lit-ref", referenceCard],
];

function valueCard(mark) {
  const key = mark.dataset.key;
  const value = lit.facts.values[key];
  if (!value) return null;
  const inUnit = (number) => `${lit.number(String(number))}${value.unit ? " " + value.unit.replace(/[{}]/g, "") : ""}`;
  const error = value.exact ? "none: the value is exact"
    : value.abs_error === undefined ? "no bound is known"
    : [value.standard && inUnit(value.standard) + " (standard uncertainty)", value.above !== undefined ? `at most ${inUnit(value.below)} below, ${inUnit(value.above)} above`
      : value.abs_error && "at most " + inUnit(value.abs_error)]
      .filter(Boolean).join(", ");
  const row = (name, text) => [lit.make("dt", {}, name), lit.make("dd", {}, text)];
  return [
    lit.make("p", {class: "lit-card-head"}, lit.number(value.printed)),
    lit.make("dl", {},
      value.number === undefined ? [] : [row("unrounded", inUnit(value.number) + (value.percent ? " (as a ratio)" : "")), row("error", error)],
      row("name", lit.make("code", {}, key)), row("computed at", lit.make("code", {}, value.place))),
    lit.make("p", {}, document.getElementById("val-" + key) && [lit.make("a", {href: "#val-" + key}, "In the index of values"), " "],
             lit.button("Copy the number", (event) => lit.clip(String(value.number ?? value.printed), event.currentTarget))),
  ];
}

/// The claim, formula, figure, table, listing, item or heading around an id.
function shownOf(target) {
  const whole = target.closest(".lit-ledger-entry, .lit-equation, figure, li, [data-table]");
  if (whole) return [lit.copy(whole.closest(".lit-scroll") || whole)];
  const heading = target.matches("h1, h2, h3, h4, h5") ? target : target.querySelector("h1, h2, h3, h4, h5");
  if (!heading) return [lit.copy(target.closest("p, dd, dt, td") || target)];
  const first = [...(heading.closest("section") || heading.parentNode).querySelectorAll("p")]
    .find((text) => heading.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING);
  return [lit.copy(heading), first && lit.copy(first)];
}

function referenceCard(link) {
  const target = lit.target(link);
  if (!target || target.closest(".lit-card")) return null;
  return [
    lit.make("div", {class: "lit-shown"}, shownOf(target)),
    lit.make("p", {}, lit.make("a", {href: link.getAttribute("href")}, link.matches(".lit-claim") ? "In the ledger" : "Go there")),
  ];
}

function equationCard(button) {
  const equation = button.closest(".lit-equation");
  const ids = [equation, ...equation.querySelectorAll("[id]")].map((part) => part.id).filter(Boolean);
  const links = [...document.querySelectorAll("main a.lit-ref")].filter((link) => ids.includes(lit.target(link)?.id));
  const tex = [...equation.querySelectorAll("math[alttext]")].map((math) => math.getAttribute("alttext")).join(" ");
  const uses = links.map((link, i) => {
    if (!link.id) link.id = `lit-use-${ids[0]}-${i + 1}`;
    const section = link.closest("section")?.querySelector("h1, h2, h3, h4");
    return lit.make("li", {}, lit.make("a", {href: "#" + link.id}, section ? lit.words(section) : "in the text"));
  });
  return [
    lit.make("p", {class: "lit-card-head"}, `Equation ${button.textContent}`),
    uses.length ? [lit.make("p", {}, "Used in"), lit.make("ul", {}, uses)] : lit.make("p", {}, "No text refers to it."),
    tex && lit.make("p", {}, lit.button("Copy as LaTeX", (event) => lit.clip(tex, event.currentTarget))),
  ];
}

/// The mark at or around an element, and the writer of its card.
function markAt(element) {
  if (!(element instanceof Element) || element.closest(".lit-card, .lit-tools, #contents")) return null;
  for (const [selector, write] of cardKinds) {
    const mark = element.closest(selector);
    if (mark) return {mark, write};
  }
  return null;
}

/// What takes the focus for a mark: itself, or the link in it.
function focusOf(mark) {
  return mark.matches("a, button") ? mark : mark.querySelector("a");
}

const card = {element: null, mark: null, timer: 0, touched: false, isClosing: false, pointer: ""};

/// Whether the pointer itself has moved. A card that closes, or a page that scrolls, bares a mark below a pointer at rest.
function hasMoved({clientX, clientY}) {
  const before = card.pointer;
  card.pointer = `${clientX} ${clientY}`;
  return card.pointer !== before;
}

function openCard({mark, write}) {
  clearTimeout(card.timer);
  if (card.mark === mark) return;
  const content = write(mark);
  if (!content) return;
  closeCard();
  const made = lit.make("span", {class: "lit-card", id: "lit-card", role: "dialog", popover: "auto",
    "aria-label": `About ${lit.words(mark) || "this formula"}`, beforetoggle: (event) => { if (event.newState === "closed") forgetCard(made); }});
  made.append(lit.make("div", {}, content));
  focusOf(mark).setAttribute("aria-details", "lit-card");
  mark.after(made);
  Object.assign(card, {element: made, mark});
  made.showPopover();
  placeCard();
}

/// The browser may give the focus back to the mark now, which is no reason to open the card again.
function forgetCard(element) {
  focusOf(card.mark).removeAttribute("aria-details");
  Object.assign(card, {element: null, mark: null, isClosing: true});
  setTimeout(() => {
    card.isClosing = false;
    element.remove();
  });
}

function closeCard() {
  clearTimeout(card.timer);
  const element = card.element;
  element?.hidePopover();
  element?.remove();
  card.isClosing = false;
}

/// Below the mark, or above it where there is more room.
function placeCard() {
  if (!card.element) return;
  const mark = card.mark.getClientRects()[0] || card.mark.getBoundingClientRect();
  const {width, height} = card.element.getBoundingClientRect();
  const below = mark.bottom + 6, above = mark.top - height - 6;
  const top = below + height <= innerHeight || above < 0 ? Math.min(below, innerHeight - height - 4) : above;
  card.element.style.top = `${Math.max(4, top)}px`;
  card.element.style.left = `${Math.max(8, Math.min(mark.left, document.documentElement.clientWidth - width - 8))}px`;
}

function later(milliseconds, action) {
  clearTimeout(card.timer);
  card.timer = setTimeout(action, milliseconds);
}

function holds(element) {
  return card.element && element instanceof Node && (card.element.contains(element) || card.mark.contains(element));
}

lit.part(function cards() {
  for (const number of document.querySelectorAll("main .lit-equation-number")) {
    const button = lit.button("", undefined, {class: "lit-number-button", "aria-label": `About equation ${number.textContent}`});
    button.append(...number.childNodes);
    number.append(button);
  }
  // Where there is no index of values, the link of a value leads to itself.
  for (const link of document.querySelectorAll("main .lit-value a:not([href])")) link.href = "#" + link.parentNode.id;

  document.addEventListener("pointerover", (event) => {
    if (event.pointerType === "touch") return;
    const moved = hasMoved(event);
    if (holds(event.target)) return clearTimeout(card.timer);
    const found = markAt(event.target);
    if (found && !moved) return;
    if (found) return later(220, () => openCard(found));
    if (card.element && !card.element.contains(document.activeElement)) later(280, closeCard);
    else if (!card.element) clearTimeout(card.timer);
  });
  document.addEventListener("pointermove", hasMoved, {passive: true});
  document.addEventListener("pointerdown", (event) => { card.touched = event.pointerType === "touch"; });
  // A touch has no hovering: the first shows the card, which has the link.
  document.addEventListener("click", (event) => {
    const found = markAt(event.target);
    if (found && (card.touched || found.mark.matches("button"))) {
      event.preventDefault();
      openCard(found);
    } else if (card.element?.contains(event.target.closest?.("a[href^='#']"))) {
      setTimeout(closeCard);
    }
  });
  document.addEventListener("focusin", (event) => {
    if (holds(event.target) || card.isClosing) return;
    const found = markAt(event.target);
    if (found && event.target.matches(":focus-visible")) openCard(found);
    else closeCard();
  });
  addEventListener("scroll", placeCard, {passive: true});
  addEventListener("resize", closeCard);
});
