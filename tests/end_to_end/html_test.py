#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page as a reader's browser shows it: html_test.py PAGE NAMES_JSON [--as-read], NAMES_JSON as the report wrote it;
with --as-read in every way of reading it.

Exits 77, which CTest calls skipped, where there is no Chromium, or no axe-core and all else holds."""
import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "literate/page"))
import page_checks  # noqa: E402

claim = page_checks.Claims()


def digits(text):
    """Without the spaces that group digits and with ASCII's minus."""
    return re.sub(r"[\s\u2009\u202f\u2007\u2008\u00a0\u2062]", "", text).replace("\u2212", "-")


def as_shown(value):
    """A value of names.json as its digits follow each other in the page: 1.2e-6 in is 1.2×10-6in."""
    shown = re.sub(r"^(-?[\d.]+)e(-?\d+)", r"\1×10\2", str(value)).replace("−", "-")
    return digits(shown.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")))


def numbers(names):
    values = names.get("values", {})
    return {key: entry["printed"] for key, entry in values.items()}


def check_on_desktop(browser, names):
    wanted = ["img.lit-drawing", ".lit-table", "math", "#sec\\:ledger"]
    claim("there are figures, tables and formulas", browser.evaluate(
        f"{json.dumps(wanted)}.filter(s => !document.querySelector(s))"))
    claim("every link is within the page, or one that a reader follows to a DOI", browser.evaluate(
        "[...document.querySelectorAll('a[href], link, script[src], img')].map(e => [e.tagName,"
        " e.getAttribute('href') || e.getAttribute('src') || '']).filter(([tag, to]) => !/^(#|data:)/.test(to) &&"
        " !(tag === 'A' && to.startsWith('https://doi.org/'))).map(([, to]) => to.slice(0, 80))"))
    claim("formulas are laid out", browser.evaluate(
        "[...document.querySelectorAll('math')].filter(e => e.textContent.trim() &&"
        " !e.getBoundingClientRect().width).map(e => e.id)"))
    claim("no parenthesis around a letter is as wide as one around a fraction", browser.evaluate(
        "[...document.querySelectorAll('main math mrow')].filter(e => /^\\(\\w\\)$/.test(e.textContent) &&"
        " e.firstChild.getBoundingClientRect().width > .6 * parseFloat(getComputedStyle(e).fontSize))"
        ".map(e => e.closest('math').getAttribute('alttext'))"))
    claim("the points of a column's numbers stand below one another", browser.evaluate(
        """[...document.querySelectorAll('.lit-table tbody')].flatMap(body => {
          const ends = {};
          for (const cell of body.querySelectorAll('.lit-numeric')) {
            const text = cell.firstChild, at = text?.nodeType === 3 ? text.data.replace(/.*×.*/, '').indexOf('.') : -1;
            if (at < 0) continue;
            const range = new Range();
            range.setStart(text, at);
            range.setEnd(text, at + 1);
            (ends[cell.cellIndex] ??= []).push(range.getBoundingClientRect().left);
          }
          return Object.values(ends).filter(all => Math.max(...all) - Math.min(...all) > 1.5)
            .map(all => body.closest('table').dataset.table + ': ' + all.map(Math.round));
        })"""))
    claim("no drawing is cut at its edge", browser.evaluate(
        """Promise.all([...document.querySelectorAll('img[data-drawing]')].map(async image => {
          await image.decode();
          const width = 2 * image.naturalWidth, height = 2 * image.naturalHeight;
          const paper = new OffscreenCanvas(width, height).getContext('2d');
          paper.drawImage(image, 0, 0, width, height);
          const edges = [[0, 0, width, 1], [0, height - 1, width, 1], [0, 0, 1, height], [width - 1, 0, 1, height]];
          // White is paper, as nothing is.
          return edges.some(edge => paper.getImageData(...edge).data.some((byte, i, all) =>
            i % 4 === 3 && byte > 0 && Math.min(all[i - 1], all[i - 2], all[i - 3]) < 250)) ? image.dataset.drawing : '';
        })).then(cut => cut.filter(name => name))"""))
    claim("what is aligned at the right ends there", browser.evaluate(
        """[...document.querySelectorAll('mtd[columnalign=right]')].filter(cell => cell.lastElementChild &&
          Math.abs(cell.lastElementChild.getBoundingClientRect().right - cell.getBoundingClientRect().right
            + parseFloat(getComputedStyle(cell).paddingRight)) > 2).map(cell => cell.textContent)"""))
    claim("drawings that one line holds stand beside each other at each width", browser.evaluate(
        """[...document.querySelectorAll('.lit-row')].filter(row =>
          new Set([...row.querySelectorAll('img')].map(e => e.closest('.lit-row > *').getBoundingClientRect().top)).size > 1).length"""))
    claim("no formula is an error", browser.evaluate(
        "[...document.querySelectorAll('merror')]"
        ".map(e => e.textContent)"))


def check_names(browser, names):
    """What cards, search and filters go by."""
    claim("every figure, table and claim of the program is in the page, and every value there is one of its", browser.evaluate(
        """(names => {
          const shown = (selector, key) => new Set([...document.querySelectorAll(selector)].map(e => e.dataset[key]));
          const drawings = shown('img.lit-drawing', 'drawing'), tables = shown('table.lit-table', 'table');
          const claims = shown('.lit-ledger-entry', 'claim'), values = shown('.lit-value', 'key');
          return [...names.figures.filter(name => !drawings.has(name)), ...names.tables.filter(name => !tables.has(name)),
            ...names.claims.filter(name => !claims.has(name)), ...[...values].filter(key => !names.values.includes(key))];
        })(""" + json.dumps({kind: sorted(names[kind]) for kind in ("figures", "tables", "claims", "values")}) + ")"))
    claim("every claim has its mark in the text, with the verdict that its entry has", browser.evaluate(
        """[...document.querySelectorAll('.lit-ledger-entry')].filter(e => {
          const mark = document.querySelector(`a.lit-claim[data-claim="${e.dataset.claim}"]`);
          return !mark || mark.dataset.verdict !== e.dataset.verdict || mark.hash !== '#' + e.id;
        }).map(e => e.dataset.claim)"""))
    claim("levels of headings are never skipped", browser.evaluate(
        "[...document.querySelectorAll('h1, h2, h3, h4, h5, h6')].filter((e, i, all) =>"
        " +e.tagName[1] > (i ? +all[i - 1].tagName[1] : 0) + 1).map(e => e.textContent)"))
    claim("there is one main part, and the contents lead to every heading that has a number", browser.evaluate(
        "document.querySelectorAll('main').length !== 1 ? ['main'] :"
        " [...document.querySelectorAll('h2 > .lit-number, h3 > .lit-number')].filter(e =>"
        " !document.querySelector(`#contents a[href=\"#${e.closest('section').id}\"]`)).map(e => e.textContent)"))
    claim("no element of the table's head is empty", browser.evaluate(
        "[...document.querySelectorAll('th')].filter(e => !e.textContent.trim()).length || null"))


def check_text(browser):
    # Listings show what C++ says, and that may look like anything.
    text = browser.evaluate(
        "(() => { const page = document.body.cloneNode(true);"
        " page.querySelectorAll('.lit-listing, script').forEach(e => e.remove());"
        " return page.textContent; })()")
    claim("no reference is missing", re.findall(r".{0,20}(?:\?\?|\[\?\]).{0,20}", text))
    claim("no command of LaTeX is left", re.findall(r"\\[A-Za-z@]+.{0,20}", text))
    claim("every number is set as one, not as the program writes it", browser.evaluate(
        "[...document.querySelectorAll('.lit-table td')].filter(e => !e.querySelector('code')).map(e => e.textContent.trim())"
        ".filter(t => /^-|^[-+.\\d]+e[-+]?\\d+$/.test(t))"))
    claim("no character was decoded wrongly", re.findall(r"[\ufffdâÃ].{0,10}", text))
    return digits(text)


def check_formulas(browser):
    for width in (360, 1100, 1280):
        browser.resize(width, 780)
        claim(f"at {width} px the number of each formula is in sight", browser.evaluate(
            """[...document.querySelectorAll('.lit-equation')].filter(box =>
              [...box.querySelectorAll('.lit-equation-number')].some(number =>
                number.getBoundingClientRect().right > Math.min(box.getBoundingClientRect().right, innerWidth) + 1))
              .map(box => box.textContent.slice(-12))"""))
        claim(f"at {width} px a formula is whole, or a shadow tells that it goes on", browser.evaluate(
            """[...document.querySelectorAll('.lit-equation')].filter(box => box.scrollWidth > box.clientWidth + 1 &&
              (getComputedStyle(box).backgroundImage === 'none' || innerWidth >= 1280)).map(box => box.textContent.slice(-30))"""))
        claim(f"at {width} px no line breaks beside a formula without a blank", browser.evaluate(
            """[...document.querySelectorAll('main math')].filter(formula => [formula.previousSibling, formula.nextSibling].some((text, i) => {
              if (text?.nodeType !== 3 || !(i ? /^\\S/ : /\\S$/).test(text.data) || !formula.getClientRects().length) return false;
              const range = new Range(), at = i ? 0 : text.length - 1;
              range.setStart(text, at);
              range.setEnd(text, at + 1);
              const one = range.getBoundingClientRect(), other = formula.getBoundingClientRect();
              return i ? one.left < other.right - 2 : one.right > other.left + 2;
            })).map(e => e.getAttribute('alttext'))"""))
        claim(f"at {width} px no line breaks within a number, before its unit or behind the sign of a section", browser.evaluate(
            """[...document.querySelectorAll('main :is(p, li)')].flatMap(whole => {
              const walker = document.createTreeWalker(whole, NodeFilter.SHOW_TEXT), places = [];
              let said = '';
              while (walker.nextNode()) if (!walker.currentNode.parentElement.closest('math, pre, .lit-note')) {
                for (let i = 0; i < walker.currentNode.length; ++i) places.push([walker.currentNode, i]);
                said += walker.currentNode.data;
              }
              return [...said.matchAll(/§\\s\\w|\\d\\s[×%]|×\\s10(?:−?\\d+)?|\\d\\s(?:psi|lbf)\\b/g)].filter(found => {
                const range = new Range();
                range.setStart(...places[found.index]);
                range.setEnd(places[found.index + found[0].length - 1][0], places[found.index + found[0].length - 1][1] + 1);
                const boxes = [...range.getClientRects()];
                return boxes.some(box => box.left < boxes[0].left - 1);
              }).map(found => said.slice(Math.max(0, found.index - 20), found.index + 20));
            })"""))
        claim(f"at {width} px no formula lies upon a note", browser.evaluate(
            """(notes => [...document.querySelectorAll('.lit-equation')].map(e => [e, e.getBoundingClientRect()])
              .filter(([e, a]) => notes.some(b => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom))
              .map(([e]) => e.textContent.slice(-30)))([...document.querySelectorAll('.lit-note')].map(e => e.getBoundingClientRect()))"""))


def check_on_phone(browser):
    browser.resize(360, 780)
    widths = browser.evaluate("[document.scrollingElement.scrollWidth, innerWidth]")
    claim("a phone need not scroll sideways", widths if widths[0] > 360 or widths[1] > 360 else None)


def check(browser):
    page = pathlib.Path(sys.argv[1]).resolve().as_uri()
    names = json.loads(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8"))
    # The report's own case takes every branch that has a value; another one may pass over some.
    is_own_case = "--as-read" in sys.argv
    browser.resize(1200, 900)
    browser.open(page)
    page_checks.check_whole(claim, browser, page)
    check_on_desktop(browser, names)
    check_names(browser, names)
    text = check_text(browser)
    shown = set(browser.evaluate("[...document.querySelectorAll('.lit-value')].map(e => e.dataset.key)"))
    check_formulas(browser)
    check_on_phone(browser)
    page_checks.check_size(claim, sys.argv[1])
    expected = numbers(names)
    claim("names.json has values, and most are in the text", [] if len(shown) > len(expected) / 2 > 0 else [str(len(shown))])
    claim("every value is in the page",
          [f"{key}: {value}" for key, value in expected.items()
           if as_shown(value) not in text and (is_own_case or key in shown)])
    return not is_own_case or page_checks.check_all(claim, browser, page)


if __name__ == "__main__":
    sys.exit(page_checks.judged(claim, check))
