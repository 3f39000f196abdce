# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the sources of the document for arXiv or a journal: the files that LaTeX read, including numbers and drawings, and the
bibliography. It typesets them once in an empty folder without the engine, which must give the same PDF.

examples:
  literate dist build/mypaper.json        writes build/mypaper/mypaper.tar.gz
"""

import gzip
import io
import subprocess
import tarfile
from pathlib import Path
from tempfile import TemporaryDirectory

from literate_tools.common import Failure, parser, tool, write_bytes
from literate_tools.settings import Settings, read_settings
from literate_tools.typeset import MOST_RUNS, environment, recorded


def run(arguments: list[str]) -> int:
    """Writes OUTPUT/NAME.tar.gz."""
    arguments_of = parser("dist", __doc__)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    settings = read_settings(arguments_of.parse_args(arguments).settings)
    data = packed(packed_files(settings))
    if typeset_elsewhere(settings, data) != settings.pdf.read_bytes():
        raise Failure("the packed sources give a different PDF: is the paper up to date?", 1)
    target = settings.output / f"{settings.name}.tar.gz"
    write_bytes(target, data)
    print(target)
    return 0


def packed_files(settings: Settings) -> dict[str, Path]:
    """Returns the files to pack, by their names in the archive."""
    files = {}
    for path in recorded(settings):
        if path.is_relative_to(settings.generated):
            files[f"generated/{path.relative_to(settings.generated)}"] = path
        elif path.is_relative_to(settings.document):
            files[str(path.relative_to(settings.document))] = path
        elif path.name == "literate.sty":
            files["literate.sty"] = path
    for name in ("values.csv", "claims.csv", "tables.csv"):  # which \attachdata reads
        files[f"generated/{name}"] = settings.generated / name
    bibliography = settings.latex / f"{settings.name}.bbl"
    if bibliography.exists():
        files[f"{Path(settings.main).stem}.bbl"] = bibliography
    return files


def packed(files: dict[str, Path]) -> bytes:
    """Returns a compressed archive without dates and users."""
    tar_data = io.BytesIO()
    with tarfile.open(fileobj=tar_data, mode="w") as tar:
        for name, path in sorted(files.items()):
            entry = tarfile.TarInfo(name)
            entry.size, entry.mode = path.stat().st_size, 0o644
            with open(path, "rb") as file:
                tar.addfile(entry, file)
    return gzip.compress(tar_data.getvalue(), mtime=0)


def typeset_elsewhere(settings: Settings, archive: bytes) -> bytes:
    """Unpacks the archive into an empty folder, runs LaTeX there until nothing changes, and returns the PDF."""
    with TemporaryDirectory(prefix="literate-") as folder:
        with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
            tar.extractall(folder)
        command = [tool("pdflatex", "texlive-latex-base"), "-interaction=nonstopmode", "-halt-on-error", settings.main]
        pdf, before = Path(folder, settings.main).with_suffix(".pdf"), b""
        for _ in range(MOST_RUNS):
            ran = subprocess.run(command, cwd=folder, env=environment(settings) | {"TEXINPUTS": ""}, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if ran.returncode:
                raise Failure(f"{ran.stdout.decode(errors='replace')[-2000:]}\nthe packed sources cannot be typeset", 3)
            if pdf.read_bytes() == before:
                break
            before = pdf.read_bytes()
        return before
