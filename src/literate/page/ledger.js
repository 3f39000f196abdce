// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger, filtered by verdict and by who says it.

const originNames = {paper: "of others", ours: "our own"};

lit.part(function ledger() {
  const entries = [...document.querySelectorAll(".lit-ledger-entry")];
  if (entries.length < 2) return;
  const chosen = {verdict: null, origin: null};
  const count = lit.make("output", {});

  function matches(entry) {
    return Object.entries(chosen).every(([kind, wanted]) => !wanted || entry.dataset[kind] === wanted);
  }
  function show() {
    for (const entry of entries) entry.hidden = !matches(entry);
    const n = entries.filter((entry) => !entry.hidden).length;
    count.textContent = n === entries.length ? `all ${n} claims` : `${n} of ${entries.length} claims`;
    for (const button of form.querySelectorAll("button[data-kind]")) {
      button.setAttribute("aria-pressed", String((chosen[button.dataset.kind] || "") === button.dataset.wanted));
    }
  }
  function buttons(kind, names) {
    return Object.entries(names).map(([wanted, name]) => {
      const n = entries.filter((entry) => entry.dataset[kind] === wanted).length;
      if (n === 0) return null;
      return lit.button(`${name} (${n})`, () => {
        chosen[kind] = chosen[kind] === wanted ? null : wanted;
        show();
      }, {"data-kind": kind, "data-wanted": wanted, "aria-pressed": "false"});
    });
  }

  const form = lit.make("fieldset", {class: "lit-filter"}, lit.make("legend", {}, "Show claims"),
    buttons("verdict", verdictNames), buttons("origin", originNames),
    lit.button("all", () => {
      chosen.verdict = chosen.origin = null;
      show();
    }), count);
  (entries[0].closest(".lit-ledger") || entries[0]).before(form);
  show();

  // A link to a claim that is filtered away shows it.
  function arrive() {
    const entry = lit.target({getAttribute: () => location.hash})?.closest(".lit-ledger-entry");
    if (!entry?.hidden) return;
    chosen.verdict = chosen.origin = null;
    show();
    entry.scrollIntoView();
  }
  addEventListener("hashchange", arrive);
});
