#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The style and script of the pages, on a page written by hand: look_test.py.

Exits 77, which CTest calls skipped, where there is no Chromium, or no axe-core and all else holds."""
import json
import pathlib
import re
import sys
import tempfile

import page_checks

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
    html = html.replace("<!-- much text -->", 40 * "The amplitude decides, and nothing else does. ")
    html = html.replace("<!-- many terms -->", 20 * "<mi>k</mi><mo>+</mo>")
    html = html.replace("<!-- term_1 to term_30 -->", "".join(
        f'<span class="lit-line" data-line="{10 + i}">  const <span class="kw">double</span> term_{i} = {i} * angle;</span>\n'
        for i in range(1, 31)))
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
    claim("a claim's card is its entry in the ledger",
          missing(text, "C1", "confirmed", "Far swings take longer", "a book, p. 3", "18.0 %", "≥ 10 %", "stated: a tenth",
                  "the integral for the period", "src/pendulum.cpp:12"))
    text = card_of(browser, "[data-key=period]")
    claim("a value's card has its digits, error and key",
          missing(text, "2.3812345 s", "at most 0.00001 s", "period", "src/pendulum.cpp:20"))
    browser.point_at("h1")
    claim("a value that nobody points at has dots below it", browser.evaluate(
        "(s => s.textDecorationLine + ' ' + s.textDecorationStyle)(getComputedStyle(document.querySelector('[data-key=period] a')))")
        != "underline dotted")
    browser.point_at("a.lit-ref[href='#S1.E1']")
    browser.wait_for("document.querySelector('.lit-card math')")
    claim("a reference to a formula shows the formula", browser.evaluate("!document.querySelector('.lit-card math')"))
    browser.press("Escape")
    claim("a citation's card shows the source", missing(card_of(browser, "a.lit-cite"), "Landau", "Mechanics"))
    claim("a section's card shows its heading", missing(card_of(browser, "a.lit-ref[href='#S2']"), "The program"))
    claim("a table's card shows its numbers", missing(card_of(browser, "a.lit-ref[href='#T1']"), "Periods", "1.0732"))
    claim("an equation's card tells who uses it", missing(card_of(browser, ".lit-number-button"), "Equation (1)", "1 Swings", "Copy as LaTeX"))


def check_data(browser, page, folder):
    browser.open(page)
    browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
    facts = json.loads((HERE / "fixture.json").read_text(encoding="utf-8"))
    browser.click("#F1 .lit-data summary")
    browser.wait_for("document.querySelector('#F1 .lit-data li')")
    claim("the line of code that made a figure is told", missing(text_of(browser, "#F1 .lit-data"), "src/main.cpp:50"))
    browser.click("#F1 [aria-label='Save period-periods.csv']")
    saved = folder / "period-periods.csv"
    browser.wait_for("false", 1)
    claim("a figure's data are saved byte for byte",
          not saved.is_file() or saved.read_text() != facts["figures"]["period"]["data"][0]["text"])
    browser.call("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
    claim("the data of one of two drawings stand below it and say whose they are", browser.evaluate(
        "[...document.querySelectorAll('#F2 .lit-drawn')].map(e => e.querySelector('img, svg') && e.querySelector('summary').textContent).join()")
        != "Data and script of drawing 1,Data and script of drawing 2")
    claim("two drawings stand side by side where there is room", browser.evaluate(
        "new Set([...document.querySelectorAll('#F2 .lit-drawn')].map(e => e.getBoundingClientRect().top)).size !== 1"))
    browser.click("#T1 .lit-data summary")
    browser.wait_for("document.querySelector('#T1 .lit-data li')")
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
    browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + 12 + (width - 24) * 160 / 300 + 4, y=y + 12 + (height - 24) * 80 / 180 + 3)
    claim("the point under the pointer is told with its numbers",
          missing(text_of(browser, "#F1 .lit-reading"), "integral: ", "angle (°): 60", ": 2"))
    claim("the point under the pointer is marked where it is drawn", browser.evaluate(
        f"(c => Math.hypot(c.cx.baseVal.value - {(width - 24) * 160 / 300}, c.cy.baseVal.value - {(height - 24) * 80 / 180}) > 1)"
        "(document.querySelector('#F1 circle'))"))
    browser.evaluate("document.querySelector('#F1 .lit-pointed').focus()")
    browser.press("ArrowRight")
    claim("arrow keys go along a curve", missing(text_of(browser, "#F1 .lit-reading"), "angle (°): 90", ": 3"))
    browser.press("ArrowDown")
    claim("arrow keys change the curve", missing(text_of(browser, "#F1 .lit-reading"), "series"))


def check_reading(browser, page):
    browser.open(page)
    claim("a long listing scrolls in a box", browser.evaluate(
        "(e => e.clientHeight > 600 || e.scrollHeight <= e.clientHeight)(document.querySelector('#LST1 pre'))"))
    browser.evaluate("document.getElementById('S2').scrollIntoView({behavior: 'instant'})")
    claim("the contents tell where one is", not browser.wait_for(
        "document.querySelector('#contents [aria-current]')?.getAttribute('href') === '#S2'"))

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
    claim("two drawings stand side by side on a phone", browser.evaluate(
        "new Set([...document.querySelectorAll('#F2 .lit-drawn')].map(e => e.getBoundingClientRect().top)).size !== 1"))
    claim("a phone shows the text before the contents", browser.evaluate("document.getElementById('contents').getBoundingClientRect().height > 0"))
    browser.click(".lit-contents-button")
    claim("a phone shows the contents when asked", browser.evaluate("!document.getElementById('contents').getBoundingClientRect().height"))
    browser.resize(*page_checks.WIDE)


def check(browser):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        page = write_page(folder)
        has_axe = page_checks.check_all(claim, browser, page)
        check_content(browser, page)
        check_data(browser, page, folder)
        check_figures(browser, page)
        check_reading(browser, page)
    return has_axe


if __name__ == "__main__":
    sys.exit(page_checks.judged(claim, check))
