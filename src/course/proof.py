# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves five claims about the handout. A claim is proved again only when something that it depends on has changed."""
import re
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from assignment import Assignment, dataclass_from, read_toml
from build import Kit, hash_of
from errors import BadInput, Disproved, progress, run_tool
from grading import Graded, Grader, Judge
from sandbox import Sandbox
from template import Divided

if TYPE_CHECKING:
    from course import Course

IDS = [f"student{number}" for number in range(1, 21)]


@dataclass(frozen=True)
class Wrong:
    """The solution with a mistake, and the points that it must score."""
    id: str
    description: str
    points: float
    change: list[dict[str, str]]  # tables with file, before, after


def read_wrong_solutions(file: Path, solution: dict[str, bytes]) -> list[tuple[Wrong, dict[str, bytes]]]:
    """Reads the wrong solutions. Returns pairs of Wrong and the files of the solution with this mistake."""
    found = []
    for entry in read_toml(file).get("wrong", []):
        where = f"{file}: '{entry.get('id', '?')}'"
        if "file" in entry:
            entry["change"] = [{key: entry.pop(key, "") for key in ("file", "before", "after")}]
        wrong = dataclass_from(Wrong, entry, where)
        files = dict(solution)
        for change in wrong.change:
            name, before, after = change["file"], change["before"], change["after"]
            occurrences = solution.get(name, b"").count(before.encode())
            if occurrences != 1:
                raise BadInput(f"{where}: 'before' occurs {occurrences} times in {name} instead of once")
            files[name] = files[name].replace(before.encode(), after.encode())
        found.append((wrong, files))
    return found


def with_points(text: str, points: dict[str, float]) -> str:
    """Replaces the points in the text of the list by these, {id: points}. Everything else stays as it is."""
    parts = re.split(r"(?m)^(id = \"(.+)\"\n(?:.*\n)*?points = )([\d.]+)", text)
    for i in range(1, len(parts), 4):
        parts[i + 2] = f"{points[parts[i + 1]]:g}"
        parts[i + 1] = ""
    return "".join(parts)


class Proof:
    """Proves the claims about the handout of a Course, and prints each claim that holds."""

    def __init__(self, course: "Course", judge: Judge, sandbox_class: type[Sandbox], jobs: int) -> None:
        self.course, self.assignment, self.handout = course, course.assignment, course.handout
        self.judge, self.sandbox_class, self.jobs = judge, sandbox_class, jobs
        self.files = [exercise.file for exercise in self.assignment.exercise]
        self.store = course.work / "store"
        self.store.mkdir(parents=True, exist_ok=True)
        self.kit = Kit.built(course.work / "kit", self.handout, jobs)
        sandbox_class(self.kit.folder, self.assignment.limits).require()

    def grade(self, files: dict[str, bytes], student: str = "", judge: Judge | None = None) -> Graded:
        # Each thread needs a separate sandbox, because a sandbox remembers the user of its latest job.
        sandbox = self.sandbox_class(self.kit.folder, self.assignment.limits)
        return Grader(self.assignment, self.kit, sandbox, judge or self.judge, self.store).grade(files, student)

    def sheet(self, inputs: dict[str, str], typeset: Callable[[dict[str, str]], bytes]) -> bytes:
        """Returns the sheet as a PDF. Typesets it only if one of its inputs has changed."""
        path = self.store / f"{hash_of('sheet', sorted(inputs.items()))}.pdf"
        if not path.exists():
            progress("typesetting the sheet")
            path.write_bytes(typeset(inputs))
        return path.read_bytes()

    def prove(self, secrets: dict[str, str], sheet: dict[str, str], update: bool) -> None:
        """Proves the five claims in order. Raises Disproved for the first one that does not hold."""
        solution = {name: self.course.project[name].solution.encode() for name in self.files}
        wrong_solutions = read_wrong_solutions(self.course.folder / "wrong_solutions.toml", solution)
        self.builds()
        print("1. the handout builds without warnings, and ctest lists every public check", flush=True)

        blank = self.grade({name: self.handout[name].encode() for name in self.files})
        if blank.points != 0 or blank.errors:
            raise Disproved(f"the untouched handout scores {blank.points:g} points, not 0 {first_error(blank)}")
        print("2. the untouched handout scores 0", flush=True)

        self.solution_scores_all(solution)
        print(f"3. the solution scores all {self.assignment.points:g} points, with the nominal numbers and with those of "
              f"{len(IDS)} ids", flush=True)

        self.wrong_solutions_score_as_listed(wrong_solutions, update)
        print(f"4. each of {len(wrong_solutions)} wrong solutions scores its listed points", flush=True)

        found = leaks({**self.handout, **sheet}, secrets)
        if found:
            raise Disproved("the handout contains secrets:\n" + "\n".join(found))
        print("5. no file contains a secret", flush=True)

    def builds(self) -> None:
        if "warning" in self.kit.log.lower():
            raise Disproved(f"the handout builds with warnings:\n{self.kit.log.strip()}")
        listed = run_tool(["ctest", "--test-dir", "build", "--show-only"], self.kit.folder)
        for check in self.assignment.checks:
            if check.is_public and not re.search(rf": {re.escape(check.id)}$", listed, re.MULTILINE):
                raise Disproved(f"ctest of the handout does not list the public check '{check.id}'")

    def solution_scores_all(self, solution: dict[str, bytes]) -> None:
        students = ["", *IDS]
        self.grade(solution)  # compiles the solution once, before the threads need it
        with ThreadPoolExecutor(self.jobs) as pool:
            for number, (student, graded) in enumerate(zip(students, pool.map(lambda id: self.grade(solution, id), students)), 1):
                progress("trying ids", number, len(students))
                if graded.points != self.assignment.points:
                    lost = [f"{result.check.id}: {result.points:g} of {result.check.points:g}: {result.message}"
                            for result in graded.results if result.points != result.check.points]
                    raise Disproved(f"with the numbers of '{student}' the solution scores {graded.points:g} points "
                                    f"{first_error(graded)}\n" + "\n".join(lost))

    def wrong_solutions_score_as_listed(self, listed: list[tuple[Wrong, dict[str, bytes]]], update: bool) -> None:
        file = self.course.folder / "wrong_solutions.toml"
        nominal = Judge(self.judge.program)  # without the salt, so that the listed points are the same for every salt
        points = {}
        with ThreadPoolExecutor(self.jobs) as pool:
            all_graded = pool.map(lambda entry: self.grade(entry[1], judge=nominal), listed)
            for number, ((wrong, _), graded) in enumerate(zip(listed, all_graded), 1):
                progress("wrong solutions", number, len(listed))
                if graded.errors:
                    raise Disproved(f"{file}: '{wrong.id}' {first_error(graded)}")
                points[wrong.id] = graded.points
        if update:
            file.write_text(with_points(file.read_text(encoding="utf-8"), points), encoding="utf-8")
            return
        differ = [f"'{wrong.id}' scores {points[wrong.id]:g} points instead of the listed {wrong.points:g}"
                  for wrong, _ in listed if points[wrong.id] != wrong.points]
        if differ:
            raise Disproved(f"{file}: " + "; ".join(differ) + ". If these points are correct, \"prove --update\" writes them")


def first_error(graded: Graded) -> str:
    return "; ".join(f"({file}: {message.splitlines()[0]})" for file, message in graded.errors.items())


def secrets_of(assignment: Assignment, project: dict[str, Divided], hidden_sources: list[Path],
               public_sources: list[Path]) -> dict[str, str]:
    """Returns {secret: its origin}. Secret are the lines of the solution, and the lines, ids and file names of hidden checks,
    except lines that public checks contain as well."""
    public = squeezed(" ".join(path.read_text(encoding="utf-8") for path in public_sources))
    secrets = {check.id: "the id of a hidden check" for check in assignment.checks if not check.is_public}
    for path in hidden_sources:
        secrets[path.name] = "a file of hidden checks"
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if is_specific(line.strip()) and squeezed(line) not in public:
                secrets[line.strip()] = f"{path.name}:{number}"
    for name, file in project.items():
        secrets.update({line: f"{name}:{number}" for number, line in file.secrets
                        if is_specific(line) and line not in assignment.not_secret})
    return secrets


def is_specific(line: str) -> bool:
    return len(line) >= 20 and not line.startswith(("#", "//", "namespace ", "using "))


def squeezed(text: str) -> str:
    return " ".join(text.split())


def leaks(files: dict[str, str], secrets: dict[str, str]) -> list[str]:
    """Lists the secrets that the files, {name: text}, or their names contain. Ignores differences in white space."""
    found = []
    for name, text in files.items():
        searched = f"{name} {squeezed(text)}"
        for secret, origin in secrets.items():
            if squeezed(secret) in searched:
                found.append(f"{name} contains \"{secret}\" ({origin})")
    return found
