# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds numbers that are typed into prose or scripts, where computed ones belong.

Typed are a number with a unit, whatever is between the two, and a number of more than two significant digits. Free are numbers
in displayed formulas without a unit, years, and places in cited sources. A line that ends with `% constant: reason` keeps its numbers.
"""

import re

from literate_tools.uses import without_comments

MOST_DIGITS = 2  # «of order 2», «40 elements»
NUMERAL = re.compile(r"(\d{1,3}(?:(?:\{,\}|\\,|,|~| )\d{3}(?!\d))+|\d+)((?:\.|\{\.\})\d+)?(?:\(\d+\))?"
                     r"([eE][+-]?\d+|(?:\s*\\(?:times|cdot)\s*10)?\^(?:\{[+-]?\d+\}|\d))?")
SYMBOLS = (r"(?:[munpkMGTµμ]|\\mu\s*\$?\s*|\\micro|da|d|c|h)?(?:Pa|Hz|eV|bar|mol|Wh|Ah|rad|lm|lx|Bq|Gy|Sv|[mgsNJWVAFHTCLlKΩ]|\\(?:Omega|ohm))"
           r"|[kMGT]i?B|dB|Np|lbf?|psi|ksi|min|hour|h|ft|sr|rpm|[°º][CF]?|K|S|t|\\(?:degree|textdegree|celsius|textcelsius|percent)")
WORDS = (r"per ?cent|pounds?|inch(?:es)?|feet|foot|degrees?|(?:micro|milli|centi|kilo)?(?:met(?:re|er)|gram|gramme)s?|seconds?|minutes?|hours?"
         r"|days?|weeks?|years?|newtons?|pascals?|kelvins?|volts?|amperes?|watts?|joules?|hertz|lit(?:re|er)s?|(?:milli|micro)(?:second|volt|lit(?:re|er))s?")
UNIT = rf"(?:\\%|%|(?:{SYMBOLS}|{WORDS})(?![A-Za-z]))"
BETWEEN = r"(?:\s|~|\\[,;:!> ]|\\(?:thinspace|enspace|quad|nobreakspace|hspace\*?\{[^}]*\}|,)|[{}$-])*"
UPRIGHT = r"\\(?:unit|si|mathrm|textrm|text|mbox|ensuremath|operatorname)\s*(?:\[[^\]]*\])?\s*\{"
# In a formula letters are variables unless they are upright. «in» is a unit where a blank that does not break or a stop is beside it.
UNIT_IN_TEXT = re.compile(rf"{BETWEEN}(?:{UNIT}|\\(?:unit|si)\b|\^\{{?\\circ|{UPRIGHT}{BETWEEN}(?:{UNIT}|in\b))|(?:~|\\,)in\b|\s+in\s*[.,;)]"
                          rf"|/(?:s|min|h|d|cm|mm|km|kg|mol)(?![A-Za-z])")
UNIT_IN_MATH = re.compile(rf"{BETWEEN}(?:\\%|\^\{{?\\circ|\\(?:unit|si|degree)\b|(?<!\d)\\(?:Omega|ohm)\b|''?|{UPRIGHT}{BETWEEN}(?:{UNIT}|in\b))|[^$]{{0,3}}\$")
QUANTITY = re.compile(r"\\(?:qty|SI|numrange|qtyrange|SIrange)\s*(?:\[[^\]]*\])?\{[^{}]*$")
# Arguments that are no prose. The text keeps its length, and a citation leaves a mark.
HIDDEN = (r"\\(?:label|[cC]ref|ref|eqref|pageref|autoref|nameref|bibitem|bibliography|bibliographystyle|input|include|includegraphics|val|rawval|tab|fig"
          r"|claim|ifflag|statement|quoted|verdict|[hv]space\*?|hskip|vskip|kern|setlength|addtolength|setcounter|addtocounter|usepackage|documentclass|rule|url|href"
          r"|color|textcolor|definecolor|resizebox|scalebox|raisebox|parbox|makebox|multicolumn|multirow|cmidrule|cline|addlinespace|fontsize"
          r"|begin|end|hypersetup|pdfbookmark|lstinputlisting|enlargethispage|linespread|vphantom|hphantom)(?![A-Za-z])\*?")
ARGUMENTS = {"rule": 2, "setlength": 2, "addtolength": 2, "setcounter": 2, "addtocounter": 2, "fontsize": 2, "definecolor": 3, "resizebox": 2}
DISPLAYS = re.compile(r"\\\[.*?\\\]|\$\$.*?\$\$|\\begin\{((?:equation|align|gather|multline|eqnarray|displaymath|flalign)\*?)\}.*?\\end\{\1\}", re.S)
VERBATIM = re.compile(r"\\begin\{(verbatim|lstlisting|Verbatim|tikzpicture|thebibliography)\*?\}.*?\\end\{\1\*?\}|\\verb\*?(\W).*?\2", re.S)
CITE = "\x03"
MONTHS = "January|February|March|April|May|June|July|August|September|October|November|December"
PLACES = r"(?:[\s~\d.,()–-]|[a-z]\)|and|or|of|in|[Pp]ages?|pp?\.|[Cc]hap(?:ter|\.)|[Ss]ec(?:tions?|s?\.)|[Ee]q(?:uations?|s?\.)|[Ff]ig(?:ures?|s?\.)|[Tt]ab(?:les?|\.)|[Nn]o\.|[Vv]ol\.)*"


def typed_numbers(text: str) -> list[tuple[int, str]]:
    """Returns line and number of each typed number in the LaTeX of a document's body."""
    kept = {number for number, line in enumerate(text.splitlines(), 1) if re.search(r"%\s*constant:\s*\S", line)}
    prose = readable(text)
    math = [(m.start(), m.end()) for m in re.finditer(r"(?<!\\)\$[^$]*\$|\\\(.*?\\\)", prose, re.S)]
    displays = [(m.start(), m.end()) for m in DISPLAYS.finditer(prose)]
    found = []
    for at, end, number, is_long in numerals(prose):
        in_display = any(a <= at < b for a, b in displays)
        formula = next((b for a, b in math if a <= at < b), None)
        has_unit = unit_follows(prose, at, end, formula, in_display)
        line = prose.count("\n", 0, at) + 1
        if (has_unit or (is_long and not in_display)) and line not in kept and not is_reference(prose, at, end, number, has_unit):
            found.append((line, number))
    return found


def numerals(prose: str):
    """Yields begin, end and text of each number, and whether it has more than two significant digits."""
    at = 0
    while match := NUMERAL.search(prose, at):
        at = match.end()
        before = prose[max(match.start() - 2, 0):match.start()]
        if re.search(r"[A-Za-z0-9._@]$|[A-Za-z]-$", before):  # it continues a word or a longer number, as in MEAE-4960
            continue
        digits = re.sub(r"\D", "", match[1] + (match[2] or "")).lstrip("0")
        if not match[2]:
            digits = digits.rstrip("0")
        yield match.start(), match.end(), match[0], len(digits) > MOST_DIGITS


def unit_follows(prose: str, at: int, end: int, formula: int | None, in_display: bool) -> bool:
    """Returns whether a number has a unit: behind it, behind its formula, or as the second argument of \\qty."""
    if QUANTITY.search(prose[max(at - 80, 0):at]):
        return True
    if formula is None and not in_display:
        return bool(UNIT_IN_TEXT.match(prose, end))
    inside = UNIT_IN_MATH.match(prose, end)
    if inside and not inside[0].endswith("$"):
        return True
    return formula is not None and bool(re.fullmatch(r"[\s}]*\$", prose[end:formula])) and bool(UNIT_IN_TEXT.match(prose, formula))


def is_reference(prose: str, at: int, end: int, number: str, has_unit: bool) -> bool:
    """Returns whether a number is a year, in parentheses, behind a month or beside a citation, or a place in a cited source."""
    before, after = prose[max(at - 160, 0):at], prose[end:end + 160]
    if re.fullmatch(r"(1[5-9]|20)\d\d", number):
        if before.endswith("(") and after.startswith(")") or re.search(rf"(?:{MONTHS})[\s~]*$", before):
            return True
        if re.match(rf"[\s~]*{CITE}", after):
            return True
    return not has_unit and bool(re.search(rf"{CITE}\s*,?{PLACES}$", before)
                or re.search(rf"\b(?:[Pp]ages?|pp?\.|[Cc]hapter|[Ss]ection|[Ee]qs?\.|[Ff]igs?\.|[Tt]ables?|\()[\s~(]*$", before)
                and re.match(rf"{PLACES}[\s~]*{CITE}", after))


def readable(text: str) -> str:
    """Returns LaTeX with blanks, line for line, in place of the preamble, of comments and of arguments that are no prose."""
    text = without_comments(text)
    text = VERBATIM.sub(blank, text)
    if r"\begin{document}" in text:
        preamble, begin, body = text.partition(r"\begin{document}")
        text = re.sub(r"[^\n]", " ", preamble + begin) + body
    text = re.sub(r"\\[a-z]*[cC]ite[a-z]*\*?\s*(?:\[[^\]]*\]\s*)*\{[^{}]*\}", lambda m: CITE + blank(m)[1:], text)
    return hide(text)


def hide(text: str) -> str:
    """Blanks the commands in HIDDEN with their arguments, and the optional arguments that are no prose."""
    at = 0
    while match := re.compile(HIDDEN).search(text, at):
        end = match.end()
        for _ in range(ARGUMENTS.get(match[0].strip("\\*"), 1)):
            while option := re.compile(r"\s*\[[^\]]*\]").match(text, end):
                end = option.end()
            if argument := re.compile(r"\s*\{(?:[^{}]|\{[^{}]*\})*\}|\s*-?[\d.]+\s*(?:pt|em|ex|mm|cm|in|sp|bp)").match(text, end):
                end = argument.end()
        if match[0].startswith("\\begin"):  # the width of a box, the columns of a table
            while option := re.compile(r"\[[^\]]*\]|\{(?:[^{}]|\{[^{}]*\})*\}").match(text, end):
                end = option.end()
        if match[0].startswith("\\begin") and re.match(r"\\begin\{" + DISPLAY_NAMES, text[match.start():]) or match[0].startswith("\\end"):
            at = end  # these delimit displays
            continue
        text = text[:match.start()] + re.sub(r"[^\n]", " ", text[match.start():end]) + text[end:]
        at = end
    return re.sub(r"(?<=\\\\)\[[^\]]*\]", blank, text)


DISPLAY_NAMES = r"(?:equation|align|gather|multline|eqnarray|displaymath|flalign)\*?\}"


def blank(match: re.Match) -> str:
    """Returns as many blanks as the match has characters; its lines stay."""
    return re.sub(r"[^\n]", " ", match[0])


def typed_in_script(text: str) -> list[tuple[int, str]]:
    """Returns line and number of what is typed into a gnuplot script: in its texts, in what it plots, and as data."""
    found, is_plot = [], False
    for number, line in enumerate(text.splitlines(), 1):
        code = re.sub(r"""("(?:[^"\\]|\\.)*"|'[^']*')|#.*""", lambda m: m[1] or "", line)
        is_plot = bool(re.match(r"\s*s?plot\b", line)) or (is_plot and was_continued)
        was_continued = code.rstrip().endswith("\\")
        if re.search(r"#\s*constant:\s*\S", line):
            continue
        if re.match(r"\s*\$\w+\s*<<", code) or re.search(r"""(['"])-\1""", code):
            found.append((number, "a block of data"))
        for string in re.findall(r""""(?:[^"\\]|\\.)*"|'[^']*'""", code):
            if string[1:2] != "#":
                found += [(number, typed) for _, typed in typed_numbers(string[1:-1])]
        if is_plot:
            drawn = re.sub(r""""(?:[^"\\]|\\.)*"|'[^']*'""", blank, code)
            found += [(number, typed) for _, _, typed, is_long in numerals(drawn) if is_long]
    return found
