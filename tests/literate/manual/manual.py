# SPDX-License-Identifier: GPL-3.0-or-later
"""Takes the examples out of src/literate/README.md, so that tests compile, typeset and compare what its readers copy.

A fenced example is known by the heading above it and its language, as in «Values: cpp»; a heading is a section's, up to
its colon, or the bold words that begin a paragraph. The rows of a table are known by that heading and the first cell of
the table's own heading, as in «Tables: cell»."""

import re
import sys


class Manual:
    def __init__(self, text):
        self.fences = []  # (name, code)
        self.tables = {}  # name -> rows of cells, without the heading
        self.headings = {}  # name -> the cells of the heading
        self.prose = ""  # what is neither a fence nor a table
        heading = ""
        lines = iter(text.split("\n"))
        table = None
        for line in lines:
            if line.startswith("```"):
                language, code = line[3:].strip(), []
                for line in lines:
                    if line.startswith("```"):
                        break
                    code.append(line)
                self.fences.append((f"{heading}: {language}", "\n".join(code)))
                continue
            if line.startswith("|"):
                cells = [cell.strip() for cell in line.strip("| \n").split(" | ")]
                if table is None:
                    table = f"{heading}: {cells[0].replace('`', '')}"
                    self.headings[table], self.tables[table] = cells, []
                elif not set(line) <= set("|- "):
                    self.tables[table].append(cells)
                continue
            table = None
            self.prose += line + "\n"
            if found := re.match(r"#+ ([^:]*)|\*\*([^*]*?)[.:]?\*\*", line):
                heading = (found[1] or found[2]).strip("`. ")

    def example(self, name):
        """The code of the only fence of this name."""
        (code,) = [code for other, code in self.fences if other == name]
        return code


def codes(text):
    """The pieces of code in a line of text: what stands between backquotes."""
    return re.findall(r"`([^`]+)`", text)


def filled(template, manual, sign):
    """The template, whose lines «SIGN EXAMPLE name» give way to that fence, and «SIGN EACH name => pattern» to the pattern
    once for each piece of code in the first cells of that table, with {code}, {n}, its number, and {2}, {3}, … for the
    other cells of its row; code without an argument takes the second pattern, if there is one: «SIGN EACH name => pattern =>
    pattern». Returns the text, and the names of fences and tables that it used."""
    text, used = [], set()
    for line in template.split("\n"):
        found = re.match(rf"\s*{re.escape(sign)} (EXAMPLE|EACH) (.*)", line)
        if not found:
            text.append(line)
        elif found[1] == "EXAMPLE":
            used.add(found[2])
            text.append(manual.example(found[2]))
        else:
            name, pattern, *of_names = found[2].split(" => ")
            used.add(name)
            n = 0
            for cells in manual.tables[name]:
                for code in codes(cells[0]):
                    n += 1
                    piece = of_names[0] if of_names and "(" not in code else pattern
                    piece = piece.replace("{code}", code).replace("{n}", str(n))
                    for i, cell in enumerate(cells[1:], 2):
                        piece = piece.replace("{%d}" % i, cell)
                    text.append(piece)
    return "\n".join(text), used


if __name__ == "__main__":  # manual.py README NAME: prints that example
    with open(sys.argv[1], encoding="utf-8") as file:
        print(Manual(file.read()).example(sys.argv[2]))
