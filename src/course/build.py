# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles each of a student's files separately, and links one program per exercise.

A file that does not compile or link is replaced by its stub. The program of an exercise contains the student's files for this
exercise and for the earlier exercises that it builds on or calls, and stubs for all others. So a mistake costs only its own
exercise.

Results are cached in a store: one folder per result, named by a hash of its inputs.
"""
import hashlib
import os
import shutil
import subprocess
import tempfile
import zipfile
from collections.abc import Mapping
from pathlib import Path

from assignment import Assignment, Exercise
from errors import Disproved, progress, run_tool
from sandbox import Sandbox

# Under a memory limit g++ collects garbage so often that Eigen takes 50 % longer to compile, unless its heap may grow to 200 MB.
FLAGS = ["-std=c++20", "-O2", "-pipe", "--param=ggc-min-heapsize=200000", "-I/usr/include/eigen3", "-fmax-errors=10",
         "-ftemplate-backtrace-limit=4"]
LIBRARIES = ["-lgsl", "-lgslcblas", "-lm"]
LINK_SECONDS = 5
MAX_MESSAGE = 3000  # characters of a compiler error in the feedback
Compiled = tuple[Path, set[str], set[str]]  # an object, the names that it needs, and the names that it defines


def hash_of(*parts: object) -> str:
    digest = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else str(part).encode()
        digest.update(len(data).to_bytes(8, "big") + data)
    return digest.hexdigest()[:24]


def write(files: Mapping[str, str | bytes], folder: str | Path) -> None:
    """Writes files, {name: text or bytes}, to a folder."""
    for name, content in files.items():
        path = Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())


def write_zip(files: Mapping[str, str | bytes], path: Path) -> None:
    """Writes files, {name: text or bytes}, to a zip. It depends on them alone, so all entries have the same date."""
    with zipfile.ZipFile(path, "w") as packed:
        for name, content in sorted(files.items()):
            data = content if isinstance(content, bytes) else content.encode()
            info = zipfile.ZipInfo(name)
            info.external_attr = (0o755 if data.startswith((b"#!", b"\x7fELF")) else 0o644) << 16
            packed.writestr(info, data, zipfile.ZIP_DEFLATED)


class Kit:
    """The handout, built once by its own CMakeLists.txt. Its objects are the stubs of the exercises and the provided code."""

    def __init__(self, folder: Path) -> None:
        self.folder = Path(folder)
        self.key, self.log = ((self.folder / name).read_text(encoding="utf-8") for name in ("key", "log"))
        objects = self.folder.glob("build/CMakeFiles/*.dir/provided/**/*.o")
        self.given = sorted(path.relative_to(self.folder).as_posix() for path in objects if "checks.dir" not in path.parts)

    @classmethod
    def built(cls, folder: Path, handout: dict[str, str], jobs: int) -> "Kit":
        """Returns the kit in this folder. Builds it first unless it was built from the same handout, {name: text}."""
        code = {name: text for name, text in sorted(handout.items()) if name.endswith((".cpp", ".hpp", ".txt"))}
        compiler = subprocess.run(["g++", "--version"], capture_output=True, check=False).stdout
        key = hash_of(compiler, FLAGS, code)
        if not Path(folder, "key").exists() or Path(folder, "key").read_text(encoding="utf-8") != key:
            shutil.rmtree(folder, ignore_errors=True)
            write(code, folder)
            progress("building the handout")
            log = run_tool(["cmake", "-B", "build"], folder, Disproved)
            log += run_tool(["cmake", "--build", "build", "--parallel", str(jobs)], folder, Disproved)
            write({"log": log, "key": key}, folder)
        return cls(folder)


class Failed(Exception):
    """A file was not submitted, or does not compile or link. The message is for the student."""


class Builder:
    def __init__(self, assignment: Assignment, kit: Kit, sandbox: Sandbox, store: str | Path) -> None:
        self.assignment, self.kit, self.sandbox, self.store = assignment, kit, sandbox, Path(store)

    def build(self, files: dict[str, bytes]) -> tuple[dict[str, Path], dict[str, str]]:
        """Builds a submission's files, {name: bytes}. Returns the folders that contain `program`, {exercise id: folder}, and why
        files were left out, {file: reason}."""
        programs: dict[str, Path] = {}
        objects, errors = {}, {}
        for exercise in self.assignment.exercise:
            try:
                objects[exercise.id] = self.compile(exercise, files)
                programs[exercise.id] = self.link(exercise, programs, objects)
            except Failed as error:
                errors[exercise.file] = str(error)
        return programs, errors

    def compile(self, exercise: Exercise, files: dict[str, bytes]) -> Compiled:
        """Compiles the file of an exercise. Returns the object, the names that it needs, and the names that it defines."""
        if exercise.file not in files:
            raise Failed(f"{exercise.file} was not submitted")
        includes = [f"-I{self.sandbox.kit}/{name}" for name in ("src", "provided")]
        words = ["g++", *FLAGS, *includes, "-c", exercise.file, "-o", "object.o"]
        script = '"$@" && nm --extern-only --format=posix object.o > symbols'
        folder = self.run_job({exercise.file: files[exercise.file]}, ["sh", "-c", script, "sh", *words],
                              self.assignment.limits.compile_seconds)
        symbols = [line.split()[:2] for line in (folder / "symbols").read_text().splitlines()]
        needed = {name for name, kind in symbols if kind == "U"}
        return folder / "object.o", needed, {name for name, _ in symbols} - needed

    def link(self, exercise: Exercise, earlier: dict[str, Path], objects: dict[str, Compiled]) -> Path:
        """Links the program of an exercise: its object, those of the earlier exercises that it builds on or calls, and stubs."""
        behind = self.assignment.exercises_behind(exercise)
        own = [exercise.id]
        for id in reversed(earlier):
            if id in behind or any(objects[other][1] & objects[id][2] for other in own):
                own.append(id)
        words = [f"{other.id}.o" if other.id in own else f"{self.sandbox.kit}/build/CMakeFiles/exercise.dir/{other.file}.o"
                 for other in self.assignment.exercise]
        words += [f"{self.sandbox.kit}/{name}" for name in self.kit.given]
        try:
            return self.run_job({f"{id}.o": objects[id][0].read_bytes() for id in own}, ["g++", *words, *LIBRARIES, "-o", "program"],
                                LINK_SECONDS)
        except Failed as error:
            raise Failed(f"{exercise.file} does not link:\n{error}") from None

    def run_job(self, inputs: Mapping[str, bytes], words: list[str], seconds: int) -> Path:
        """Returns the folder with a job's result. Runs the job unless the store has it. Raises Failed if the job fails."""
        key = hash_of(self.kit.key, [word.replace(self.sandbox.kit, "KIT") for word in words], inputs)
        folder = self.store / key
        if not folder.exists():
            # The job may write to its own folder, but not to the store, which holds the results of other jobs.
            new = Path(tempfile.mkdtemp(prefix=".", dir=self.store))
            write(inputs, new)
            os.chmod(new, 0o777)
            status, text = self.sandbox.run(words, new, seconds, self.sandbox.clock)
            os.chmod(new, 0o755)
            if status != 0:
                write({"error": self.message(text, seconds)}, new)
            try:
                new.rename(folder)
            except OSError:  # a different thread has stored the same result meanwhile
                shutil.rmtree(new)
        if (folder / "error").exists():
            raise Failed((folder / "error").read_text(encoding="utf-8"))
        return folder

    def message(self, text: str, seconds: int) -> str:
        """Returns the message for the student when the compiler or linker failed with this text."""
        lines = text.replace(f"{self.sandbox.kit}/", "").splitlines()
        text = printable("\n".join(line for line in lines if not line.startswith("                 from ")))[:MAX_MESSAGE].strip()
        if not text or "CPU time limit exceeded" in text or "Killed" in text:
            return f"compiling takes more than {seconds} s or too much memory"
        if "No such file or directory" in text and '#include "' in text:
            text += "\nOnly the files of the exercises are graded; move your code from other files into them."
        return text


def printable(text: str) -> str:
    """Replaces characters that control a terminal or reverse the direction of text."""
    return "".join(c if c in "\n\t" or c.isprintable() else "?" for c in text)
