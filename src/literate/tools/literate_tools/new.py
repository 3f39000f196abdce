# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a new paper that builds at once, about a pendulum; replace it by your own work. The program is in C++. With --python it is
a script, which needs no compiler if the engine is installed.

examples:
  literate new mypaper && cd mypaper && make
  literate new --python ~/papers/cooling
"""

import re
from pathlib import Path

from literate_tools.common import ENGINE, Failure, git, parser

TEMPLATE_NAME, TEMPLATE_ADDRESS, TEMPLATE_COMMIT = "mypaper", "ADDRESS-OF-THE-ENGINE", "COMMIT-OF-THE-ENGINE"


def run(arguments: list[str]) -> int:
    """Writes the folder."""
    arguments_of = parser("new", __doc__)
    arguments_of.add_argument("folder", type=Path, help="the new folder, whose name becomes that of the paper")
    arguments_of.add_argument("--python", action="store_true", help="compute with a Python script")
    given = arguments_of.parse_args(arguments)
    folder, name = given.folder.absolute(), given.folder.absolute().name
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_-]*", name):
        raise Failure(f"{name}: the name of a paper consists of letters, digits, - and _, and begins with a letter")
    if folder.exists() and any(folder.iterdir()):
        raise Failure(f"{folder}: this folder exists and is not empty")
    for part in ("common", "python" if given.python else "cpp"):
        copy(ENGINE / "template" / part, folder, name)
    (folder / ".engine").write_text(f"{ENGINE}\n")
    (folder / ".gitignore").write_text("/build/\n/.engine\n__pycache__/\n")
    print(f"{given.folder}: cd there and run make; README.md describes the files")
    return 0


def copy(template: Path, folder: Path, name: str) -> None:
    """Copies a part of the template with the name of the paper."""
    address, commit = git(ENGINE, "remote", "get-url", "origin"), git(ENGINE, "rev-parse", "HEAD")
    if not address or not commit or not re.match(r"\w+://|\w+@", address):  # installed, or cloned from a local folder
        address, commit = TEMPLATE_ADDRESS, TEMPLATE_COMMIT
    for path in filter(Path.is_file, template.rglob("*")):
        target = folder / str(path.relative_to(template)).replace(TEMPLATE_NAME, name)
        target.parent.mkdir(parents=True, exist_ok=True)
        text = path.read_text().replace(TEMPLATE_NAME, name)
        target.write_text(text.replace(TEMPLATE_ADDRESS, address).replace(TEMPLATE_COMMIT, commit))
