# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the verb and runs it. Imports only that verb's module, to start fast: a build runs many verbs."""

import importlib
import sys

from literate_tools.common import Failure, nearest

VERBS = {
    "new": "write a new paper that builds at once",
    "check": "find typed numbers, unused names and wrong quotations",
    "changes": "list the changes since a commit or a different results.json",
    "severity": "plant faults and record which claims or tests detect them",
    "verify": "build the paper again elsewhere and compare every byte",
    "html": "convert the paper into a web page: one file that loads nothing",
    "site": "fill a folder for a web server: page, PDF and data",
    "dist": "pack the sources of the document for arXiv or a journal",
    "case": "compute, draw and typeset one case into a folder",
    "cases": "do this for several cases and put their results into one table",
}
# Verbs in the module of a different verb or noun, which has a function with the name of the verb.
HOME = {"case": "cases", "site": "html", "repository": "manifest", "verdict": "settings"}
RULES = ("build", "compute", "draw", "repository", "typeset", "verdict")  # Make and Ninja call these.
EXIT_CODES = "Exit codes: 0 done, 1 a check, claim or comparison failed, 2 bad input, 3 a tool failed."


def usage() -> str:
    """Returns the output of `literate --help`."""
    lines = ["usage: literate VERB [ARGUMENT …]; literate VERB --help shows its arguments and examples", ""]
    return "\n".join([*lines, *(f"  {verb:<11} {what}" for verb, what in VERBS.items()), "", EXIT_CODES])


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
        module = importlib.import_module(f"literate_tools.{HOME.get(verb, verb)}")
        return int(getattr(module, verb if verb in HOME else "run")(arguments[1:]))
    except Failure as failure:
        print(failure, file=sys.stderr)
        return failure.code
    except KeyboardInterrupt:
        return 130
    except OSError as error:
        print(f"literate {verb}: {error.filename or ''}: {error.strerror or error}", file=sys.stderr)
        return 3
