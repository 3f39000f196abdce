# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists and reads the files of the repository."""
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def files(*folders: str) -> list[str]:
    """Lists the files below these folders, or all files: those that git tracks, or in an unpacked archive all that exist."""
    listed = subprocess.run(["git", "ls-files", "-z", "--", *folders], cwd=ROOT, capture_output=True, text=True)
    if listed.returncode == 0:
        return [name for name in listed.stdout.split("\0") if name and (ROOT / name).is_file()]
    found = (path for folder in folders or (".",) for path in (ROOT / folder).rglob("*"))
    names = (path.relative_to(ROOT).as_posix() for path in found if path.is_file())
    return sorted(name for name in names if not name.startswith("build/"))


def text(name: str) -> str:
    """Returns the text of a file; empty for binary files."""
    try:
        return (ROOT / name).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return ""
