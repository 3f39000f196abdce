# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the verb and runs it. A verb's module is imported only when it is used: a build starts many."""

import importlib
import sys

from literate_tools.common import Failure, nearest

VERBS = {
    "new": "write a new paper that builds at once",
    "check": "find typed numbers, unused names and altered quotations",
    "changes": "list what changed since a commit or a different results.json",
    "severity": "plant faults and record which claims or tests notice them",
    "verify": "build the paper again elsewhere and compare every byte",
    "html": "make the paper a web page: one file that loads nothing",
    "site": "make a folder for a web server: page, PDF and data",
    "dist": "pack the sources of the document as arXiv and journals take them",
    "case": "compute, draw and typeset one case into a folder",
    "cases": "do so for several cases and put their results into one table",
}
# The rules of the build; Make and CMake calls them with the settings of a paper.
RULES = {
    "build": "run Ninja and print what matters",
    "compute": "run the program or script",
    "draw": "run gnuplot for one figure",
    "repository": "record the commit for \\papercommit",
    "typeset": "run LaTeX until nothing changes, then publish PDF and manifest",
    "verdict": "end with 1 as long as a check or claim fails",
    "engine": "print the folder of the engine",
}
EXIT_CODES = "Exit codes: 0 done, 1 a check, claim or comparison failed, 2 bad input, 3 a tool failed."


def usage() -> str:
    """Returns what `literate --help` prints."""
    lines = ["usage: literate VERB [ARGUMENT …]; literate VERB --help shows its arguments and examples", ""]
    lines += [f"  {verb:<11} {what}" for verb, what in VERBS.items()]
    lines += ["", "The build itself calls these:", ""]
    lines += [f"  {verb:<11} {what}" for verb, what in RULES.items()]
    return "\n".join([*lines, "", EXIT_CODES])


def main(arguments: list[str]) -> int:
    """Runs one verb and returns the exit code."""
    verb = arguments[0] if arguments else ""
    if verb in ("-h", "--help"):
        print(usage())
        return 0
    try:
        if verb not in VERBS and verb not in RULES:
            raise Failure(f"literate: unknown verb '{verb}'{nearest(verb, [*VERBS, *RULES])}; "
                          "'literate --help' lists them" if verb else usage())
        return importlib.import_module(f"literate_tools.{verb}").run(arguments[1:])
    except Failure as failure:
        print(failure, file=sys.stderr)
        return failure.code
    except KeyboardInterrupt:
        return 130
    except BrokenPipeError:  # the reader, such as `head`, has seen enough
        sys.stderr.close()
        return 0
    except OSError as error:
        print(f"literate {verb}: {error.filename or ''}: {error.strerror or error}", file=sys.stderr)
        return 3
