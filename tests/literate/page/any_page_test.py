#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds of the page of any paper, in a browser: any_page_test.py PAGE.

Exits 77 where there is no Chromium, or no axe-core and all else holds."""
import pathlib
import shutil
import sys

import page_checks
from browser import Browser

SKIPPED = 77
claim = page_checks.Claims()


def main():
    program = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not program:
        print('skipped: there is no chromium; "make setup test-all" installs it')
        return SKIPPED
    file = pathlib.Path(sys.argv[1]).resolve()
    page = file.as_uri()
    browser = Browser(program)
    try:
        page_checks.check_size(claim, file)
        page_checks.check_ways(claim, browser, page)
        has_axe = page_checks.check_accessibility(claim, browser, page)
        page_checks.check_keyboard(claim, browser, page)
        page_checks.check_cards(claim, browser, page)
        page_checks.tell_first_paint(browser, page)
    finally:
        browser.close()
    print(f"{claim.n_failed} of {claim.n_tried} claims failed")
    if claim.n_failed:
        return 1
    return 0 if has_axe else SKIPPED


if __name__ == "__main__":
    sys.exit(main())
