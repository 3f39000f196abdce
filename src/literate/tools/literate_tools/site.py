# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills OUTPUT/site, a folder that any web server can serve, with the page, the PDF, the results and all the data."""

import html
import shutil
from pathlib import Path

from literate_tools.common import Failure
from literate_tools.html import end, make_page
from literate_tools.settings import read_settings

HELP = """usage: literate site [SETTINGS] [FILE …]

Fills a folder for a web server, OUTPUT/site: index.html, the PDF, data/ with all CSV files and results.json, and the
FILEs, which the page links to. The PDF must be up to date.

  literate site build/mypaper.json CITATION.cff

Exit codes: 0 done, 1 done, but a check or claim failed, 2 the document cannot be converted, 3 a tool failed."""


def run(arguments: list[str]) -> int:
    """Fills the folder: literate site [SETTINGS] [FILE …]."""
    if arguments and arguments[0] in ("-h", "--help"):
        print(HELP)
        return 0
    has_settings = bool(arguments) and arguments[0].endswith(".json")
    settings = read_settings(arguments[0] if has_settings else "")
    others = [Path(name) for name in arguments[has_settings:]]
    for file in others:
        if not file.is_file():
            raise Failure(f"{file}: there is no such file")
    site, new = settings.output / "site", settings.output / "site.new"
    for folder in (site, new):
        shutil.rmtree(folder, ignore_errors=True)
    page = make_page(settings)
    for file in [*settings.generated.rglob("*.csv"), settings.generated / "results.json"]:
        copy = new / "data" / file.relative_to(settings.generated)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copy)
    for file in [settings.pdf, *others]:
        shutil.copyfile(file, new / file.name)
    names = [settings.pdf.name, "data/values.csv", "data/results.json", *(file.name for file in others)]
    links = " ".join(f'<a href="{html.escape(name)}">{html.escape(Path(name).name)}</a>' for name in names)
    (new / "index.html").write_text(page.replace("</main>", f'<p class="files">{links}</p>\n</main>'))
    new.rename(site)
    return end(settings, site)
