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
from dataclasses import dataclass, field
from pathlib import Path

from errors import Disproved, progress, run_tool

# Under a memory limit g++ collects garbage so often that Eigen takes 50 % longer to compile, unless its heap may grow to 200 MB.
FLAGS = ["-std=c++20", "-O2", "-pipe", "--param=ggc-min-heapsize=200000", "-I/usr/include/eigen3", "-fmax-errors=10",
         "-ftemplate-backtrace-limit=4"]
LIBRARIES = ["-lgsl", "-lgslcblas", "-lm"]
LINK_SECONDS = 5
MAX_MESSAGE = 3000  # characters of a compiler error in the feedback


def hash_of(*parts):
    digest = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else str(part).encode()
        digest.update(len(data).to_bytes(8, "big") + data)
    return digest.hexdigest()[:24]


def write(files, folder):
    """Writes files, {name: text or bytes}, to a folder."""
    for name, content in files.items():
        path = Path(folder, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())


class Kit:
    """The handout, built once by its own CMakeLists.txt. Its objects are the stubs of the exercises and the provided code."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.key, self.log = ((self.folder / name).read_text(encoding="utf-8") for name in ("key", "log"))
        objects = self.folder.glob("build/CMakeFiles/*.dir/provided/**/*.o")
        self.given = sorted(path.relative_to(self.folder).as_posix() for path in objects if "checks.dir" not in path.parts)

    @classmethod
    def built(cls, folder, handout, jobs):
        """Returns the kit in this folder. Builds it first unless it was built from the same handout, {name: text}."""
        code = {name: text for name, text in sorted(handout.items()) if name.endswith((".cpp", ".hpp", ".txt"))}
        compiler = subprocess.run(["g++", "--version"], capture_output=True, check=False).stdout
        key = hash_of(compiler, FLAGS, code)
        if not Path(folder, "key").exists() or cls(folder).key != key:
            shutil.rmtree(folder, ignore_errors=True)
            write(code, folder)
            progress("building the handout", 0, 1)
            log = run_tool(["cmake", "-B", "build"], folder, Disproved)
            log += run_tool(["cmake", "--build", "build", "--parallel", str(jobs)], folder, Disproved)
            write({"log": log, "key": key}, folder)
        return cls(folder)


@dataclass
class Built:
    programs: dict = field(default_factory=dict)  # {exercise id: the folder that contains `program`}
    errors: dict = field(default_factory=dict)  # {exercise id: why its file was left out}


class Builder:
    def __init__(self, assignment, kit, sandbox, store):
        self.assignment, self.kit, self.sandbox, self.store = assignment, kit, sandbox, Path(store)

    def build(self, files):
        """Builds the programs of all exercises from a submission's files, {name: bytes}."""
        built, objects, undefined, defined = Built(), {}, {}, {}
        for exercise in self.assignment.exercise:
            if exercise.file not in files:
                built.errors[exercise.id] = f"{exercise.file} was not submitted"
                continue
            folder = self.compile(exercise, files[exercise.file], built)
            if exercise.id not in built.errors:
                objects[exercise.id] = folder / "object.o"
                symbols = [line.split()[:2] for line in (folder / "symbols").read_text().splitlines()]
                undefined[exercise.id] = {name for name, kind in symbols if kind == "U"}
                defined[exercise.id] = {name for name, kind in symbols if kind != "U"}
        linked = []
        for exercise in self.assignment.exercise:
            if exercise.id not in objects:
                continue
            needed = self.assignment.exercises_behind(exercise)
            own = [exercise.id]
            for earlier in reversed(linked):
                if earlier in needed or any(undefined[id] & defined[earlier] for id in own):
                    own.append(earlier)
            folder = self.link({id: objects[id] for id in own}, exercise, built)
            if exercise.id not in built.errors:
                built.programs[exercise.id] = folder
                linked.append(exercise.id)
        return built

    def compile(self, exercise, text, built):
        """Compiles one file. Returns the folder with object.o and `symbols`, the list of names that it defines or needs."""
        seconds = self.assignment.limits.compile_seconds
        includes = [f"-I{self.sandbox.kit}/{name}" for name in ("src", "provided")]
        words = ["g++", *FLAGS, *includes, "-c", exercise.file, "-o", "object.o"]
        script = '"$@" && nm --extern-only --format=posix object.o > symbols'
        return self.run_job({exercise.file: text}, ["sh", "-c", script, "sh", *words], seconds, exercise, built)

    def link(self, own, exercise, built):
        """Links the program of an exercise from these objects, {exercise id: file}, and stubs for all other exercises."""
        inputs, objects = {}, []
        for other in self.assignment.exercise:
            if other.id in own:
                inputs[f"{other.id}.o"] = own[other.id].read_bytes()
            objects.append(f"{other.id}.o" if other.id in own else f"{self.sandbox.kit}/build/CMakeFiles/exercise.dir/{other.file}.o")
        given = [f"{self.sandbox.kit}/{name}" for name in self.kit.given]
        folder = self.run_job(inputs, ["g++", *objects, *given, *LIBRARIES, "-o", "program"], LINK_SECONDS, exercise, built)
        if exercise.id in built.errors:
            built.errors[exercise.id] = f"{exercise.file} does not link:\n{built.errors[exercise.id]}"
        return folder

    def run_job(self, inputs, words, seconds, exercise, built):
        """Returns the folder with a job's result. Runs the job unless the store has it. Records a failure in built.errors."""
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
            built.errors[exercise.id] = (folder / "error").read_text(encoding="utf-8")
        return folder

    def message(self, text, seconds):
        """Returns the message for the student when the compiler or linker failed with this text."""
        lines = text.replace(f"{self.sandbox.kit}/", "").splitlines()
        text = printable("\n".join(line for line in lines if not line.startswith("                 from ")))[:MAX_MESSAGE].strip()
        if not text or "CPU time limit exceeded" in text or "Killed" in text:
            return f"compiling takes more than {seconds} s or too much memory"
        if "No such file or directory" in text and '#include "' in text:
            text += "\nOnly the files of the exercises are graded; move your code from other files into them."
        return text


def printable(text):
    """Replaces characters that control a terminal or reverse the direction of text."""
    return "".join(c if c in "\n\t" or c.isprintable() else "?" for c in text)
