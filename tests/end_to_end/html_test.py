#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page as a reader's browser shows it: html_test.py PAGE NAMES_JSON, NAMES_JSON as the report wrote it.

Exits 77, which CTest calls skipped, where there is no Chromium."""
import json
import pathlib
import re
import shutil
import sys

from browser import Browser

SKIPPED = 77
failures = 0


def claim(text, wrong):
    """Tells a claim and what contradicts it, if anything does."""
    global failures
    if wrong:
        failures += 1
        print(f"FAILED: {text}: {wrong if not isinstance(wrong, list) else wrong[:5]}")


def digits(text):
    """Without the spaces that group digits and with ASCII's minus."""
    return re.sub(r"[\s\u2009\u202f\u2007\u2008\u00a0\u2062]", "", text).replace("\u2212", "-")


def as_shown(value):
    """A value of names.json as its digits follow each other in the page: 1.2e-6 in is 1.2×10-6in."""
    shown = re.sub(r"^(-?[\d.]+)e(-?\d+)", r"\1×10\2", str(value)).replace("−", "-")
    return digits(shown)


def numbers(names):
    values = names.get("values", {})
    return {key: entry["printed"] for key, entry in values.items()}


def check_on_desktop(browser):
    claim("every figure is visible", browser.evaluate(
        "[...document.querySelectorAll('img, svg')].filter(e => !e.getBoundingClientRect().width ||"
        " !e.getBoundingClientRect().height || e.naturalWidth === 0).map(e => e.alt || e.id)"))
    claim("every figure has its caption as its alternative text", browser.evaluate(
        "[...document.querySelectorAll('img')].filter(e => e.alt.length < 20).map(e => e.id)"))
    claim("there are figures, tables, formulas and listings", browser.evaluate(
        "['img.figure', '.ltx_tabular', 'math', '.ltx_listing', '#A1']"
        ".filter(s => !document.querySelector(s))"))
    claim("every link within the page has its target", browser.evaluate(
        "[...document.querySelectorAll('a[href^=\"#\"]')].map(e => decodeURIComponent(e.getAttribute('href')))"
        ".filter(h => !document.getElementById(h.slice(1)))"))
    claim("every link is within the page", browser.evaluate(
        "[...document.querySelectorAll('a[href], link, script, img')].map(e => e.getAttribute('href') ||"
        " e.getAttribute('src') || '').filter(h => !/^(#|data:)/.test(h)).map(h => h.slice(0, 80))"))
    claim("no two elements share an id", browser.evaluate(
        "[...document.querySelectorAll('[id]')].map(e => e.id).filter((id, i, all) => all.indexOf(id) !== i)"))
    claim("formulas are laid out", browser.evaluate(
        "[...document.querySelectorAll('math')].filter(e => e.textContent.trim() &&"
        " !e.getBoundingClientRect().width).map(e => e.id)"))
    claim("no formula is an error", browser.evaluate(
        "[...document.querySelectorAll('merror, .ltx_ERROR, .ltx_missing')]"
        ".map(e => e.textContent)"))


def check_text(browser):
    # Listings show what C++ says, and that may look like anything.
    text = browser.evaluate(
        "(() => { const page = document.body.cloneNode(true);"
        " page.querySelectorAll('.ltx_listing, annotation').forEach(e => e.remove());"
        " return page.textContent; })()")
    claim("no reference is missing", re.findall(r".{0,20}(?:\?\?|\[\?\]).{0,20}", text))
    claim("no command of LaTeX is left", re.findall(r"\\[A-Za-z@]+.{0,20}", text))
    claim("every number is set as one, not as the program writes it", browser.evaluate(
        "[...document.querySelectorAll('.ltx_tabular td')].map(e => e.textContent.trim())"
        ".filter(t => /^-|^[-+.\\d]+e[-+]?\\d+$/.test(t))"))
    claim("no character was decoded wrongly", re.findall(r"[\ufffdâÃ].{0,10}", text))
    return digits(text)


def check_on_phone(browser):
    browser.resize(360, 780)
    widths = browser.evaluate("[document.scrollingElement.scrollWidth, innerWidth]")
    claim("a phone need not scroll sideways", widths if widths[0] > 360 or widths[1] > 360 else None)


def check_events(events, page):
    loud = [event["params"] for event in events
            if event["method"] in ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")]
    claim("the console stays empty", loud)
    urls = [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
    claim("nothing is asked of the network",
          [url[:80] for url in urls if url != page and not url.startswith("data:")])


def main():
    program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not program:
        print('skipped: there is no chromium; "make setup STAGES=html-test" installs it')
        return SKIPPED

    page = pathlib.Path(sys.argv[1]).resolve().as_uri()
    names = json.loads(pathlib.Path(sys.argv[2]).read_text(encoding="utf-8"))
    browser = Browser(program)
    try:
        browser.resize(1200, 900)
        browser.open(page)
        check_on_desktop(browser)
        text = check_text(browser)
        check_on_phone(browser)
        check_events(browser.events, page)
    finally:
        browser.close()
    expected = numbers(names)
    claim("names.json has values", [] if expected else ["none"])
    claim("every value is in the page",
          [f"{key}: {value}" for key, value in expected.items() if as_shown(value) not in text])
    print(f"{failures} of the claims failed; {len(expected)} values looked for")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
