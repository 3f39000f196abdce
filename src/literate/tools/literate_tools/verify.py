# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the paper again from a clean clone of its commit, in a path with a blank and with a different time zone, locale and
umask. PDF and generated files must have the same bytes. With --manifest it compares the results with those of a build
elsewhere: numbers must agree within the sum of both errors, and verdicts must be equal. With --files it builds nothing, and
compares the files on this machine with the SHA-256 in a manifest.

examples:
  literate verify build/mypaper.json
  literate verify build/mypaper.json --manifest theirs.manifest.json
  literate verify build/mypaper.json --files build/mypaper/mypaper.manifest.json
"""

import json
import os
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from literate_tools.changes import compare
from literate_tools.common import Failure, git, parser, quiet_run, sha256
from literate_tools.settings import Settings, configure, read_results, read_settings

ELSEWHERE = {"TZ": "Asia/Kolkata", "LC_ALL": "de_DE.UTF-8"}


def run(arguments: list[str]) -> int:
    """Prints the differences; returns 1 if there are any."""
    arguments_of = parser("verify", __doc__)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("--manifest", type=Path, metavar="FILE", help="compare with these results")
    arguments_of.add_argument("--files", type=Path, metavar="FILE", help="compare hashes with this manifest")
    given = arguments_of.parse_args(arguments)
    settings = read_settings(given.settings)
    if given.files:
        differences = different_files(settings, read_manifest(given.files))
        success = "all files have the hashes of the manifest"
    elif given.manifest:
        changes = compare(read_results(given.manifest), read_results(settings.generated / "results.json"))
        differences = [f"{one.change} {one.part} {one.name}: {one.before} there, {one.after} here"
                       for one in changes if one.change != "within"]
        success = f"the same results; different within their errors: {len(changes)}"
    else:
        differences = built_elsewhere(settings)
        success = "the same bytes"
    for line in differences:
        print(line)
    if not differences:
        print(f"{settings.name}: {success}")
    return 1 if differences else 0


def read_manifest(file: Path) -> dict[str, Any]:
    """Reads a manifest."""
    read_results(file)  # fails for anything else
    manifest: dict[str, Any] = json.loads(file.read_text())
    if "outputs" not in manifest:
        raise Failure(f"{file}: these are results without a manifest")
    return manifest


def different_files(settings: Settings, manifest: dict[str, Any]) -> list[str]:
    """Returns the files that are missing or have a different SHA-256."""
    found = []
    for base, part in ((settings.source, "sources"), (settings.output, "outputs")):
        for name, digest in manifest[part].items():
            if not (base / name).is_file():
                found.append(f"{settings.shown(base / name)}: missing")
            elif sha256(base / name) != digest:
                found.append(f"{settings.shown(base / name)}: different")
    return found


def built_elsewhere(settings: Settings) -> list[str]:
    """Builds the paper in a clone and returns the differences."""
    here = read_manifest(settings.output / f"{settings.name}.manifest.json")
    root = git(settings.source, "rev-parse", "--show-toplevel")
    if root is None or git(settings.source, "rev-parse", "HEAD") is None:
        raise Failure(f"{settings.source}: verify needs a git repository with a commit")
    if edited := git(settings.source, "status", "--porcelain", "--untracked-files=no"):
        raise Failure(f"commit first, since a clone would not have these changes:\n{edited}")
    with TemporaryDirectory(prefix="literate ") as folder:
        clone = Path(folder, "a clone")
        options = {"env": os.environ | ELSEWHERE, "umask": 0o077}
        quiet_run(["git", "clone", "--quiet", "--no-hardlinks", root, str(clone)], "git clone", **options)
        source = clone / settings.source.relative_to(root)
        build, output = source / "build" / "verify", source / "build" / settings.name
        configure(settings, source, build, output, **options)
        quiet_run(["ninja", "-C", str(build), f"{settings.name}-pdf"], "building the clone", **options)
        there = read_manifest(output / f"{settings.name}.manifest.json")
    names = sorted(here["outputs"].keys() | there["outputs"].keys())
    found = [f"{name}: different bytes" for name in names if here["outputs"].get(name) != there["outputs"].get(name)]
    found += [f"{one.change} {one.part} {one.name}: {one.before} here, {one.after} there"
              for one in compare(here["results"], there["results"])]
    return found
