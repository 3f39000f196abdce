# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the submissions of a class, and reads the files of the exercises from each.

Submissions are folders or zips in one folder, or are in the zip that Moodle or Canvas provides. Only files with the expected
names are read, each up to the size limit. Nothing is unpacked, and links are not followed.
"""
import io
import os
import re
import stat
import zipfile
import zlib
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path, PurePosixPath
from typing import IO

from assignment import Assignment
from errors import BadInput

MAX_ZIP_KB = 50 << 10  # of one student's zip
ID = re.compile(r"[^\W_][\w .@+-]{0,99}")  # can name a folder, and is not a formula in a spreadsheet
# Both systems put a number of the student into the name: Moodle the one in its worksheet, Canvas the "ID" in its gradebook.
# Canvas appends "-1", "-2" … to files that are submitted again.
MOODLE = re.compile(r"[^_]*_(?P<id>\d+)_assignsubmission_file_?(?P<rest>.*)")
CANVAS = re.compile(r"[^_]*(?:_LATE)?_(?P<id>\d+)_\d+_(?P<rest>.+?)(?:-\d+)?(?P<ending>\.\w+)")


@dataclass
class Member:
    """A file in a folder or a zip, not yet read."""
    path: PurePosixPath
    open: Callable[[], IO[bytes]] | None  # None for a link or a special file

    def read(self, max_kb: int) -> bytes:
        if self.open is None:
            raise BadInput(f"{self.path} is a link or a special file")
        try:
            with self.open() as stream:
                content = stream.read((max_kb << 10) + 1)
        except (OSError, EOFError, RuntimeError, NotImplementedError, zipfile.BadZipFile, zlib.error) as error:
            reason = "it needs a password" if "password" in str(error) else error
            raise BadInput(f"{self.path} cannot be read: {reason}") from None
        if len(content) > max_kb << 10:
            raise BadInput(f"{self.path} is larger than {max_kb} kB")
        return content


@dataclass
class Submission:
    id: str
    members: list[Member] = field(default_factory=list)
    problem: str = ""

    def read_files(self, assignment: Assignment) -> dict[str, bytes]:
        """Reads the files of the exercises, {name: bytes}. Raises BadInput if there are none, or if one occurs twice."""
        if self.problem:
            raise BadInput(self.problem)
        names = {PurePosixPath(exercise.file).name: exercise.file for exercise in assignment.exercise}
        members = self.members
        zips = [member for member in members if member.path.suffix.lower() == ".zip"]
        if len(zips) == 1 and not any(member.path.name in names for member in members):
            members = zip_members(io.BytesIO(zips[0].read(MAX_ZIP_KB)))
        candidates = [member for member in members if member.path.name in names]
        # Files in src take precedence over files with the same name elsewhere.
        files = {}
        for member in [member for member in candidates if member.path.parent.name == "src"] or candidates:
            name = names[member.path.name]
            if name in files:
                raise BadInput(f"{name} was submitted twice")
            files[name] = member.read(assignment.limits.file_kb)
        if not files:
            raise BadInput("none of the files " + ", ".join(names.values()) + " was submitted")
        return files


def folder_members(folder: Path) -> list[Member]:
    """Lists the files of a folder. Only regular files can be opened."""
    members = []
    for root, folders, names in os.walk(folder):
        for name in [*names, *(name for name in folders if Path(root, name).is_symlink())]:
            file = Path(root, name)
            is_plain = stat.S_ISREG(file.lstat().st_mode)
            members.append(Member(PurePosixPath(file.relative_to(folder).as_posix()), open_plain(file) if is_plain else None))
    return without_junk(members)


def open_plain(file: Path) -> Callable[[], IO[bytes]]:
    return lambda: open(os.open(file, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK), "rb")


def zip_members(source: Path | IO[bytes]) -> list[Member]:
    """Lists the files of a zip. Raises BadInput if the zip is damaged."""
    try:
        packed = zipfile.ZipFile(source)
    except (ValueError, NotImplementedError, zipfile.BadZipFile) as error:
        raise BadInput(f"the zip is damaged: {error}") from None
    members = []
    for info in packed.infolist():
        if not info.is_dir():
            path = PurePosixPath(info.filename.replace("\\", "/"))
            is_link = stat.S_ISLNK(info.external_attr >> 16)
            members.append(Member(path, None if is_link else partial(packed.open, info)))
    return without_junk(members)


def without_junk(members: list[Member]) -> list[Member]:
    """Leaves out hidden files, the files that macOS adds to zips, and text typed into Moodle."""
    junk = re.compile(r"\.[^.].*|__MACOSX|.*_assignsubmission_onlinetext.*")
    return [member for member in members if not any(junk.fullmatch(part) for part in member.path.parts)]


def submissions_in(source: Path) -> list[Submission]:
    """Finds the submissions in a folder or in the zip of a class, sorted by id."""
    try:
        members = folder_members(source) if source.is_dir() else zip_members(source)
    except BadInput as error:
        raise BadInput(f"{source}: {error}") from None
    found: dict[str, Submission] = {}
    entries: dict[str, str] = {}
    for member in sorted(members, key=lambda member: member.path):
        entry, *inner = member.path.parts
        id, own = id_and_own_name(entry)
        submission = found.setdefault(id, Submission(id))
        # Several entries belong to one student only if Moodle or Canvas named them.
        if entries.setdefault(id, entry) != entry and own is None:
            submission.problem = f"there are two submissions, {entries[id]} and {entry}"
        elif not ID.fullmatch(id):
            submission.problem = "its name is not an id: ids begin with a letter or digit and contain letters, digits, spaces and _.@+-"
        submission.members.append(Member(PurePosixPath(own or "", *inner) if own or inner else PurePosixPath(entry), member.open))
    for folder in source.iterdir() if source.is_dir() else []:
        if folder.is_dir() and not folder.name.startswith("."):
            id = id_and_own_name(folder.name)[0]
            found.setdefault(id, Submission(id))  # includes empty folders
    if not found:
        raise BadInput(f"{source}: this folder or zip contains no submissions")
    if "src" in found:
        raise BadInput(f"{source}: this is a single submission; give the folder that contains the submissions")
    return [found[id] for id in sorted(found)]


def id_and_own_name(entry: str) -> tuple[str, str | None]:
    """Returns the student's id from the name of an entry, and the student's own file name if Moodle or Canvas made the name."""
    if moodle := MOODLE.fullmatch(entry):
        return moodle["id"], moodle["rest"]
    if canvas := CANVAS.fullmatch(entry):
        return canvas["id"], canvas["rest"] + canvas["ending"]
    return re.sub(r"\.zip$", "", entry, flags=re.IGNORECASE), None
