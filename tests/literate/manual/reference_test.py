#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""reference_test.py SOURCE_DIR LITERATE: the manual names all that a paper may use, each macro, option, argument, target
and C++ name, and nothing that is not there."""

import pathlib
import re
import subprocess
import sys

from claims import claim, finish
from manual import Manual, codes

source, literate = map(pathlib.Path, sys.argv[1:])
engine = source / "src/literate"
readme = (engine / "README.md").read_text()
manual = Manual(readme)
everything = "\n".join(codes(readme.replace("```", "")) + [code for _, code in manual.fences])
words = set(re.findall(r"(?<!--)\b\w+", everything))


def same(what, there, named):
    """Either list holds what the other holds."""
    for name in sorted(set(there) - set(named)):
        claim(f"the manual names the {what} {name}", False)
    for name in sorted(set(named) - set(there)):
        claim(f"there is the {what} {name} that the manual names", False)


def text_of(file):
    return (source / file).read_text()


# The macros of literate.sty. Those with an @ are its own, and Literate… is the language of generated files.
sty = text_of("src/literate/document/literate.sty")
defined = set(re.findall(r"\\(?:newcommand|DeclareRobustCommand|def)\*?\{?\\([A-Za-z]+)(?![A-Za-z@])", sty))
macros = {name for name in defined if not name.startswith("Literate")}
macros |= {"LiterateCitedName", "LiterateClaimPlacement", "LiterateFindingsHead", "LiterateLedgerHead", "LiterateLedgerPlace",
           "LiterateLedgerSize", "LiterateLimitAges", "LiterateLimits", "LiterateLimitsName", "LiterateListingPlacement", "LiterateOwnName",
           "LiterateSourceUrl"}  # which a document may redefine
macros |= set(re.findall(r'"(LiteratePicture)"', text_of("src/literate/page/expansion_definitions.cpp")))  # of page.tex
of_latex = {"author", "begin", "caption", "cite", "columnwidth", "documentclass", "degree", "emph", "end", "ifdim", "includegraphics",
            "infty", "label", "newcommand", "ref", "renewcommand", "rule", "small", "textbf", "theta", "usepackage"}
of_latex |= {"foo"}  # which the page does not know
latex = set(re.findall(r"\\([A-Za-z]+)", everything.replace(r"\\", "\\")))
same("macro", macros - {"MakeUppercase"}, latex - of_latex)

# The options that \val, \rawval, \fig and \tab take are those that the code knows.
restyle = text_of("src/literate/prose/restyle.cpp")
known = re.findall(r'"(\w+)"', re.search(r"require_known\(options, \{(.*?)\}", restyle)[1])
taken = re.findall(r"\\(?:raw)?val\[(.*?)\]", everything)
same("option of \\val", known, {name for options in taken for name in re.findall(r"(\w+)=", options)})
formats = re.findall(r'^  if \(name == "(\w+)"\)', restyle, re.M)
claim("the formats are found", formats)
same("format of \\val", formats, re.findall(r"format=(\w+)", everything))

# The commands and options of the program
said = subprocess.run([literate, "--help-all"], capture_output=True, text=True, check=True).stdout
commands = {}
for command in manual.tables["Install: command"]:
    usage = codes(command[0])[0].split()
    commands[usage[1]] = set(re.findall(r"--[\w-]+", command[0]))
there = re.findall(r"^  (\w+) ", subprocess.run([literate, "--help"], capture_output=True, text=True,
                                                check=True).stdout.split("Subcommands:")[1], re.M)
same("command of literate", there, commands)
for command in there:
    said = subprocess.run([literate, command, "--help"], capture_output=True, text=True, check=True).stdout
    same(f"option of literate {command}", set(re.findall(r"--[\w-]+", said)) - {"--help"}, commands.get(command, ()))

# literate_add_paper: its arguments and its targets
cmake = text_of("src/literate/cmake/AddPaper.cmake")
parsed = re.search(r'cmake_parse_arguments\(PARSE_ARGV 0 arg "" "(.*?)" "(.*?)"\)', cmake)
arguments = (parsed[1] + ";" + parsed[2]).split(";")
same("argument", arguments, codes(" ".join(row[0] for row in manual.tables["The build: argument"])))
targets = set(re.findall(r"add_custom_target\(\$\{name\}(-\w+)?", cmake))
targets |= {"-" + script for script in re.findall(r"^  literate_add_script\((\w+)", cmake, re.M)}
targets -= {"-made"}  # a step of the others, not one that anybody asks for
same("target", {"mypaper" + target for target in targets},
     codes(" ".join(row[0] for row in manual.tables["The build: target"])))

# The template's Makefile has the same targets, and the variables that the manual names
makefile = text_of("src/literate/template/Makefile")
made = set(re.search(r"^\.PHONY: (.*)$", makefile, re.M)[1].split())
own = {"configured", "report", "test", "setup", "clean", "help"}
same("target of the template's Makefile", made - own, {target.lstrip("-") for target in targets if target})
named = set(re.findall(r"\bmake ([a-z][\w-]*)", everything)) | set(re.findall(r"`make ([a-z][\w-]*)", readme))
for target in named - made - {"test-all"}:  # of the engine's own repository
    claim(f"the template's Makefile has the target {target}", False)
exported = set(re.search(r"^export (.*)$", makefile, re.M)[1].split())
for variable in exported | {"CMAKE_ARGUMENTS"}:
    claim(f"the manual names the variable {variable}", re.search(rf"\b{variable}\b", everything))

# What a paper's program calls: each public name of these headers that is not an answer for the engine itself.
listed = {
    "src/literate/values/format.hpp": r"^Format (\w+)\(|^  Format (\w+)\(\w*\) const;",
    "src/literate/tables/cell.hpp": r"^  (?:static )?Cell (\w+)\(",
    "src/literate/tables/column.hpp": r"^  (?:static )?Column (\w+)\(",
    "src/literate/tables/table.hpp": r"^  Table& (\w+)\(",
    "src/literate/claims/criterion.hpp": r"^  static Criterion (\w+)\(",
    "src/literate/document/document.hpp": r"^  void (value|flag|table|figure|check|claim)\(",
    "src/literate/figures/figure.hpp": r"^  (?:double|std::map<.*>) (\w+) = |^struct (FigureData)",
    "src/literate/imports/import_json.hpp": r"^void (\w+)\(|^  std::.* (\w+) = ",
    "src/literate/imports/import_csv.hpp": r"^void (\w+)\(",
    "src/literate/main/main.hpp": r"^  std::\S+ (\w+);",
    "src/config/table.hpp": r"^  (?:\[\[noreturn\]\] )?[\w:<>]+ (\w+)\(.*const;",
}
for header, pattern in listed.items():
    found = {name for names in re.findall(pattern, text_of(header), re.M)
             for name in ((names,) if isinstance(names, str) else names) if name}
    claim(f"{header} has public names", found)
    for name in sorted(found - words - {"excerpts"}):  # which this_paper() brings
        claim(f"the manual names {name} of {header}", False)

finish()
