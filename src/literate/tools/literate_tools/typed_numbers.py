# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds numbers typed into prose or scripts, where computed ones belong.

A number counts as typed if it has a unit, whatever separates the two, or more than two significant digits. Exempt are numbers
without a unit in displayed formulas, years, places in cited sources, and lines that end with `% constant: reason`.
"""

import re
from collections.abc import Iterator

from literate_tools.uses import without_comments

MOST_DIGITS = 2  # «of order 2», «40 elements»


def either(words: str) -> str:
    """Returns a pattern that matches any of these patterns, which blanks separate."""
    return "|".join(words.split())


NUMERAL = re.compile(
    r"(\d{1,3}(?:(?:\{,\}|\\,|,|~| )\d{3}(?!\d))+|\d+)((?:\.|\{\.\})\d+)?(?:\(\d+\))?"
    r"([eE][+-]?\d+|(?:\s*\\(?:times|cdot)\s*10)?\^(?:\{[+-]?\d+\}|\d))?")

PREFIX = r"(?:[munpkMGTµμ]|\\mu\s*\$?\s*|\\micro|da|d|c|h)?"
WITH_PREFIX = either(r"Pa Hz eV bar mol Wh Ah rad lm lx Bq Gy Sv [mgsNJWVAFHTCLlKΩ] \\(?:Omega|ohm)")
WITHOUT_PREFIX = either(
    r"[kMGT]i?B dB Np lbf? psi ksi min hour h ft sr rpm [°º][CF]? K S t"
    r" \\(?:degree|textdegree|celsius|textcelsius|percent)")
WORDS = either(
    r"per\s?cent pounds? inch(?:es)? feet foot degrees? (?:micro|milli|centi|kilo)?(?:met(?:re|er)|gramm?e?)s?"
    r" (?:milli|micro)?(?:seconds?|volts?|lit(?:re|er)s?) minutes? hours? days? weeks? years? newtons? pascals? kelvins?"
    r" amperes? watts? joules? hertz")
UNIT = rf"(?:\\%|%|(?:{PREFIX}(?:{WITH_PREFIX})|{WITHOUT_PREFIX}|{WORDS})(?![A-Za-z]))"
BLANK = r"(?:\s|~|\\[,;:!> ]|\\(?:thinspace|enspace|quad|nobreakspace|hspace\*?\{[^}]*\}))"
BETWEEN = rf"(?:{BLANK}|[{{}}$-])*"
UPRIGHT = rf"\\(?:{either('unit si mathrm textrm text mbox ensuremath operatorname')})\s*(?:\[[^\]]*\])?\s*\{{"
IN_UPRIGHT = rf"{UPRIGHT}{BETWEEN}(?:{UNIT}|in\b)"
# «in» is a unit after a non-breaking blank or before a punctuation mark.
UNIT_IN_TEXT = re.compile(
    rf"{BETWEEN}(?:{UNIT}|\\(?:unit|si)\b|\^\{{?\\circ|{IN_UPRIGHT})|(?:~|\\,)in\b|\s+in\s*[.,;)]"
    r"|/(?:s|min|h|d|cm|mm|km|kg|mol)(?![A-Za-z])")
# In a formula only upright letters are units.
UNIT_IN_FORMULA = re.compile(
    rf"{BETWEEN}(?:\\%|\^\{{?\\circ|\\(?:unit|si|degree)\b|(?<!\d)\\(?:Omega|ohm)\b|''?|{IN_UPRIGHT})")
QUANTITY = re.compile(r"\\(?:qty|SI|numrange|qtyrange|SIrange)\s*(?:\[[^\]]*\])?\{[^{}]*$")

# Commands whose arguments are not prose, and the number of arguments if there are several.
HIDDEN_NAMES = either(r"""
    label [cC]ref ref eqref pageref autoref nameref bibitem bibliography bibliographystyle input include includegraphics
    val rawval tab fig claim ifflag statement quoted verdict [hv]space hskip vskip kern setlength addtolength setcounter
    addtocounter usepackage documentclass rule url href color textcolor definecolor resizebox scalebox raisebox parbox
    makebox multicolumn multirow cmidrule cline addlinespace fontsize begin end hypersetup pdfbookmark lstinputlisting
    enlargethispage linespread vphantom hphantom""")
HIDDEN = re.compile(rf"\\({HIDDEN_NAMES})(?![A-Za-z])\*?")
N_ARGUMENTS = {"rule": 2, "setlength": 2, "addtolength": 2, "setcounter": 2, "addtocounter": 2, "fontsize": 2,
               "definecolor": 3, "resizebox": 2}
OPTION = re.compile(r"\s*\[[^\]]*\]")
ARGUMENT = re.compile(r"\s*\{(?:[^{}]|\{[^{}]*\})*\}|\s*-?[\d.]+\s*(?:pt|em|ex|mm|cm|in|sp|bp)")
DISPLAY = either("equation align gather multline eqnarray displaymath flalign")
DISPLAYS = re.compile(rf"\\\[.*?\\\]|\$\$.*?\$\$|\\begin\{{((?:{DISPLAY})\*?)\}}.*?\\end\{{\1\}}", re.S)
DISPLAY_ENDS = re.compile(rf"\\(?:begin|end)\s*\{{(?:{DISPLAY})\*?\}}")
VERBATIM = re.compile(
    rf"\\begin\{{({either('verbatim lstlisting Verbatim tikzpicture thebibliography')})\*?\}}.*?\\end\{{\1\*?\}}"
    r"|\\verb\*?(\W).*?\2", re.S)

CITE = "\x03"  # marks a citation in the readable text
CITATION = re.compile(r"\\[a-z]*[cC]ite[a-z]*\*?\s*(?:\[[^\]]*\]\s*)*\{[^{}]*\}")
MONTH = either("January February March April May June July August September October November December")
PLACE = either(r"[Pp]ages? pp?\. [Cc]hap(?:ter|\.) [Ss]ec(?:tions?|s?\.) [Ee]q(?:uations?|s?\.) [Ff]ig(?:ures?|s?\.)"
               r" [Tt]ab(?:les?|\.) [Nn]o\. [Vv]ol\.")
PLACES = rf"(?:[\s~\d.,()–-]|[a-z]\)|and|or|of|in|{PLACE})*"


def typed_numbers(text: str) -> list[tuple[int, str]]:
    """Returns the line and the text of each typed number in the body of a LaTeX document."""
    kept = {number for number, line in enumerate(text.splitlines(), 1) if re.search(r"%\s*constant:\s*\S", line)}
    prose = readable(text)
    formulas = [match.span() for match in re.finditer(r"(?<!\\)\$[^$]*\$|\\\(.*?\\\)", prose, re.S)]
    displays = [match.span() for match in DISPLAYS.finditer(prose)]
    found = []
    for at, end, number, is_long in numerals(prose):
        in_display = any(begin <= at < stop for begin, stop in displays)
        formula_end = next((stop for begin, stop in formulas if begin <= at < stop), None)
        has_unit = unit_follows(prose, at, end, formula_end, in_display)
        line = prose.count("\n", 0, at) + 1
        is_typed = has_unit or (is_long and not in_display)
        if is_typed and line not in kept and not is_reference(prose, at, end, number, has_unit):
            found.append((line, number))
    return found


def numerals(prose: str) -> Iterator[tuple[int, int, str, bool]]:
    """Yields the begin, end and text of each number, and whether it has more than MOST_DIGITS significant digits."""
    at = 0
    while match := NUMERAL.search(prose, at):
        at = match.end()
        before = prose[max(match.start() - 2, 0):match.start()]
        if re.search(r"[A-Za-z0-9._@]$|[A-Za-z]-$", before):  # part of a word, as in MEAE-4960
            continue
        digits = re.sub(r"\D", "", match[1] + (match[2] or "")).lstrip("0")
        if not match[2]:
            digits = digits.rstrip("0")
        yield match.start(), match.end(), match[0], len(digits) > MOST_DIGITS


def unit_follows(prose: str, at: int, end: int, formula_end: int | None, in_display: bool) -> bool:
    """Returns True if a number has a unit: after it, after its formula, or as the second argument of \\qty."""
    if QUANTITY.search(prose[max(at - 80, 0):at]):
        return True
    if formula_end is None and not in_display:
        return bool(UNIT_IN_TEXT.match(prose, end))
    if UNIT_IN_FORMULA.match(prose, end):
        return True
    if formula_end is None or not re.fullmatch(r"[\s}]*\$", prose[end:formula_end]):
        return False
    return bool(UNIT_IN_TEXT.match(prose, formula_end))


def is_reference(prose: str, at: int, end: int, number: str, has_unit: bool) -> bool:
    """Returns True for a year (in parentheses, after a month or a word such as «in», beside a citation) and for a place in a
    source."""
    before, after = prose[max(at - 160, 0):at], prose[end:end + 160]
    if re.fullmatch(r"(1[5-9]|20)\d\d", number):
        if before.endswith("(") and after.startswith(")"):
            return True
        if re.search(rf"(?:{MONTH})[\s~]*$", before) or re.match(rf"[\s~]*{CITE}", after):
            return True
        if not has_unit and re.search(r"\b(?:in|of|since|until|by|from|before|after)[\s~]+$", before, re.IGNORECASE):
            return True
    if has_unit:
        return False
    is_behind = re.search(rf"{CITE}\s*,?{PLACES}$", before)
    is_before = re.search(rf"(?:\b(?:{PLACE})|\()[\s~(]*$", before) and re.match(rf"{PLACES}[\s~]*{CITE}", after)
    return bool(is_behind or is_before)


def readable(text: str) -> str:
    """Returns LaTeX with blanks in place of the preamble, comments and arguments that are not prose. Line numbers stay."""
    text = VERBATIM.sub(blank, without_comments(text))
    if r"\begin{document}" in text:
        preamble, begin, body = text.partition(r"\begin{document}")
        text = re.sub(r"[^\n]", " ", preamble + begin) + body
    text = CITATION.sub(lambda match: CITE + blank(match)[1:], text)
    at = 0
    while match := HIDDEN.search(text, at):
        at = end_of_arguments(text, match)
        if not DISPLAY_ENDS.match(text, match.start()):
            text = text[:match.start()] + re.sub(r"[^\n]", " ", text[match.start():at]) + text[at:]
    return re.sub(r"(?<=\\\\)\[[^\]]*\]", blank, text)


def end_of_arguments(text: str, command: re.Match[str]) -> int:
    """Returns the end of a HIDDEN command's arguments, including optional ones."""
    end = command.end()
    n_arguments = 99 if command[1] == "begin" else N_ARGUMENTS.get(command[1], 1)
    for _ in range(n_arguments):
        while option := OPTION.match(text, end):
            end = option.end()
        # The width of a box or the columns of a table may follow \begin{…} directly.
        argument = ARGUMENT.match(text, end)
        if not argument or (command[1] == "begin" and text[end] != "{"):
            break
        end = argument.end()
    return end


def blank(match: re.Match[str]) -> str:
    """Returns blanks for all characters of a match except line ends."""
    return re.sub(r"[^\n]", " ", match[0])


def typed_in_script(text: str) -> list[tuple[int, str]]:
    """Returns the line and the text of each number typed into a gnuplot script: in strings, in plot commands, and as data."""
    string = re.compile(r""""(?:[^"\\]|\\.)*"|'[^']*'""")
    found, is_plot, was_continued = [], False, False
    for number, line in enumerate(text.splitlines(), 1):
        code = re.sub(rf"({string.pattern})|#.*", lambda match: match[1] or "", line)
        is_plot = bool(re.match(r"\s*s?plot\b", line)) or (is_plot and was_continued)
        was_continued = code.rstrip().endswith("\\")
        if re.search(r"#\s*constant:\s*\S", line):
            continue
        if re.match(r"\s*\$\w+\s*<<", code) or re.search(r"""(['"])-\1""", code):
            found.append((number, "a block of data"))
        for words in string.findall(code):
            if words[1:2] != "#":  # a colour
                found += [(number, typed) for _, typed in typed_numbers(words[1:-1])]
        if is_plot:
            found += [(number, typed) for _, _, typed, is_long in numerals(string.sub(blank, code)) if is_long]
    return found
