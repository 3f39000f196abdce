// SPDX-License-Identifier: GPL-3.0-or-later
// Cards: what is behind a claim, a value, a reference, an equation or a citation, shown where one points at it, tabs to it or
// touches it. One card is open at a time; it stands behind its mark in the document, so that Tab leads into it.

const verdictNames = {confirmed: "confirmed", partly: "partly confirmed", refuted: "refuted", undecided: "undecided"};
const verdictSigns = {confirmed: "✓", partly: "◐", refuted: "✗", undecided: "?"};

/// What has a card, the innermost first, and who writes it. A writer returns nothing where there is nothing to show.
const cardKinds = [
  [".lit-number-button", equationCard],
  [".lit-claim", claimCard],
  [".lit-value", valueCard],
  ["a.lit-cite", (link) => referenceCard(link, "Source")],
  ["a.lit-ref", (link) => referenceCard(link)],
];

const latexLetters = {alpha: "α", beta: "β", gamma: "γ", delta: "δ", Delta: "Δ", epsilon: "ε", varepsilon: "ε", eta: "η", theta: "θ",
  kappa: "κ", lambda: "λ", mu: "μ", nu: "ν", xi: "ξ", pi: "π", rho: "ρ", sigma: "σ", Sigma: "Σ", tau: "τ", phi: "φ", varphi: "φ", psi: "ψ",
  omega: "ω", Omega: "Ω", partial: "∂", infty: "∞", times: "×", cdot: "·", pm: "±", le: "≤", ge: "≥", leq: "≤", geq: "≥", approx: "≈",
  textendash: "–", textemdash: "—", ldots: "…", dots: "…", degree: "°"};

/// Raised digits, of which Unicode has its own.
function raised(digits) {
  return digits.replace(/[-\d]/g, (sign) => sign === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[sign]);
}

/// A text of LaTeX as a reader sees it, as far as letters can show it; for what the page does not hold in another form.
function plainLatex(latex) {
  return (latex || "").replace(/~|\\[,;: ]/g, "\u00a0").replace(/---?/g, "–").replace(/\\quoted\{[^}]*\}/g, "…")
    .replace(/\\([a-zA-Z]+)\*?(\[[^\]]*\])?/g, (whole, name) => latexLetters[name] || "")
    .replace(/\^\{?(-?\d+)\}?/g, (whole, digits) => raised(digits)).replace(/\\(.)/g, "$1").replace(/[{}$]/g, "")
    .replace(/_(\w)/g, "$1").replace(/\s+/g, " ").trim();
}

function rows(...pairs) {
  return lit.make("dl", {}, pairs.filter(([, value]) => value)
    .map(([name, value]) => [lit.make("dt", {}, name), lit.make("dd", {}, value)]));
}

function verdictMark(verdict) {
  return lit.make("span", {class: "lit-verdict", "data-verdict": verdict},
                  `${verdictSigns[verdict] || ""} ${verdictNames[verdict] || verdict}`);
}

function claimCard(mark) {
  const key = mark.dataset.claim;
  const claim = lit.facts.claims[key];
  const entry = document.getElementById("claim-" + key);
  if (!claim && !entry) return null;
  const sentence = entry?.querySelector(".lit-ledger-statement em");
  const verdict = claim?.verdict || entry.dataset.verdict;
  const origin = claim?.origin || entry.dataset.origin;
  const found = (claim?.criteria || []).map((criterion) => [
    lit.make("p", {}, lit.make("b", {}, criterion.found), ` — ${criterion.name}, asked to be ${criterion.condition}: `,
             criterion.outcome, criterion.missing ? ` (${criterion.missing})` : ""),
    lit.make("p", {class: "lit-quiet"}, criterion.reason)]);
  return [
    lit.make("p", {class: "lit-card-head"}, claim ? `Claim ${claim.number}` : "Claim", verdictMark(verdict)),
    lit.make("div", {class: "lit-said-here"}, sentence ? lit.copy(sentence) : plainLatex(claim?.sentence)),
    rows(["said by", origin === "paper" ? plainLatex(claim?.source) || "the paper" : "this document"],
         ["found", found], ["route", claim?.route], ["expected", claim && claim.expected !== verdict && verdictNames[claim.expected]],
         ["registered", claim && lit.place(claim.place)]),
    entry && lit.make("p", {}, lit.make("a", {href: "#claim-" + key}, "In the ledger")),
  ];
}

function valueCard(mark) {
  const key = mark.dataset.key;
  const value = lit.facts.values[key];
  if (!value) return null;
  const inUnit = (number) => number === undefined ? "" : `${number}${value.unit ? " " + value.unit : ""}`;
  const error = value.abs_error === 0 || value.exact ? "exact"
    : value.abs_error === undefined ? "no bound is known" : "at most " + inUnit(value.abs_error);
  const entry = document.getElementById("val-" + key);
  return [
    lit.make("p", {class: "lit-card-head"}, value.printed),
    rows(["unrounded", value.number !== undefined && inUnit(value.number) + (value.percent ? " (as a ratio)" : "")],
         ["error", value.number !== undefined && error], ["key", lit.make("code", {}, key)], ["computed at", lit.place(value.place)]),
    lit.make("p", {}, entry && lit.make("a", {href: "#" + entry.id}, "In the index of values"), entry && " ",
             lit.button("Copy the number", (event) => lit.clip(String(value.number ?? value.printed), event.currentTarget))),
  ];
}

/// The formula, figure, table, listing, item or heading around an id.
function shownOf(target) {
  const whole = target.closest(".lit-equation, figure, li, [data-table]");
  if (whole) return [lit.copy(whole.closest(".lit-scroll") || whole)];
  const heading = target.matches("h1, h2, h3, h4, h5") ? target : target.querySelector("h1, h2, h3, h4, h5");
  if (!heading) return [lit.copy(target.closest("p, dd, dt, td") || target)];
  const first = [...(heading.closest("section") || heading.parentNode).querySelectorAll("p")]
    .find((text) => heading.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING);
  return [lit.copy(heading), first && lit.copy(first)];
}

function referenceCard(link, name = "") {
  const target = lit.target(link);
  if (!target || target.closest(".lit-card")) return null;
  return [
    name && lit.make("p", {class: "lit-card-head"}, name),
    lit.make("div", {class: "lit-shown"}, shownOf(target)),
    lit.make("p", {}, lit.make("a", {href: link.getAttribute("href")}, "Go there")),
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
  return mark.matches("a[href], button") ? mark : mark.querySelector("a[href]") || mark;
}

const card = {element: null, mark: null, timer: 0, touched: false};

function openCard({mark, write}) {
  clearTimeout(card.timer);
  if (card.mark === mark) return;
  closeCard();
  const content = write(mark);
  if (!content) return;
  const name = `About ${lit.words(mark) || "this formula"}`;
  card.mark = mark;
  card.element = lit.make("span", {class: "lit-card", id: "lit-card", role: "dialog", "aria-label": name, popover: "manual"});
  card.element.append(lit.make("div", {}, content));
  focusOf(mark).setAttribute("aria-details", "lit-card");
  mark.after(card.element);
  card.element.showPopover?.();
  placeCard();
}

/// Below the mark, or above it where there is more room.
function placeCard() {
  if (!card.element) return;
  const lines = card.mark.getClientRects();
  const mark = lines[0] || card.mark.getBoundingClientRect();
  const {width, height} = card.element.getBoundingClientRect();
  const below = mark.bottom + 6, above = mark.top - height - 6;
  const top = below + height <= innerHeight || above < 0 ? Math.min(below, innerHeight - height - 4) : above;
  card.element.style.top = `${Math.max(4, top)}px`;
  card.element.style.left = `${Math.max(8, Math.min(mark.left, document.documentElement.clientWidth - width - 8))}px`;
}

function closeCard() {
  clearTimeout(card.timer);
  if (!card.element) return;
  focusOf(card.mark).removeAttribute("aria-details");
  card.element.remove();
  card.element = card.mark = null;
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
  for (const value of document.querySelectorAll("main .lit-value")) {
    if (value.closest("a, math") || focusOf(value) !== value) continue;
    value.tabIndex = 0;
    value.setAttribute("role", "button");
  }

  document.addEventListener("pointerover", (event) => {
    if (event.pointerType === "touch") return;
    if (holds(event.target)) return clearTimeout(card.timer);
    const found = markAt(event.target);
    if (found) return later(220, () => openCard(found));
    if (card.element && !card.element.contains(document.activeElement)) later(280, closeCard);
    else if (!card.element) clearTimeout(card.timer);
  });
  document.addEventListener("pointerdown", (event) => {
    card.touched = event.pointerType === "touch";
    if (card.element && !holds(event.target)) closeCard();
  });
  // A touch has no hovering: the first shows the card, which has the link.
  document.addEventListener("click", (event) => {
    const found = markAt(event.target);
    if (found && (card.touched || found.mark.matches("button"))) {
      event.preventDefault();
      openCard(found);
    } else if (card.element && card.element.contains(event.target.closest?.("a[href^='#']"))) {
      setTimeout(closeCard);
    }
  });
  document.addEventListener("focusin", (event) => {
    if (holds(event.target)) return;
    const found = markAt(event.target);
    if (found && event.target.matches(":focus-visible")) openCard(found);
    else if (card.element) closeCard();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && card.element) {
      const focus = focusOf(card.mark);
      const wasInside = card.element.contains(document.activeElement);
      closeCard();
      if (wasInside) {
        focus.focus();
        closeCard();
      }
      event.preventDefault();
    } else if ((event.key === "Enter" || event.key === " ") && event.target.matches?.(".lit-value[role=button]")) {
      openCard(markAt(event.target));
      event.preventDefault();
    }
  });
  addEventListener("scroll", placeCard, {passive: true});
  addEventListener("resize", closeCard);
  addEventListener("hashchange", closeCard);
});
