# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs LaTeX until its auxiliary files no longer change, then publishes the PDF and its manifest.

LaTeX runs in the folder of the document, as in an editor. Its auxiliary files go to OUTPUT/latex. TEXINPUTS finds the folder
generated/ relative to the document, since TeX cannot search an absolute path that contains a comma.
"""

import hashlib
import os
import subprocess
from pathlib import Path

from literate_tools import latex_log
from literate_tools.common import ENGINE, Failure, date_back, file_time, tool, warn, write_bytes
from literate_tools.settings import Settings, read_settings

MOST_RUNS = 8  # contents, references and an index need four
UNBROKEN = {"max_print_line": "10000", "error_line": "254", "half_error_line": "238"}  # of the lines of the log
# Files that LaTeX does not read back.
NOT_READ = {".log", ".pdf", ".fls", ".uses", ".blg", ".ilg", ".gz"}


def run(arguments: list[str]) -> int:
    """Typesets the paper's main case: literate typeset SETTINGS STAMP DEPFILE."""
    settings, stamp, depfile = read_settings(arguments[0]), Path(arguments[1]), Path(arguments[2])
    start = file_time(settings.output)
    typeset(settings)
    write_depfile(settings, stamp, depfile)
    stamp.touch()
    date_back([stamp], start)
    return 0


def typeset(settings: Settings) -> None:
    """Writes OUTPUT/NAME.pdf and NAME.manifest.json, each complete or not at all."""
    from literate_tools.manifest import manifest
    pdf = run_latex(settings)
    for line in latex_log.warnings(settings):
        warn(line)
    text = manifest(settings, pdf)
    os.replace(pdf, settings.pdf)
    write_bytes(settings.output / f"{settings.name}.manifest.json", text.encode())


def run_latex(settings: Settings) -> Path:
    """Runs LaTeX as often as needed and returns the PDF in OUTPUT/latex. Fails with LaTeX's errors and their places."""
    had_files = prepare(settings)
    errors = settle(settings)
    if had_files and any(error.is_in_auxiliary_file for error in errors):
        clear(settings)  # files of an earlier run that do not fit this text, or were cut off
        errors = settle(settings)
    if errors:
        raise Failure("\n".join(latex_log.report(settings, errors)), 3)
    return settings.latex / f"{settings.name}.pdf"


def settle(settings: Settings) -> list[latex_log.Error]:
    """Runs LaTeX and BibTeX until their auxiliary files stay the same."""
    before = read_back(settings)
    for _ in range(MOST_RUNS):
        errors = pdflatex(settings)
        if errors:
            return errors
        bibliography(settings)
        after = read_back(settings)
        if before == after:
            return []
        changed = sorted(name for name in before.keys() | after.keys() if before.get(name) != after.get(name))
        before = after
    raise Failure(f"{settings.main}: LaTeX still changes these files after {MOST_RUNS} runs: {', '.join(changed)}", 3)


def read_back(settings: Settings) -> dict[str, bytes]:
    """Returns the digests of the files in OUTPUT/latex that the next run may read."""
    return {str(path): hashlib.sha256(path.read_bytes()).digest()
            for path in settings.latex.rglob("*") if path.suffix not in NOT_READ and path.is_file()}


def pdflatex(settings: Settings) -> list[latex_log.Error]:
    """Runs LaTeX once and returns its errors."""
    command = [tool("pdflatex", "texlive-latex-base"), "-recorder", "-file-line-error", "-interaction=nonstopmode",
               f"-jobname={settings.name}", f"-output-directory={os.path.relpath(settings.latex, settings.document)}",
               settings.main]
    (settings.latex / f"{settings.name}.log").unlink(missing_ok=True)
    ran = subprocess.run(command, cwd=settings.document, env=environment(settings) | UNBROKEN, stdin=subprocess.DEVNULL,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    errors = latex_log.errors(settings)
    if ran.returncode and not errors:
        raise Failure(f"pdflatex failed:\n{ran.stdout.decode(errors='replace')[-2000:]}", 3)
    return errors


def bibliography(settings: Settings) -> None:
    """Runs BibTeX and MakeIndex if the document has a bibliography or an index."""
    aux, index = settings.latex / f"{settings.name}.aux", settings.latex / f"{settings.name}.idx"
    if b"\\bibdata" in aux.read_bytes():
        run_tool(settings, "bibtex", "texlive-binaries", aux.stem)
        for line in latex_log.bibtex_warnings(settings):
            warn(line)
    if index.exists():
        run_tool(settings, "makeindex", "texlive-binaries", "-q", index.name)


def run_tool(settings: Settings, name: str, package: str, *arguments: str) -> None:
    """Runs a program in OUTPUT/latex. Fails with its output."""
    beside = os.path.relpath(settings.document, settings.latex)
    ran = subprocess.run([tool(name, package), *arguments], cwd=settings.latex, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                         env=environment(settings) | {"BIBINPUTS": f".:{beside}:", "BSTINPUTS": f".:{beside}:"})
    if ran.returncode:
        raise Failure(f"{name} failed:\n{ran.stdout.decode(errors='replace').rstrip()}", 3)


def environment(settings: Settings) -> dict[str, str]:
    """Returns an environment in which the PDF does not depend on clock, locale or folder."""
    day = "1970-01-01"
    repository = settings.generated / "repository.tex"
    if repository.exists():
        day = repository.read_text().rstrip("}\n").rpartition("{")[2] or day
    from calendar import timegm
    from time import strptime
    inputs = os.path.relpath(settings.output, settings.document)
    return os.environ | {
        "SOURCE_DATE_EPOCH": str(timegm(strptime(f"{day} 12", "%Y-%m-%d %H"))), "FORCE_SOURCE_DATE": "1",
        "TZ": "UTC", "LC_ALL": "C", "TEXINPUTS": f"{inputs}:.:",
    }


def prepare(settings: Settings) -> bool:
    """Creates OUTPUT/latex with the folders for \\include, and returns True if an earlier run left files there."""
    if not (settings.document / settings.main).is_file():
        raise Failure(f"{settings.shown(settings.document / settings.main)}: there is no such file")
    bad = set(os.path.relpath(settings.output, settings.document)) & set(',;:{}$"~')
    if bad:
        raise Failure(f"{settings.output}: TeX cannot search a path with '{bad.pop()}'; put this folder beside the prose")
    settings.latex.mkdir(parents=True, exist_ok=True)
    link = settings.output / "literate.sty"
    if not link.is_symlink() or os.readlink(link) != str(ENGINE / "literate.sty"):
        link.unlink(missing_ok=True)
        link.symlink_to(ENGINE / "literate.sty")
    for drawing in settings.generated.glob("figures/*/*.tex"):  # whose script was removed
        if drawing.stem not in {script.stem for script in settings.scripts}:
            drawing.unlink()
    had_files = any(settings.latex.iterdir())
    for folder, folders, files in os.walk(settings.document):
        folders[:] = [f for f in folders if not f.startswith(".") and Path(folder, f) not in (settings.output, settings.build)]
        if any(file.endswith(".tex") for file in files):
            (settings.latex / os.path.relpath(folder, settings.document)).mkdir(parents=True, exist_ok=True)
    return had_files


def clear(settings: Settings) -> None:
    """Removes the files of earlier runs."""
    for path in settings.latex.rglob("*"):
        if path.is_file():
            path.unlink()


def recorded(settings: Settings) -> list[Path]:
    """Returns the files that LaTeX read in its last run (from the .fls file), without its auxiliary files."""
    fls = (settings.latex / f"{settings.name}.fls").read_text(errors="surrogateescape")
    names = dict.fromkeys(line[6:] for line in fls.splitlines() if line.startswith("INPUT "))
    paths = dict.fromkeys(Path(os.path.realpath(settings.document / name)) for name in names)
    return [path for path in paths if not path.is_relative_to(settings.latex)]


def write_depfile(settings: Settings, stamp: Path, depfile: Path) -> None:
    """Writes the files that LaTeX read, for Ninja. Paths are relative where Ninja accepts that, since it cannot read every
    character; it knows the stamp by a relative path only inside its folder."""
    def escaped(path: Path, part: Path) -> str:
        name = os.path.relpath(path, settings.build) if path.is_relative_to(part) else str(path)
        return name.replace("\\", "\\\\").replace(" ", "\\ ").replace("#", "\\#").replace("$", "$$")
    read = [escaped(path, settings.source) for path in recorded(settings) if not path.is_relative_to(settings.output)]
    depfile.write_text(f"{escaped(stamp, settings.build)}: {' '.join(read)}\n")
