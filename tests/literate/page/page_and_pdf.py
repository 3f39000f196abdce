#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The words and numbers of a page and of its PDF: page_and_pdf.py OUTPUT DOCUMENT MAIN [NAME], the folders of a build and of its
document, the name of the main file, and that of page and PDF if it is another one. It ends with 1 if a word, a number or a sign
of mathematics stands more often in one than in the other, or if words follow each other in the page and not in the PDF.

Each word and number of the page's text has to stand in the PDF as often, and what the PDF has besides has to be the letters and
digits of the page's formulas, each as often: a formula's own words cannot be told in a PDF, where its parts stand above and
below each other. Any two words beside each other in a paragraph of the page are so in the PDF; not in tables and formulas, nor
over a claim's mark or a note.

Left out, on both sides: listings; labels in drawings, which are typeset once more and counted; running heads; lists of
contents; marks at captions that lead to data; where a claim, a value or a drawing is used, for which the PDF has pages and the
page has sections; the word behind a claim's mark, for which the page has a sign; the second mark of a footnote; heads that a
table repeats on each sheet; and punctuation, but for brackets around nothing. Capitals are told from small letters in names of
references alone, since some classes print headings in capitals."""
import collections
import html.parser
import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unicodedata
import xml.etree.ElementTree as ElementTree

SIGN = "−+=<>≤≥±×"
TOKEN = re.compile(rf"[^\W\d_]+|\d+(?:\.\d+)*|[{SIGN}]")
VOID = {"meta", "link", "img", "br", "hr", "input", "col", "wbr"}
IN_LINE = {"a", "span", "em", "strong", "code", "sup", "sub", "math", "b", "i"}
APART = "\0"
LEADING = 22  # points within which a line goes on beside or below
GAP = 9  # points between words that do not follow each other
LEDGER_HEAD = ["statement and test", "result", "limit", "margin", "verdict", "planted faults"]
LEVELS = ["part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph"]
# What pdftotext may make of TeX's composed signs.
SIGNS = {"∫": "zr", "∑": "xp", "∏": "yq", "√": "pqrs", "≠": "="}
ONE_LETTER = str.maketrans("ϵϕϑϱıȷ∆", "εφθρijδ", "ˆ")


def normal(text):
    return unicodedata.normalize("NFKC", text).casefold().translate(ONE_LETTER)


def letters_of(words):
    """Letters without accents, which a PDF has apart."""
    return collections.Counter(c for c in unicodedata.normalize("NFD", "".join(words.elements())) if c.isalnum() or c in SIGN)


def tokens(text):
    return TOKEN.findall(normal(text))


def cased(text):
    """The words of a text, each with its own capitals."""
    return [word for word in TOKEN.findall(unicodedata.normalize("NFKC", text)) if word[0].isalpha() and len(word) > 1]


class Page(html.parser.HTMLParser):
    """What a page says: its words with their places, the letters of its formulas, the code of its listings; and what it shows."""

    SKIPPED = {"nav", "script", "style", "svg", "head"}
    # The PDF has something behind it or elsewhere.
    APART = {"lit-claim", "lit-note", "lit-note-mark", "lit-sign", "lit-uses"}
    SKIPPED_CLASSES = {"lit-skip", "lit-formats", "lit-cite-page", "lit-uses", "lit-ledger-place"}

    def __init__(self, file):
        super().__init__(convert_charrefs=True)
        self.words, self.formulas, self.code, self.heads, self.table = [], [], [], collections.defaultdict(list), ""
        self.signs, self.lists, self.items, self.parts = collections.Counter(), [], [], set()
        self.drawings, self.verdicts, self.used, self.notes, self.places = [], [], [], [], {}
        self.open, self.said, self.kinds, self.at = [], "", "", "the beginning"
        self.pairs, self.whole, self.named = [], "", set()
        self.feed(file.read_text(encoding="utf-8"))
        self.end_of_text()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        classes = set((attributes.get("class") or "").split())
        if tag not in IN_LINE or "lit-note" in classes:
            self.end_of_text()
            self.whole += "\n"
        if classes & self.APART:
            self.add(APART, "text")
        if attributes.get("id") and tag in {"section", "figure", "div", "article", "p"}:
            self.at = attributes["id"]
        if tag in {"ol", "ul"} or tag == "li":
            is_list = tag == "li" and self.lists and self.lists[-1] is not None and self.kind() == "text"
            if is_list:
                self.lists[-1] += 1
            (self.items.append(self.lists[-1] if is_list else None) if tag == "li" else
             self.lists.append(0 if tag == "ol" and not classes else None))
        if "lit-item" in classes and self.items:
            self.items[-1] = None
        self.signs["√"] += tag in {"msqrt", "mroot"}
        if "data-drawing" in attributes:
            self.drawings.append(attributes["data-drawing"])
            if any("lit-subfigure" in outer for _, _, outer in self.open):
                self.parts.add(attributes["data-drawing"])
        self.table = attributes.get("data-table", self.table)
        if "lit-claim" in classes and not any("lit-findings" in outer for _, _, outer in self.open):
            self.verdicts.append(attributes["data-verdict"])
        if "lit-ledger-entry" in classes:
            self.places[attributes["data-claim"]] = ""
        if tag == "p" and (attributes.get("id") or "").startswith("val-"):
            self.used.append("val@" + self.at[len("val-"):])
        if any("numberLines" in outer for _, _, outer in self.open):
            self.code += tokens(attributes.get("data-line", ""))
        if tag in VOID:
            return
        kind = self.kind()
        if kind == "text":
            kind = ("place" if "lit-ledger-place" in classes else
                    "skipped" if tag in self.SKIPPED or classes & self.SKIPPED_CLASSES else
                    "note" if "lit-note-mark" in classes else
                    "code" if tag == "pre" and self.is_listing() else
                    "formula" if tag in {"math", "sup", "sub"} else kind)
        self.open.append((tag, kind, classes))

    def kind(self):
        return self.open[-1][1] if self.open else "text"

    def is_listing(self):
        return any("sourceCode" in classes or "lit-listing" in classes for _, _, classes in self.open)

    def handle_endtag(self, tag):
        while self.open and any(tag == name for name, _, _ in self.open):
            closed, _, classes = self.open.pop()
            if classes & self.APART:
                self.add(APART, "text")
            if closed == tag:
                break
        if tag not in IN_LINE:
            self.end_of_text()
        if tag == "li" and self.items:
            number = self.items.pop()
            self.words += [(str(number), f"#{self.at}: the number of an item")] if number else []
        elif tag in {"ol", "ul"} and self.lists:
            self.lists.pop()

    def handle_data(self, data):
        kind = self.kind()
        if kind == "skipped":
            return
        if kind == "place":
            self.places[list(self.places)[-1]] += data
        elif kind == "code":
            self.code += tokens(data)
        else:
            self.signs.update(c for c in data if c in SIGNS)
            data = unicodedata.normalize("NFKC", data)
            self.whole += data
            if any("lit-ref" in classes for _, _, classes in self.open):
                self.named.update(cased(data))
            # A letter that is raised stands apart in the PDF.
            if data[:1].isalpha() and self.open and self.open[-1][0] in {"sup", "sub"}:
                data = f" {data} "
            self.add(data, kind)
            if kind == "note":
                self.notes += tokens(data)

    def add(self, text, kind):
        self.said += text
        self.kinds += ("t" if kind == "text" else "f") * len(text)

    def end_of_text(self):
        """A word that touches a formula is part of it: nobody can tell them apart in the PDF."""
        said, kinds, self.said, self.kinds = self.said, self.kinds, "", ""
        if any(tag == "thead" for tag, _, _ in self.open):
            self.heads[self.table] += tokens(said)
        is_table, former, from_former = any(tag == "table" for tag, _, _ in self.open), None, 0
        for match in TOKEN.finditer(said):
            begin, end = match.span()
            around = [i for i in range(max(begin - 1, 0), min(end + 1, len(said)))
                      if begin <= i < end or said[i].isalnum()]
            in_formula = any(kinds[i] == "f" for i in around)
            place = f"#{self.at}: …{' '.join(said[max(begin - 40, 0):end + 25].split())}…"
            (self.formulas if in_formula else self.words).extend((word, place) for word in tokens(match.group()))
            word = None if in_formula or is_table else normal(match.group())
            if former and word and APART not in said[from_former:begin]:
                self.pairs.append(((former, word), place))
            former, from_former = word, end


Line = collections.namedtuple("Line", "sheet top left right text is_last")


def parts_of(line):
    """The words of a line, apart from those of another column."""
    parts = []
    for word in line:
        if not parts or float(word.get("xMin")) - float(parts[-1][-1].get("xMax")) > GAP:
            parts.append([])
        parts[-1].append(word)
    return parts


def all_lines(pdf):
    """The lines of each sheet; of a block the last is marked, and each that another column follows."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "text.xml")
        subprocess.run(["pdftotext", "-bbox-layout", pdf, file], check=True)
        text = re.sub(r"[\x00-\x08\x0b\x0c\x0e-\x1f]", " ", file.read_text(encoding="utf-8"))
    name = "{http://www.w3.org/1999/xhtml}"
    sheets = []
    for number, page in enumerate(ElementTree.fromstring(text).iter(name + "page"), 1):
        sheets.append([])
        for block in page.iter(name + "block"):
            parts = [part for line in block for part in parts_of(line)]
            for part, behind in zip(parts, parts[1:] + [None]):
                is_last = behind is None or float(behind[0].get("xMin")) > float(part[-1].get("xMax"))
                sheets[-1].append(Line(number, float(part[0].get("yMin")), float(part[0].get("xMin")), float(part[-1].get("xMax")),
                                       " ".join(word.text or "" for word in part), is_last))
    return sheets


def without_heads(sheets):
    """A head or foot stands at the edge of a sheet, in the height and with the words of others, and with their number or the next."""
    def edges(number, lines):
        heights = [line.top for line in lines]
        return [(i, round(line.top / 2), re.sub(r"\d+", lambda match: f"#{int(match.group()) - number}", line.text))
                for i, line in enumerate(lines) if line.top < min(heights) + 3 or line.top > max(heights) - 3]

    said = collections.Counter()
    for number, lines in enumerate(sheets):
        said.update({(y + shift, text) for _, y, text in edges(number, lines) for shift in (-1, 0, 1)})
    for number, lines in enumerate(sheets):
        drop = {i for i, y, text in edges(number, lines) if said[y, text] > max(1, len(sheets) / 3)}
        # elsarticle's first sheet has a foot of its own.
        if number == 0 and any(line.text.startswith("Preprint submitted to") for line in lines):
            drop |= {i for i, _, _ in edges(number, lines) if i > len(lines) / 2}
        yield [line for i, line in enumerate(lines) if i not in drop]


def pdf_words(sheets, known):
    """Each line with its words; of a hyphenated word both halves are joined where the page knows the whole."""
    lines = [(line, tokens(small_capitals(line.text, known))) for lines in sheets for line in lines]
    for i, (line, found) in enumerate(lines):
        # A float or another column may stand between the halves.
        is_broken = found and re.search(r"[^\W\d_](?:-|\u2010)$", line.text)
        for _, others in lines[i + 1:] if is_broken else []:
            if others and found[-1] + others[0] in known:
                found[-1] += others.pop(0)
                break
    return [(line, found) for line, found in lines if found]


def small_capitals(line, known):
    """V ALUES is a word whose first letter is larger; and the logo is a word."""
    return re.sub(r"\b([A-Z]) ([A-Z]+)\b",
                  lambda match: "".join(match.groups()) if normal("".join(match.groups())) in known else match.group(),
                  line.replace("L A TEX", "LATEX"))


def tex_tokens(text, values):
    """The words of a line of TeX that LaTeX itself wrote, as in a list of contents."""
    text = re.sub(r"\\val ?(?:\[[^]]*\])?\s*\{([^}]*)\}", lambda match: values.get(match.group(1), ""), text)
    text = re.sub(r"\\LiterateUse|\\(?:cref|ref|cite|label|claim) ?\{[^}]*\}", " ", text)
    text = re.sub(r"\\hspace ?\{[^}]*\}", " ", text)
    return tokens(re.sub(r"\\[A-Za-z@]+\*?|[{}~$]", " ", text))


def taken(text, flags):
    """The text with the branches of \\ifflag that are taken."""
    while (at := text.find("\\ifflag")) >= 0:
        name, *branches = arguments(text[at:])[:3]
        end = at
        for group in (name, *branches):
            end = text.index("{" + group + "}", end) + len(group) + 2
        text = text[:at] + branches[not flags[name]] + text[end:]
    return text


def arguments(text):
    """The groups in braces at the start of a text."""
    found, depth, begin = [], 0, 0
    for i, c in enumerate(text):
        if c == "{":
            depth += 1
            begin = i + 1 if depth == 1 else begin
        elif c == "}":
            depth -= 1
            if depth == 0:
                found.append(text[begin:i])
    return found


def left_out(output, document, main, page, names):
    """What the PDF has by design and the page has not, as LaTeX wrote it beside the PDF; and where widths are told."""
    latex = output / "latex"
    aux = "".join(file.read_text(encoding="utf-8", errors="replace")
                  for file in [latex / f"{main}.aux", *sorted((latex / "sections").glob("*.aux"))])
    prose = "".join(re.sub(r"(?<!\\)%.*", "", file.read_text(encoding="utf-8"))
                    for file in [document / f"{main}.tex", *sorted((document / "sections").glob("*.tex"))] if file.exists())
    values = {key: value["printed"] for key, value in names["values"].items()}
    out = collections.Counter(page.notes)
    for ending, title in (("toc", "contents"), ("lof", "list of figures"), ("lot", "list of tables")):
        file = latex / f"{main}.{ending}"
        entries = [arguments(line) for line in file.read_text(encoding="utf-8").splitlines()
                   if line.startswith("\\contentsline")] if file.exists() else []
        out.update(tokens(title) if entries else [])
        depth = re.search(r"\\setcounter\{tocdepth\}\{(\d)\}", prose)
        deepest = int(depth.group(1)) if depth else 3
        for entry in entries:
            if entry[0] not in LEVELS or LEVELS.index(entry[0]) <= deepest + 1:
                out.update(tex_tokens(taken(entry[1], names["flags"]) + " " + entry[2], values))
    has_provenance, marks = "\\LiterateHasProvenance" in aux, collections.Counter()
    for name in re.findall(r"\\LiterateCaptionOf\{[^}]*\}\{[^}]*\}\{([^}]*)\}", aux):
        # A caption within a caption may show it once more.
        if has_provenance or name in page.parts:
            marks.update(3 * (["source"] if has_provenance else tokens(name)))
        else:
            out.update(tokens(name))
    if not re.search(r"\\LiterateClaimPlacement\}?\{margin\}", prose):
        for verdict in page.verdicts:
            out.update(tokens({"partly": "partly confirmed"}.get(verdict, verdict)))
    sheets = collections.defaultdict(list)
    for what, sheet in re.findall(r"\\LiterateUse\{([^}]*)\}\{([^}]*)\}", aux):
        if sheets[what][-1:] != [sheet]:
            sheets[what].append(sheet)

    def where(what, unused):
        return tokens(("pp. " if len(sheets[what]) > 1 else "p. ") + ", ".join(sheets[what])) if what in sheets else tokens(unused)

    defined = re.findall(r"\\renewcommand\*?\\LiterateLedgerPlace\[3\](.*)", prose)
    place = arguments(defined[-1])[0] if defined else "#1 #2 #3"
    for claim, said in page.places.items():
        file = said.split(",")[1]
        out.update(tex_tokens(re.sub("#.", " ", place), {}))
        out.update(tokens(claim) * place.count("#1") + tokens(file) * place.count("#2"))
        out.update(where(f"claim@{claim}", "named on no page") * place.count("#3"))
    for value in page.used:
        out.update(where(value, "printed on no page"))
    if has_provenance:
        for kind in ("figure", "table"):
            for name in names[kind + "s"]:
                out.update(where(f"{kind}@{name}", "shown on no page"))
    return out, marks, aux


def drawn_words(output, page, aux):
    """The labels of all drawings, typeset once more as the PDF has them."""
    drawn = []
    for name, width in re.findall(r"\\LiterateWidth\{([^}]*)\}\{(\d+)\}", aux):
        folder = output / "latex/at-width/drawn" / f"{name}-{width}"
        drawn.append((name, folder if folder.exists() else output / "generated/figures" / name))
    rest = collections.Counter(page.drawings) - collections.Counter(name for name, _ in drawn)
    drawn += [(name, output / "generated/figures" / name) for name in rest.elements()]
    tex = pathlib.Path(__file__).resolve().parents[3] / "src/literate/page/figures.tex"
    with tempfile.TemporaryDirectory() as folder:
        lines = [tex.read_text(encoding="utf-8")]
        for i, (name, source) in enumerate(drawn):
            target = pathlib.Path(folder, "figures", str(i))
            target.parent.mkdir(exist_ok=True)
            target.symlink_to(source.resolve())
            lines.append(f"\\def\\drawingfolder{{figures/{i}}}\\sbox\\figurebox{{\\input{{figures/{i}/{name}.tex}}\\unskip}}%\n"
                         "\\pdfpagewidth=\\dimexpr\\wd\\figurebox+4in\\pdfpageheight=\\dimexpr\\ht\\figurebox+\\dp\\figurebox+4in\\relax\n"
                         "\\pdfhorigin=2in\\pdfvorigin=2in\\shipout\\hbox{\\raise\\dp\\figurebox\\box\\figurebox}\n")
        pathlib.Path(folder, "labels.tex").write_text("".join(lines) + "\\end{document}\n", encoding="utf-8")
        subprocess.run(["pdflatex", "-interaction=batchmode", "labels.tex"], cwd=folder, stdout=subprocess.DEVNULL, check=bool(drawn))
        files = [pathlib.Path(folder, "labels.pdf"), output / "html/typeset.pdf"]
        return [word for file in files if file.exists() for lines in all_lines(file) for line in lines
                for word in tokens(line.text)]


def main():
    output, document, main_name = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3]
    name = sys.argv[4] if len(sys.argv) > 4 else main_name
    page = Page(output / f"{name}.html")
    names = json.loads((output / "generated/names.json").read_text(encoding="utf-8"))
    lines = pdf_words(without_heads(all_lines(output / f"{name}.pdf")), {word for word, _ in page.words})
    pdf = [(word, f"sheet {line.sheet}: {line.text}") for line, found in lines for word in found]
    out, marks, aux = left_out(output, document, main_name, page, names)
    out.update(drawn_words(output, page, aux))

    out.update(page.code)
    in_pdf = collections.Counter(word for word, _ in pdf)
    in_page = collections.Counter(word for word, _ in page.words)
    # Marks at captions and repeated heads are there as often as they are.
    n_sheets = in_pdf["continued"] - in_page["continued"]
    long = [name for name in page.heads if name and "{longtable}" in
            (output / f"generated/tables/{name}.tex").read_text(encoding="utf-8")]
    # So is the ledger's head, which stands in the page once for each of its tables.
    n_heads = sum(line.text.startswith(LEDGER_HEAD[0]) for line, _ in lines) - page.whole.count(", ".join(LEDGER_HEAD[:2]))
    again = collections.Counter(tokens(" ".join(LEDGER_HEAD)) * max(n_heads, 0))
    again += collections.Counter((["continued"] + [word for name in long for word in page.heads[name]]) * n_sheets)
    out += (in_pdf - out - in_page) & (again + marks)
    # What is left out may touch a formula in the PDF too.
    formulas = collections.Counter(word for word, _ in page.formulas) + (out - in_pdf)
    lacking = in_page - (in_pdf - out)
    left = in_pdf - out - in_page
    left, formulas = left - formulas, formulas - left
    letters, wanted = letters_of(left), letters_of(formulas)
    for sign, forms in SIGNS.items():
        surplus = [c for c in forms for _ in range((letters - wanted)[c])]
        letters -= collections.Counter(surplus[:page.signs[sign]])
    n_errors = show("page in this order", "PDF", disordered(page.pairs, lines), page.pairs)
    n_errors += show("page", "PDF", lacking, page.words)
    n_errors += show("PDF", "page", {word: n for word, n in left.items() if set(word) & set(letters - wanted)}, pdf)
    n_errors += show("page", "PDF", {word: n for word, n in formulas.items() if set(word) & set(wanted - letters)}, page.formulas)
    if letters != wanted:
        print("letters and digits of formulas that only the PDF has:", dict(letters - wanted), "only the page:", dict(wanted - letters))
        n_errors = n_errors or 1
    n_errors += misspelt(page, "\n".join(line.text for sheet in all_lines(output / f"{name}.pdf") for line in sheet))
    print(f"{len(page.words)} words and {len(page.formulas)} pieces of formulas compared; {n_errors} stand in one and not the other")
    return 1 if n_errors else 0


def disordered(pairs, lines):
    """Words that follow each other in the page more often than in the PDF, where a line may go on in the next, in the one beside or
    below it and, at the end of a block, in any other; a letter between two words may be part of a large sign."""
    words = [word for _, found in lines for word in found]
    follow = collections.Counter(zip(words, words[1:]))
    follow.update((one, two) for one, sign, two in zip(words, words[1:], words[2:]) if len(sign) == 1)
    ends, begins = set(), set()
    for (line, found), (_, behind) in itertools.pairwise(lines):
        near = [(other, others) for other, others in lines if other.sheet == line.sheet and abs(other.top - line.top) < LEADING]
        follow.update({(found[-1], word) for other, others in near for word in others[:2]
                       if other.left >= line.right - 1 or other.top > line.top + 2})
        if line.is_last:
            ends.add(found[-1])
            begins.update(behind[:2 if len(behind[0]) == 1 else 1])
    counted = collections.Counter(pair for pair, _ in pairs) - follow
    return {pair: n for pair, n in counted.items() if not (pair[0] in ends and pair[1] in begins)}


def misspelt(page, pdf):
    """Tells names of references with other capitals than those of the PDF, and brackets around nothing; says how many these are."""
    # The one reading has words that a line breaks, the other those that have a hyphen of their own.
    in_pdf = collections.Counter(cased(pdf)) | collections.Counter(cased(re.sub("[-\u2010]\n", "", pdf)))
    in_page, n_errors = collections.Counter(cased(page.whole)), max(page.whole.count("[]") - pdf.count("[]"), 0)
    if n_errors:
        print(f"'[]' stands {n_errors} times more in the page than in the PDF")
    for word in sorted(page.named):
        surplus = in_page[word] - in_pdf[word]
        if surplus > 0:
            print(f"'{word}' with these capitals stands {surplus} times more in the page than in the PDF")
            n_errors += surplus
    return n_errors


def show(here, there, counted, words):
    """Tells each word that stands here more often than there, with its places; says how many these are."""
    places = collections.defaultdict(list)
    for word, place in words:
        places[word].append(place)
    for word, n in sorted(counted.items()):
        print(f"'{word}' stands {n} times more in the {here} than in the {there}:", *places[word][:3], sep="\n    ")
    return sum(counted.values())


sys.exit(main())
