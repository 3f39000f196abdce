# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the words and decimals of a PDF with those of its page: text.py PDF PAGE [DRAWINGS.pdf] prints what one of them lacks.

Left out are the labels in drawings, which the page shows as pictures."""

import collections
import html.parser
import re
import subprocess
import sys
import unicodedata
from pathlib import Path

LEFT_OUT = {"style", "head", "script", "svg"}
VOID = {"meta", "link", "img", "br", "hr", "col", "wbr"}
IN_LINE = {"a", "span", "em", "i", "b", "code", "sup", "sub", "cite", "math", "mrow", "mi", "mn", "mo", "mtext", "msup", "msub", "mstyle"}


class Page(html.parser.HTMLParser):
    """The text of a page."""

    def __init__(self, text):
        super().__init__()
        self.open, self.text = [], ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        is_apart = tag not in IN_LINE or re.search("ltx_note_outer|width:", str(attributes))
        self.text += " " if is_apart else ""
        if tag not in VOID:
            self.open.append((tag, is_apart))

    def handle_endtag(self, tag):
        while self.open:
            closed, is_apart = self.open.pop()
            self.text += " " if is_apart else ""
            if closed == tag:
                break

    def handle_data(self, data):
        if not LEFT_OUT & {tag for tag, _ in self.open}:  # nor the contents that only the page has
            self.text += data


def words(text):
    return collections.Counter(re.findall(r"[^\W\d_]{2,}", text.lower()))


def decimals(text):
    return collections.Counter(re.findall(r"\d+\.\d+", text))


def normal(text):
    """One kind of space, so that «1.594 640» is the decimal 1.594 on both sides; no ligatures, no invisible signs."""
    text = re.sub(r"[\u2061-\u2063\u200b\u2060]", " ", unicodedata.normalize("NFKC", text))
    return re.sub(r"\s", " ", text)


def pdf_text(pdf):
    return subprocess.run(["pdftotext", "-nopgbrk", pdf, "-"], capture_output=True, text=True, check=True).stdout


def differences(pdf, page, drawings=None):
    """Returns the words of the PDF that the page lacks, and the decimals that only one of them has."""
    on_page = normal(Page(Path(page).read_text(encoding="utf-8")).text)
    known = words(on_page)
    text = pdf_text(pdf)
    # A word that is hyphenated at the end of a line, unless only its halves are words.
    text = re.sub(r"(\w+)[-\u2010]\n(\w+)", lambda halves: "".join(halves.groups()) if "".join(halves.groups()).lower() in known
                  else " ".join(halves.groups()), text)
    in_pdf, drawn = normal(text), normal(pdf_text(drawings)) if drawings else ""
    missing = words(in_pdf) - known - words(drawn)
    here, there = decimals(in_pdf) - decimals(drawn), decimals(on_page)
    return missing, here - there, there - here


if __name__ == "__main__":
    for name, found in zip(("words that the page lacks", "decimals that the page lacks", "decimals that the PDF lacks"),
                           differences(*sys.argv[1:])):
        print(f"{name}: {found.total()}: {' '.join(sorted(found.elements()))[:2000]}")
