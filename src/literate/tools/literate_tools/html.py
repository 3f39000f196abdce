# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts the typeset paper into a web page, OUTPUT/NAME.html: one file that loads nothing else.

LaTeXML reads the prose with page/literate.sty.ltxml in place of literate.sty. The PDF's .aux file gives the numbers of sections,
equations, tables, figures and references. If the page would show a different number, the conversion fails. The PDF must be up to
date. Exits with 1 if a check or claim failed; the page is stamped then.

examples:
  literate html build/mypaper.json     writes build/mypaper/mypaper.html
"""

import base64
import os
import re
import shutil
import subprocess
from collections.abc import Sequence
from html import escape
from pathlib import Path

from literate_tools.common import ENGINE, Failure, parser, tool, write_bytes
from literate_tools.manifest import manifest
from literate_tools.settings import Settings, failures, read_settings
from literate_tools.typeset import environment

PAGE = ENGINE / "page"
SITE = """Fills OUTPUT/site, a folder that any web server can serve: the page, the PDF, data/ with all CSV files and results.json, and the
FILEs, which the page links to.

examples:
  literate site build/mypaper.json CITATION.cff
"""
FONT = "latinmodern-math"
LARGEST_SVG = 1_000_000  # bytes; a larger drawing, such as a map of colours, becomes a PNG
MAGNIFIED = 1.3  # ratio of the text sizes of page and PDF

# Typesets each drawing on a page of its size, with the preamble of the document and the text size of its floats.
DRAWINGS = (r"\nofiles\makeatletter\AddToHook{begindocument/end}{"
            r"\def\drawing#1{\setbox\z@\hbox{\@floatboxreset\fig{#1}}\pdfhorigin9bp\pdfvorigin9bp"
            r"\pdfpagewidth\dimexpr\wd\z@+18bp\relax\pdfpageheight\dimexpr\ht\z@+\dp\z@+18bp\relax"
            r"\csname tex_shipout:D\endcsname\box\z@}"
            r"%s\csname @@end\endcsname}\makeatother\input{%s}")


def run(arguments: list[str]) -> int:
    """Writes the page."""
    arguments_of = parser("html", __doc__)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    settings = read_settings(arguments_of.parse_args(arguments).settings)
    page = settings.output / f"{settings.name}.html"
    page.unlink(missing_ok=True)
    write_bytes(page, make_page(settings).encode())
    return end(settings, page)


def site(arguments: list[str]) -> int:
    """Fills the folder."""
    arguments_of = parser("site", SITE)
    arguments_of.add_argument("settings", help="the settings of the paper, such as build/mypaper.json")
    arguments_of.add_argument("files", type=Path, nargs="*", metavar="FILE", help="other files for the readers")
    given = arguments_of.parse_args(arguments)
    settings = read_settings(given.settings)
    folder, new = settings.output / "site", settings.output / "site.new"
    for old in (folder, new):
        shutil.rmtree(old, ignore_errors=True)
    page = make_page(settings)
    for file in [*settings.generated.rglob("*.csv"), settings.generated / "results.json"]:
        copy = new / "data" / file.relative_to(settings.generated)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copy)
    for file in [settings.pdf, *given.files]:
        shutil.copyfile(file, new / file.name)
    names = [settings.pdf.name, "data/values.csv", "data/results.json", *(file.name for file in given.files)]
    links = " ".join(f'<a href="{escape(name)}">{escape(Path(name).name)}</a>' for name in names)
    (new / "index.html").write_text(page.replace("</main>", f'<p class="files">{links}</p>\n</main>'))
    new.rename(folder)
    return end(settings, folder)


def end(settings: Settings, made: Path) -> int:
    """Prints what was made, and the failed checks and claims; returns the exit code."""
    print(os.path.relpath(made))
    return 1 if failures(settings) else 0


def make_page(settings: Settings) -> str:
    """Returns the page for the current PDF."""
    recorded = settings.output / f"{settings.name}.manifest.json"
    if not recorded.exists() or recorded.read_text() != manifest(settings, settings.pdf):
        raise Failure(f"{os.path.relpath(settings.pdf)}: the PDF is not up to date; build the paper first")
    work = settings.output / "page"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir()
    (work / "pdf.aux").write_text(aux_text(settings.latex / f"{settings.name}.aux"))
    bibliography = settings.latex / f"{settings.name}.bbl"
    if bibliography.exists():
        shutil.copy(bibliography, work / f"{Path(settings.main).stem}.bbl")
    return one_file(convert(settings, work), settings, work)


def aux_text(file: Path) -> str:
    """Returns the text of an .aux file and of the .aux files it includes."""
    text = file.read_text(errors="surrogateescape")
    return text + "".join(aux_text(file.parent / name) for name in re.findall(r"^\\@input\{(.+)\}", text, re.MULTILINE))


def convert(settings: Settings, work: Path) -> str:
    """Returns the document as HTML with links to pictures and style sheet."""
    paths = [f"--path={path}" for path in (PAGE, work, settings.output)]
    command = [tool("latexml"), "--quiet", *paths, f"--log={work / 'latexml.log'}", f"--destination={work / 'page.xml'}", settings.main]
    subprocess.run(command, cwd=settings.document, env=environment(settings), stdin=subprocess.DEVNULL, capture_output=True)
    errors = errors_in((work / "latexml.log").read_text(errors="replace"), settings)
    if errors:
        raise Failure("\n".join(errors))
    command = [tool("latexmlpost", "latexml"), "--novalidate", "--format=html5", "--pmml", "--svg", "--nographicimages",
               "--nodefaultresources", "--timestamp=0", "--navigationtoc=normal", "--css=page.css", f"--stylesheet={PAGE / 'page.xsl'}",
               "--xsltparameter=META_VIEWPORT:width=device-width, initial-scale=1", f"--destination={work / 'page.html'}", "page.xml"]
    printed = tool_output(command, work, settings)
    missing = re.search(r"^(Error|Fatal|Warning:expected:ids).*", printed, re.MULTILINE)
    if missing:
        raise Failure(f"latexmlpost: {missing[0]}", 3)
    return (work / "page.html").read_text()


def errors_in(log: str, settings: Settings) -> list[str]:
    """Returns the errors in LaTeXML's log, each with its file, line and column."""
    errors = []
    pattern = r"^(?:Error|Fatal):([^:\s]+):(\S+) (.*?)(?:  +.*)?(?:\n\tat (.+?); line (\d+) col (\d+).*)?$"
    for kind, subject, message, name, line, column in re.findall(pattern, log, re.MULTILINE):
        if kind == "undefined":
            message = f"LaTeXML does not know {subject}"
        files = list(settings.document.rglob(name)) if name else []
        place = settings.shown(files[0]) if len(files) == 1 else name
        errors.append(f"{place}:{line}:{int(column) + 1}: {message}" if name else message)
    return errors


def tool_output(command: Sequence[str | Path], folder: Path, settings: Settings) -> str:
    """Runs a tool and returns its output. If it fails, the message is its first line that looks like an error."""
    # latexmlpost deletes the empty files of the folder for temporary files, also those of a compiler that runs.
    ran = subprocess.run([str(word) for word in command], cwd=folder, env=environment(settings) | {"TMPDIR": str(folder)},
                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if ran.returncode:
        found = re.search(r"^(!|\S+:\d+: ).*", ran.stdout, re.MULTILINE)
        raise Failure(f"{Path(command[0]).name} failed: {found[0] if found else ran.stdout.strip()[-500:]}", 3)
    return ran.stdout


def one_file(html: str, settings: Settings, work: Path) -> str:
    """Embeds style sheet, font and pictures, and makes wide tables scroll by keyboard."""
    sources = list(dict.fromkeys(re.findall(r'<img src="([^"]+)"', html)))
    draw([Path(source).stem for source in sources if source.startswith("drawings/")], settings, work)
    html = re.sub(r'<img src="([^"]+)" data-options="([^"]*)"',
                  lambda match: picture(match[1], match[2], settings, work), html)
    html = re.sub(r"<!--Generated .*?-->\n?", "", html, flags=re.DOTALL)
    html = re.sub(r'<div class="ltx_listing_data">.*?</div>', "", html, flags=re.DOTALL)  # copies of listings
    html = re.sub(r' mathsize="[^"]*"|(?<=style=")font-size:[\d.]+%;', "", html)  # sizes are those of the style sheet
    html = html.replace("<table", '<div class="scrolls" tabindex="0"><table').replace("</table>", "</table></div>")
    return with_levels(with_spaces(html)).replace('<link rel="stylesheet" href="page.css" type="text/css">', f"<style>\n{style(work, settings)}</style>")


def with_spaces(html: str) -> str:
    """Repairs spaces in formulas: at slashes and lone signs, and at brackets, minus and powers that LaTeXML could not parse."""
    html = re.sub(r"<math[^>]*><mo>([<>=≤≥])</mo></math>", r"\1", html)
    for form, brackets in (("prefix", r"[(\[]"), ("postfix", r"[)\]]")):
        html = re.sub(rf"<mo([^>]*>{brackets}</mo>)", rf'<mo form="{form}"\1', html)
    html = re.sub(r"<mo[^>]*>/</mo>", '<mo lspace="0" rspace="0">/</mo>', html)
    html = re.sub(r'<mo rspace="0em">(.)</mo><mo lspace="0em">−</mo>', r'<mo>\1</mo><mo form="prefix">−</mo>', html)
    return re.sub(r'<mo form="postfix" rspace="([\d.]+em)" stretchy="false">\)</mo></mrow>(<m[ni]>[^<]*</m[ni]>)</msup>',
                  r'<mo form="postfix" stretchy="false">)</mo></mrow>\2</msup><mspace width="\1"/>', html)


def with_levels(html: str) -> str:
    """Renumbers headings so that none is more than one level deeper than the heading above it."""
    above: list[str] = []

    def replace(match: re.Match[str]) -> str:
        if not match[1]:
            while above and above[-1] >= match[2]:
                above.pop()
            above.append(match[2])
        return f"<{match[1]}h{len(above)}"
    return re.sub(r"<(/?)h([1-6])\b", replace, html)


def style(work: Path, settings: Settings) -> str:
    """Returns the style sheet with an embedded font. Without a font for formulas, Greek letters may be empty boxes."""
    otf = subprocess.run([tool("kpsewhich", "texlive-binaries"), f"{FONT}.otf"], capture_output=True, text=True).stdout.strip()
    if not otf:
        raise Failure(f"{FONT}.otf is not installed (Debian package fonts-lmodern)", 3)
    tool_output([tool("woff2_compress", "woff2"), shutil.copy(otf, work)], work, settings)
    return (PAGE / "page.css").read_text().replace(f"{FONT}.woff2", data_uri("font/woff2", work / f"{FONT}.woff2"))


def draw(names: list[str], settings: Settings, work: Path) -> None:
    """Writes work/drawings/NAME.svg or .png for each registered figure."""
    (work / "drawings").mkdir()
    if names:
        source = DRAWINGS % ("".join(rf"\drawing{{{name}}}" for name in names), settings.main)
        tool_output([tool("pdflatex"), "-file-line-error", "-halt-on-error", "-interaction=nonstopmode", "-jobname=pdf",
                     f"-output-directory={os.path.relpath(work, settings.document)}", source], settings.document, settings)
    for number, name in enumerate(names, 1):
        as_picture(work / "pdf.pdf", number, work / "drawings" / name, settings)


def as_picture(pdf: Path, number: int, stem: Path, settings: Settings) -> Path:
    """Writes one page of a PDF as STEM.svg, or as STEM.png if the SVG is too large, and returns the file."""
    svg, pages = Path(f"{stem}.svg"), ["-f", str(number), "-l", str(number)]
    program = tool("pdftocairo", "poppler-utils")
    tool_output([program, "-svg", *pages, pdf, svg], pdf.parent, settings)
    if svg.stat().st_size <= LARGEST_SVG:
        return svg
    svg.unlink()
    tool_output([program, "-png", "-singlefile", "-r", "200", *pages, pdf, stem], pdf.parent, settings)
    return Path(f"{stem}.png")


def picture(source: str, options: str, settings: Settings, work: Path) -> str:
    """Returns the start of an <img> with its data and its width, MAGNIFIED times that of the PDF."""
    file = work / source if source.startswith("drawings/") else settings.document / source
    if file.suffix == ".pdf":
        file = as_picture(file, 1, work / "drawings" / f"of {file.stem}", settings)
    elif not file.exists():
        file = file.with_suffix(".png")
    head = file.read_bytes()[:500].decode(errors="replace")
    width = re.search(r"width=([\d.]+)pt", options) or re.search(r'<svg[^>]* width="([\d.]+)', head)
    shown = f' style="width:{MAGNIFIED * float(width[1]):.0f}pt"' if width else ""
    kind = {".svg": "image/svg+xml", ".jpg": "image/jpeg"}.get(file.suffix, f"image/{file.suffix[1:]}")
    return f'<img src="{data_uri(kind, file)}"{shown}'


def data_uri(kind: str, file: Path) -> str:
    """Returns a data: URI with the content of a file."""
    return f"data:{kind};base64,{base64.b64encode(file.read_bytes()).decode()}"
