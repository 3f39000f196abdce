#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""html_test.py SOURCE SETTINGS: the built report becomes an accessible page with all of its numbers."""

import subprocess
import sys
import unittest
from pathlib import Path

SOURCE, SETTINGS = map(Path, sys.argv[1:3])
OUTPUT = SETTINGS.with_suffix("")
SKIPPED = 77
sys.path.insert(0, str(SOURCE / "tests/literate/page"))
import browser  # noqa: E402
import text  # noqa: E402


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        ended = subprocess.run([sys.executable, SOURCE / "src/literate/tools/literate", "html", SETTINGS], capture_output=True, text=True)
        assert ended.returncode == 0, ended.stderr
        cls.page = OUTPUT / "report.html"

    def test_lacks_no_number_and_few_words(self):
        words, in_pdf, on_page = text.differences(OUTPUT / "report.pdf", self.page, OUTPUT / "page/pdf.pdf",
                                                  OUTPUT / "generated/ledger.tex")
        self.assertLessEqual(words.total(), 100, words)
        self.assertEqual((list(in_pdf), list(on_page)), ([], []))

    def test_can_be_read_by_everyone(self):
        self.assertLessEqual(self.page.stat().st_size, 2_500_000)
        for width in (1280, 390):
            for opens_card in (False, True):
                with self.subTest(width=width, opens_card=opens_card):
                    found = browser.look(self.page, width, opens_card=opens_card)
                    self.assertEqual((found["violations"], found["requests"], found["dead"], found["blind"]), ([], [], [], 0))
                    self.assertEqual((found["width"], bool(found["card"])), (width, opens_card))


if __name__ == "__main__":
    if browser.missing_tool():
        print(f"skipped: {browser.missing_tool()}")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1])
