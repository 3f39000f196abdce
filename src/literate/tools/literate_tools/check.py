# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists what a reader or a referee would object to in a built paper: typed numbers, names that nothing prints, unknown names in
branches that are not taken, undefined references, and with --paper, quotations that are not in the text of the quoted paper
(which pdftotext can extract). Exits with 1 if there are findings.

examples:
  literate check build/mypaper.json
  literate check build/mypaper.json --paper ruggiero2001.txt
"""

import re
from pathlib import Path
from typing import Any

from literate_tools import latex_log
from literate_tools.common import Failure, nearest, parser
from literate_tools.settings import Settings, read_results, read_settings
from literate_tools.typed_numbers import typed_in_script, typed_numbers
from literate_tools.uses import NAMED, Use, document_texts, names_in, read_uses

SHAPES = {"ﬁ": "fi", "ﬂ": "fl", "ﬀ": "ff", "ﬃ": "ffi", "’": "'", "‘": "'", "``": '"', "''": '"', "“": '"', "”": '"'}
SINGULAR = {"values": "value", "flags": "flag", "tables": "table", "figures": "figure", "claims": "claim"}


def run(arguments: list[str]) -> int:
    """Prints the findings; returns 1 if there are any."""
    arguments_of = parser("check", __doc__)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("--paper", type=Path, metavar="TEXT", help="the quoted text")
    given = arguments_of.parse_args(arguments)
    settings = read_settings(given.settings)
    results = read_results(settings.generated / "results.json")
    texts, uses = document_texts(settings), read_uses(settings)
    findings = [*typed(settings, texts), *unknown(settings, results, texts), *idle_scripts(settings, results),
                *unused(results, texts, uses), *latex_log.warnings(settings), *results["failed"]]
    if given.paper:
        findings += altered_quotations(uses, given.paper)
    for finding in dict.fromkeys(findings):
        print(finding)
    return 1 if findings else 0


def typed(settings: Settings, texts: dict[Path, str]) -> list[str]:
    """Returns the numbers typed into the prose and the scripts of the figures."""
    found = [(path, "%", line, number) for path in texts for line, number in typed_numbers(path.read_text(errors="replace"))]
    found += [(path, "#", line, number) for path in settings.scripts for line, number in typed_in_script(path.read_text())]
    return [f"{settings.shown(path)}:{line}: {number} is typed: register it, or end the line with "
            f"'{sign} constant: reason' if it is not a result" for path, sign, line, number in found]


def unknown(settings: Settings, results: dict[str, Any], texts: dict[Path, str]) -> list[str]:
    """Returns the names that the program does not register. LaTeX does not see those in branches that are not taken."""
    found = [(path, line, NAMED[command], name) for path, text in texts.items() for command, name, line in names_in(text)]
    return [f"{settings.shown(path)}:{line}: unknown {SINGULAR[part]} '{name}'{nearest(name, list(results[part]))}"
            for path, line, part, name in found if name not in results[part] and "#" not in name]


def idle_scripts(settings: Settings, results: dict[str, Any]) -> list[str]:
    """Returns the scripts whose figure the program does not register."""
    return [f"{settings.shown(script)}: unknown figure '{script.stem}'{nearest(script.stem, list(results['figures']))}"
            for script in settings.scripts if script.stem not in results["figures"]]


def unused(results: dict[str, Any], texts: dict[Path, str], uses: list[Use]) -> list[str]:
    """Returns the registered names that nothing prints, and the claims without a sentence."""
    used = {(NAMED[use.kind], use.name) for use in uses if use.kind in NAMED and use.kind != "statement"}
    stated = {use.name for use in uses if use.kind == "statement"}
    for text in texts.values():
        found = names_in(text)
        used |= {(NAMED[command], name) for command, name, _ in found if command != "statement"}
        stated |= {name for command, name, _ in found if command == "statement"}
    findings = [f"{entry['place']}: {SINGULAR[part]} '{name}' is printed nowhere"
                for part in SINGULAR for name, entry in results[part].items() if (part, name) not in used]
    return findings + [f"{entry['place']}: claim '{name}' has no \\statement"
                       for name, entry in results["claims"].items() if name not in stated]


def altered_quotations(uses: list[Use], paper: Path) -> list[str]:
    """Returns the quotations that the quoted text does not contain."""
    try:
        text = plain(paper.read_text(errors="replace"))
    except OSError as error:
        raise Failure(f"{paper}: {error.strerror}") from None
    return [f"{use.place}: {paper.name} does not contain “{use.name}”" for use in uses
            if use.kind == "quoted" and not all(plain(part) in text for part in re.split(r"\\[lc]?dots|…|\[[^]]*\]", use.name))]


def plain(text: str) -> str:
    """Returns a text without blanks, hyphens and markup, with plain quotes and letters in place of ligatures."""
    text = re.sub(r"\\(?:[,;:!/ -]|[A-Za-z]+\s*)|[{}$~\\]", " ", text)
    for shape, letters in SHAPES.items():
        text = text.replace(shape, letters)
    return re.sub(r"[\s\-–—\u00ad]", "", text).casefold()
