# SPDX-License-Identifier: GPL-3.0-or-later
"""text.py PDF PAGE DRAWINGS.pdf LEDGER.tex compares the words and decimals of a PDF with those of its page, and prints the missing ones.

It ignores labels in drawings, which the page shows as pictures. The page may have the whole ledger, even if the document shortens
it on paper."""

import collections
import html
import re
import subprocess
import sys
import unicodedata
from pathlib import Path

LEFT_OUT = r'<head>.*?</head>|<svg\b.*?</svg>|<nav class="contents".*?</nav>'
WITHIN_WORDS = r"</?(?:a|em|i|b|sup|sub|cite|m(?:ath|row|i|n|o|text|sup|sub|style))\b[^>]*>"


def page_text(page):
    text = re.sub(LEFT_OUT, "", Path(page).read_text(encoding="utf-8"), flags=re.DOTALL)
    return html.unescape(re.sub(r"<[^>]*>", " ", re.sub(WITHIN_WORDS, "", text)))


def pdf_text(pdf):
    return subprocess.run(["pdftotext", "-nopgbrk", pdf, "-"], capture_output=True, text=True, check=True).stdout


def normal(text):
    """Removes ligatures and invisible characters, and unifies spaces, so that «1.594 640» is the decimal 1.594 in both."""
    return re.sub(r"[\s\u2061-\u2063\u2060]", " ", unicodedata.normalize("NFKC", text))


def words(text):
    return collections.Counter(re.findall(r"[^\W\d_]{2,}", text.lower()))


def decimals(text):
    return collections.Counter(re.findall(r"\d+\.\d+", text))


def unbroken(broken, known):
    """Joins a word that was broken at the end of a line, unless only its halves are known words."""
    halves = re.split(r"[-\u2010]\n", broken)
    return "".join(halves) if "".join(halves).lower() in known else " ".join(halves)


def differences(pdf, page, drawings, ledger):
    """Returns the words of the PDF that the page lacks, and the decimals that only one of them has."""
    on_page = normal(page_text(page))
    known = words(on_page)
    in_pdf = normal(re.sub(r"\w+[-\u2010]\n\w+", lambda word: unbroken(word[0], known), pdf_text(pdf)))
    drawn, ledger = normal(pdf_text(drawings)), Path(ledger).read_text(encoding="utf-8")
    here, there = decimals(in_pdf) - decimals(drawn), decimals(on_page)
    return words(in_pdf) - known - words(drawn), here - there, there - here - decimals(ledger)


if __name__ == "__main__":
    for name, found in zip(("words that the page lacks", "decimals that the page lacks", "decimals that the PDF lacks"),
                           differences(*sys.argv[1:])):
        print(f"{name}: {found.total()}: {' '.join(sorted(found.elements()))[:2000]}")
