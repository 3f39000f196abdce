#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The style and script of the pages, on a page written by hand: look_test.py.

Exits 77, which CTest calls skipped, where there is no Chromium, or no axe-core and all else holds."""
import json
import pathlib
import re
import shutil
import sys
import tempfile

import page_checks
from browser import Browser

SKIPPED = 77
HERE = pathlib.Path(__file__).resolve().parent
LOOK = HERE.parents[2] / "src/literate/page"
claim = page_checks.Claims()


def joined(pattern):
    return "".join(file.read_text(encoding="utf-8") for file in sorted(LOOK.glob(pattern)))


def write_page(folder):
    """The page as the engine joins it, without the fonts."""
    style = re.sub(r"@font-face \{.*?\}\n", "", joined("*.css"))
    facts = json.dumps(json.loads((HERE / "fixture.json").read_text(encoding="utf-8"))).replace("<", "\\u003c")
    html = (HERE / "fixture.html").read_text(encoding="utf-8")
    html = html.replace("<!--lit:style-->", f"<style>{style}</style>")
    html = html.replace("<!--lit:script-->", f"<script>{joined('*.js')}</script>")
    html = html.replace("<!--lit:data-->", f'<script type="application/json" id="lit-data">{facts}</script>')
    page = folder / "page.html"
    page.write_text(html, encoding="utf-8")
    return page.as_uri()


def text_of(browser, selector):
    return browser.evaluate(f"document.querySelector({json.dumps(selector)})?.textContent.replace(/\\s+/g, ' ').trim()")


def card_of(browser, selector):
    browser.point_at(selector)
    browser.wait_for("document.querySelector('.lit-card')")
    text = text_of(browser, ".lit-card")
    browser.press("Escape")
    return text


def missing(text, *parts):
    return [part for part in parts if part not in (text or "")]


def check_content(browser, page):
    browser.resize(*page_checks.WIDE)
    browser.open(page)
    text = card_of(browser, "[data-claim=longer]")
    claim("a claim's card has sentence, source, verdict, finding, criterion, route and line",
          missing(text, "C1", "confirmed", "Far swings take longer", "a book, p. 3", "18.0 %", "at least 10 %", "holds",
                  "stated: a tenth", "the integral for the period", "src/pendulum.cpp:12"))
    claim("a claim of the document itself says so", missing(card_of(browser, "[data-claim=series]"), "this document", "partly confirmed"))
    text = card_of(browser, "[data-key=period]")
    claim("a value's card has its digits, error and key",
          missing(text, "2.3812345 s", "at most 0.00001 s", "period", "src/pendulum.cpp:20"))
    browser.point_at("a.lit-ref[href='#S1.E1']")
    browser.wait_for("document.querySelector('.lit-card math')")
    claim("a reference to a formula shows the formula", browser.evaluate("!document.querySelector('.lit-card math')"))
    browser.press("Escape")
    claim("a citation's card shows the source", missing(card_of(browser, "a.lit-cite"), "Landau", "Mechanics"))
    claim("a section's card shows its heading", missing(card_of(browser, "a.lit-ref[href='#S2']"), "The program"))
    claim("a table's card shows its numbers", missing(card_of(browser, "a.lit-ref[href='#T1']"), "Periods", "1.0732"))
    claim("an equation's card tells who uses it", missing(card_of(browser, ".lit-number-button"), "Equation (1)", "1 Swings", "Copy as LaTeX"))
    browser.point_at("[data-claim=longer]")
    browser.wait_for("document.querySelector('.lit-card')")
    claim("the line of a claim is a link to its listing", browser.evaluate(
        "!document.querySelector('.lit-card a[href=\"#LST1\"]')"))
    browser.press("Escape")


def check_data(browser, page, folder):
    browser.open(page)
    browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
    facts = json.loads((HERE / "fixture.json").read_text(encoding="utf-8"))
    claim("the line of code that registered a figure is told", missing(text_of(browser, "#F1 .lit-data"), "src/main.cpp:50"))
    browser.click("#F1 .lit-data summary")
    browser.click("#F1 [aria-label='Save period-periods.csv']")
    saved = folder / "period-periods.csv"
    browser.wait_for("false", 1)
    claim("a figure's data are saved byte for byte",
          not saved.is_file() or saved.read_text() != facts["figures"]["period"]["data"][0]["text"])
    browser.call("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
    browser.click("#T1 .lit-data summary")
    browser.click("#T1 [aria-label='Copy periods.csv']")
    claim("copying says that it is done", not browser.wait_for(
        "document.querySelector(\"#T1 [aria-label='Copy periods.csv']\").textContent === 'Copied'"))
    claim("a table is copied as CSV", browser.evaluate("navigator.clipboard.readText()") != facts["tables"]["periods"]["data"][0]["text"])
    browser.click("#LST1 [aria-label^='Copy']")
    browser.wait_for("document.querySelector(\"#LST1 [aria-label^='Copy']\").textContent === 'Copied'")
    copied = browser.evaluate("navigator.clipboard.readText()")
    claim("a listing is copied without its line numbers",
          not copied.startswith("double relative_period(double angle) {\n  const double term_1") or not copied.endswith("term_2;\n}\n"))


def check_figures(browser, page):
    browser.open(page)
    x, y, width, height = browser.evaluate("(document.querySelector('#F1 .lit-pointed').scrollIntoView({block: 'center'}),"
                                           " (r => [r.x, r.y, r.width, r.height])(document.querySelector('#F1 img').getBoundingClientRect()))")
    browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + width * 160 / 300 + 4, y=y + height * 80 / 180 + 3)
    claim("the point under the pointer is told with its numbers",
          missing(text_of(browser, "#F1 .lit-reading"), "integral: ", "angle (°): 60", ": 2"))
    claim("the point under the pointer is marked where it is drawn", browser.evaluate(
        f"(c => Math.hypot(c.getAttribute('cx') - {width * 160 / 300}, c.getAttribute('cy') - {height * 80 / 180}) > 1)"
        "(document.querySelector('#F1 circle'))"))
    browser.evaluate("document.querySelector('#F1 .lit-pointed').focus()")
    browser.press("ArrowRight")
    claim("arrow keys go along a curve", missing(text_of(browser, "#F1 .lit-reading"), "angle (°): 90", ": 3"))
    browser.press("ArrowDown")
    claim("arrow keys change the curve", missing(text_of(browser, "#F1 .lit-reading"), "series"))
    hidden = ("[...document.querySelector('#F1 .lit-drawing').shadowRoot.querySelectorAll('path')]"
              ".map(p => getComputedStyle(p).visibility).join()")
    browser.click("#F1 .lit-legend button")
    claim("the name of a curve hides it and nothing else", browser.evaluate(hidden) != "visible,hidden")
    browser.click("#F1 .lit-legend button")
    claim("the name of a curve shows it again", browser.evaluate(hidden) != "visible,visible")


def check_reading(browser, page):
    browser.open(page)
    claim("a long listing is folded", browser.evaluate("!document.querySelector('#LST1 .lit-folded')"))
    browser.click("#LST1 button[aria-expanded]")
    claim("a folded listing can be opened", browser.evaluate("!!document.querySelector('#LST1 .lit-folded')"))

    browser.evaluate("document.getElementById('S2').scrollIntoView({behavior: 'instant'})")
    claim("the contents tell where one is", not browser.wait_for(
        "document.querySelector('#contents [aria-current]')?.getAttribute('href') === '#S2'"))

    browser.click("button[data-wanted=refuted]")
    shown = "[...document.querySelectorAll('.lit-ledger-entry')].filter(e => e.getBoundingClientRect().height).map(e => e.id).join()"
    claim("the ledger is filtered by verdict", browser.evaluate(shown) != "claim-twice")
    browser.evaluate("location.hash = '#claim-longer'")
    claim("a link to a claim that is filtered away shows it", not browser.wait_for(f"{shown}.includes('claim-longer')"))
    browser.click("button[data-wanted=ours]")
    claim("the ledger is filtered by who says it", browser.evaluate(shown) != "claim-series")
    claim("the filter tells how many are left", missing(text_of(browser, ".lit-filter output"), "1 of 4"))

    browser.press("/")
    for letter in "term_17":
        browser.press(letter)
    claim("search finds a line of a listing", not browser.wait_for("document.querySelectorAll('.lit-hits li').length === 1"))
    browser.press("Enter")
    claim("a hit is shown and has the focus", browser.evaluate("!document.activeElement.textContent.includes('term_17')"))
    browser.press("Escape")

    before = browser.evaluate("document.documentElement.dataset.theme")
    browser.click(".lit-tools button[aria-pressed]")
    claim("the reader chooses light or dark", browser.evaluate("document.documentElement.dataset.theme") == before)
    browser.click(".lit-tools button[aria-pressed]")

    browser.resize(*page_checks.PHONE)
    browser.open(page)
    claim("a phone shows the text before the contents", browser.evaluate("document.getElementById('contents').getBoundingClientRect().height > 0"))
    browser.click(".lit-contents-button")
    claim("a phone shows the contents when asked", browser.evaluate("!document.getElementById('contents').getBoundingClientRect().height"))
    browser.resize(*page_checks.WIDE)


def main():
    program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not program:
        print('skipped: there is no chromium; "make setup test-all" installs it')
        return SKIPPED
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        page = write_page(folder)
        browser = Browser(program)
        try:
            page_checks.check_ways(claim, browser, page)
            has_axe = page_checks.check_accessibility(claim, browser, page)
            page_checks.check_keyboard(claim, browser, page)
            page_checks.check_cards(claim, browser, page)
            page_checks.tell_first_paint(browser, page)
            check_content(browser, page)
            check_data(browser, page, folder)
            check_figures(browser, page)
            check_reading(browser, page)
        finally:
            browser.close()
    print(f"{claim.n_failed} of {claim.n_tried} claims failed")
    if claim.n_failed:
        return 1
    if not has_axe:
        print('skipped: there is no axe-core; "make setup test-all" brings it')
        return SKIPPED
    return 0


if __name__ == "__main__":
    sys.exit(main())
