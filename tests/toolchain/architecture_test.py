# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the links between libraries, the order of rooms within a folder, and the includes. (The compiler already ensures that a
folder includes only headers of libraries that it links.)"""
import re
import sys
import unittest

import source_tree

MECHANICS = {"numerics", "elasticity", "contact", "line_contact", "point_contact", "block"}
# Folders without a library.
NO_LIBRARY = {"app", "course", "toolchain"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
LATEX = re.compile(r"\\(begin|end|frac|sqrt|text\w*|math\w*|emph|cite|ref|label|eqref|val|tab|fig|claim|sigma|pi|int|sum|cdot)\b")


def read_libraries(path: str) -> dict[str, tuple[set[str], list[str]]]:
    """Reads the file that CMake wrote, with lines «name|folder|links|rooms»: {name: (links, rooms)}."""
    libraries = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.strip():
                name, _, links, rooms = line.rstrip("\n").split("|")
                libraries[name] = (set(links.split()), rooms.split())
    return libraries


def reach(name: str, graph: dict[str, set[str]]) -> set[str]:
    """Returns all names that this one needs, directly or indirectly; includes itself only in a cycle."""
    found: set[str] = set()
    open_names = [name]
    while open_names:
        for need in graph.get(open_names.pop(), set()) - found:
            found.add(need)
            open_names.append(need)
    return found


def cycles(graph: dict[str, set[str]]) -> list[str]:
    return sorted(name for name in graph if name in reach(name, graph))


def sources(folder: str = "src") -> list[str]:
    return [name for name in source_tree.files(folder) if name.endswith((".hpp", ".cpp"))]


class Architecture(unittest.TestCase):
    def setUp(self):
        self.libraries = read_libraries(LIST)
        self.links = {name: links for name, (links, _) in self.libraries.items()}

    def test_every_folder_with_sources_is_a_library(self):
        for name in sources():
            self.assertIn(name.split("/")[1], self.libraries.keys() | NO_LIBRARY, name)

    def test_links_have_no_cycle(self):
        self.assertEqual(cycles(self.links), [])

    def test_a_cycle_of_three_is_found(self):
        self.assertEqual(cycles({"a": {"b", "d"}, "b": {"c"}, "c": {"a"}, "d": {"e"}}), ["a", "b", "c"])

    def test_mechanics_and_engine_do_not_link_each_other_except_numerics(self):
        for name in MECHANICS:
            self.assertFalse(reach(name, self.links) & {"literate", "paper", "assignment", "config"}, name)
        self.assertFalse(reach("literate", self.links) & (MECHANICS - {"numerics"}))

    def test_only_the_course_links_the_assignment(self):
        for name in self.libraries.keys() - {"assignment"}:
            self.assertNotIn("assignment", reach(name, self.links), name)

    def test_mechanics_contains_no_latex(self):
        for folder in sorted(MECHANICS):
            for name in sources(f"src/{folder}"):
                self.assertIsNone(LATEX.search(source_tree.text(name)), name)

    def test_a_room_includes_only_itself_and_earlier_rooms(self):
        for library, (_, rooms) in self.libraries.items():
            for name in sources(f"src/{library}") if rooms else []:
                here = name.split("/")[2] if name.count("/") > 2 else None
                for header in INCLUDE.findall(source_tree.text(name)):
                    if here and header.startswith(library + "/") and header.count("/") > 1:
                        self.assertIn(header.split("/")[1], rooms[: rooms.index(here) + 1], f"{name} includes {header}")

    def test_includes_have_no_cycle(self):
        needs: dict[str, set[str]] = {}  # a header and its source count as one file
        for path in sources():
            name = path.removeprefix("src/").rsplit(".", 1)[0]
            headers = {header.rsplit(".", 1)[0] for header in INCLUDE.findall(source_tree.text(path))}
            needs.setdefault(name, set()).update(headers - {name})
        self.assertEqual(cycles(needs), [])


if __name__ == "__main__":
    LIST = sys.argv.pop()  # the file that CMake wrote
    unittest.main(argv=sys.argv[:1])
