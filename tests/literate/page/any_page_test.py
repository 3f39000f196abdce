#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds of the page of any paper, in a browser: any_page_test.py PAGE.

Exits 77 where there is no Chromium, or no axe-core and all else holds."""
import pathlib
import sys

import page_checks

claim = page_checks.Claims()


def check(browser):
    file = pathlib.Path(sys.argv[1]).resolve()
    page_checks.check_size(claim, file)
    return page_checks.check_all(claim, browser, file.as_uri())


if __name__ == "__main__":
    sys.exit(page_checks.judged(claim, check))
