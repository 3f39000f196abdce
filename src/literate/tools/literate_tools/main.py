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
# The rules of the build. Make and Ninja call them.
RULES = {
    "build": "run Ninja and print what matters",
    "compute": "run the program or script",
    "draw": "run gnuplot for one figure",
    "repository": "record the commit for \\papercommit",
    "typeset": "run LaTeX until nothing changes, then write PDF and manifest",
    "verdict": "fail if a check or claim failed",
    "engine": "print the folder of the engine",
}
EXIT_CODES = "Exit codes: 0 done, 1 a check, claim or comparison failed, 2 bad input, 3 a tool failed."


def usage() -> str:
    """Returns the output of `literate --help`."""
    lines = ["usage: literate VERB [ARGUMENT …]; literate VERB --help shows its arguments and examples", ""]
    lines += [f"  {verb:<11} {what}" for verb, what in VERBS.items()]
    lines += ["", "The build calls these:", ""]
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
    except BrokenPipeError:  # the reader, such as `head`, stopped
        sys.stderr.close()
        return 0
    except OSError as error:
        print(f"literate {verb}: {error.filename or ''}: {error.strerror or error}", file=sys.stderr)
        return 3
