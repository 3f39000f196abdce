# SPDX-License-Identifier: GPL-3.0-or-later
"""Planted faults: their list, their text in a file, a copy of a checkout to plant them in, and its build."""

import os
import re
import shutil
import subprocess
import time
import tomllib
from pathlib import Path

NEEDED, OPTIONAL = {"id", "wrong", "file", "before", "after"}, {"occurrence", "noticed_by"}


class ListError(Exception):
    """The list is wrong, or the checkout is red before any fault is planted."""


def read_list(file, root):
    """Returns the folders «computes» and the faults, each with its line, after checking them against the checkout."""
    shown = os.path.relpath(file, root) if file.is_relative_to(root) else file
    try:
        text = file.read_text()
        listed = tomllib.loads(text)
        faults = listed["mutant"]
    except (OSError, tomllib.TOMLDecodeError, KeyError) as error:
        raise ListError(f"{shown}: {error}") from None
    computes = listed.get("computes", [])
    for name in computes:
        if not (root / name).exists():
            raise ListError(f"{shown}: computes: there is no {name}")
    lines = [i + 1 for i, line in enumerate(text.splitlines()) if line.strip() == "[[mutant]]"]
    ids = set()
    for fault, line in zip(faults, lines, strict=True):
        name = f"{shown}:{line}: mutant '{fault.get('id', '?')}'"
        if missing := NEEDED - fault.keys():
            raise ListError(f"{name}: {', '.join(sorted(missing))} missing")
        if unknown := fault.keys() - NEEDED - OPTIONAL:
            raise ListError(f"{name}: unknown key {', '.join(sorted(unknown))}")
        if fault["id"] in ids:
            raise ListError(f"{name}: there are two of this name")
        ids.add(fault["id"])
        fault["name"] = name
        planted(fault, root)
    return computes, faults


def planted(fault, root):
    """Returns the text of the fault's file with the fault in it."""
    file = root / fault["file"]
    if not file.is_file():
        raise ListError(f"{fault['name']}: there is no file {fault['file']}")
    parts = file.read_text().split(fault["before"])
    found, wanted = len(parts) - 1, fault.get("occurrence")
    if wanted is None and found != 1:
        raise ListError(f"{fault['name']}: its text stands {found} times in {fault['file']}, not once")
    if wanted is not None and not 1 <= wanted <= found:
        raise ListError(f"{fault['name']}: occurrence {wanted} of {found} in {fault['file']}")
    at = wanted or 1
    mutated = fault["before"].join(parts[:at]) + fault["after"] + fault["before"].join(parts[at:])
    if mutated == fault["before"].join(parts):
        raise ListError(f"{fault['name']}: changes nothing")
    return mutated


def files_of_checkout(root):
    """Returns all files that git does not ignore; without git all but those of build."""
    listed = subprocess.run(["git", "-C", root, "ls-files", "-coz", "--exclude-standard"], capture_output=True)
    if listed.returncode == 0 and (root / ".git").exists():
        names = listed.stdout.decode().split("\0")
    else:
        names = [str(file.relative_to(root)) for file in root.rglob("*") if file.is_file()]
        names = [name for name in names if Path(name).parts[0] not in ("build", ".git")]
    return {name for name in names if name and (root / name).is_file()}


def copy_checkout(root, tree):
    """Copies the files that changed and no others, so that a second run compiles little."""
    names = files_of_checkout(root)
    for name in names:
        write(tree / name, (root / name).read_bytes())
        shutil.copymode(root / name, tree / name)
    for file in [file for file in tree.rglob("*") if file.is_file()]:
        if str(file.relative_to(tree)) not in names:
            file.unlink()


def write(file, content):
    if not file.is_file() or file.read_bytes() != content:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)


def run(command, seconds=None, folder=None):
    """Returns the exit status, None if the command took too long, and what it said."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=seconds)
        return done.returncode, done.stdout + done.stderr
    except subprocess.TimeoutExpired:
        return None, f"longer than {seconds} s"


def configure(tree, folder, *flags):
    """Configures with -O1, because programs that run once need not be fast, and -w, because a fault may leave a
    parameter unused."""
    cache = folder / "CMakeCache.txt"
    if cache.exists() and f"CMAKE_HOME_DIRECTORY:INTERNAL={tree}\n" not in cache.read_text():
        flags += ("--fresh",)  # the checkout was moved, and the cache still means the old place
    status, said = run(["cmake", "-S", tree, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG -w", "-DCMAKE_UNITY_BUILD=ON", *flags])
    if status != 0:
        raise ListError(f"the copy of the checkout cannot be configured\n{said}")


def build(folder, targets):
    """Returns the compiler's messages; empty if the build succeeded."""
    status, said = run(["cmake", "--build", folder, "--target", *targets])
    return "" if status == 0 else re.sub(r"^\[\d.*\n", "", said, flags=re.MULTILINE)


def tell(what, begin, outcome):
    print(f"{what:<24} {time.monotonic() - begin:6.1f} s  {outcome}", flush=True)
