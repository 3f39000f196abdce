# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds each student's submission and reads the files of the exercises."""
import io
import os
import stat
import tempfile
import unittest
import zipfile
from pathlib import Path

import toy_course
from toy_course import TOY, write

import assignment
import submission
from errors import BadInput

TOY_ASSIGNMENT = assignment.read(TOY / "assignment.toml")
FILES = {"src/square.cpp": b"square", "src/sum.cpp": b"sum"}


def packed(files, links=()):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in files.items():
            file.writestr(name, content)
        for name in links:
            info = zipfile.ZipInfo(name)
            info.external_attr = (stat.S_IFLNK | 0o777) << 16
            file.writestr(info, "/etc/passwd")
    return stream.getvalue()


def locked(content):
    """Marks the file in a zip as protected by a password."""
    content = bytearray(content)
    for mark, offset in ((b"PK\x01\x02", 8), (b"PK\x03\x04", 6)):
        content[content.index(mark) + offset] |= 1
    return bytes(content)


class Submissions(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name, "class")
        self.folder.mkdir()

    def found(self, source=None):
        """Returns {id: the files, or the reason why there are none}."""
        result = {}
        for one in submission.submissions_in(source or self.folder):
            try:
                result[one.id] = one.read_files(TOY_ASSIGNMENT)
            except BadInput as error:
                result[one.id] = str(error)
        return result

    def test_the_name_of_a_folder_or_zip_is_the_id(self):
        write(FILES, self.folder / "ada")
        write({"bob.zip": packed(FILES), "Cleo.ZIP": packed(FILES), ".DS_Store": "x"}, self.folder)
        self.assertEqual(self.found(), {"Cleo": FILES, "ada": FILES, "bob": FILES})

    def test_zips_in_folders_deep_folders_flat_folders_and_zips_from_a_mac_are_read(self):
        deep = {f"hw 1/solution/{name}": content for name, content in FILES.items()}
        write({"hw.zip": packed(deep), "report.pdf": b"x"}, self.folder / "ada")
        write(deep, self.folder / "bob")
        write({"square.cpp": b"square", "sum.cpp": b"sum"}, self.folder / "cleo")
        mac = {**FILES, "__MACOSX/src/._square.cpp": b"junk", "src/._square.cpp": b"junk", "src/.DS_Store": b"junk"}
        write({"dan.zip": packed(mac)}, self.folder)
        write({"eve.zip": packed({name.replace("/", "\\"): content for name, content in FILES.items()})}, self.folder)
        self.assertEqual(self.found(), dict.fromkeys(["ada", "bob", "cleo", "dan", "eve"], FILES))

    def test_a_file_in_src_takes_precedence(self):
        write({**FILES, "old/square.cpp": b"old"}, self.folder / "ada")
        self.assertEqual(self.found()["ada"], FILES)

    def test_bytes_are_not_changed(self):
        odd = {"src/square.cpp": b"\xef\xbb\xbfdouble x = 1\r.5;\r\n\xff"}
        write(odd, self.folder / "ada")
        self.assertEqual(self.found()["ada"], odd)

    def test_names_made_by_moodle_and_canvas_contain_the_id(self):
        moodle = {"Ada Love_4711_assignsubmission_file_/hw.zip": packed(FILES),
                  "Bob B_4712_assignsubmission_file_square.cpp": b"square", "Bob B_4712_assignsubmission_file_sum.cpp": b"sum",
                  "Ada Love_4711_assignsubmission_onlinetext_onlinetext.html": b"<p>", "Cleo_4713_assignsubmission_file/src/sum.cpp": b"sum"}
        canvas = {"loveada_4711_990001_hw-2.zip": packed(FILES), "bob_LATE_4712_990002_square-1.cpp": b"square",
                  "bob_LATE_4712_990003_sum.cpp": b"sum", "cleo_4713_990004_sum.cpp": b"sum"}
        expected = {"4711": FILES, "4712": FILES, "4713": {"src/sum.cpp": b"sum"}}
        for files in (moodle, canvas):
            write({"all.zip": packed(files)}, self.folder.parent)
            self.assertEqual(self.found(self.folder.parent / "all.zip"), expected)
            write(files, self.folder)
            self.assertEqual(self.found(), expected)
            for path in sorted(self.folder.rglob("*"), reverse=True):
                path.rmdir() if path.is_dir() else path.unlink()

    def test_an_unusable_submission_has_a_reason(self):
        write({"damaged.zip": packed(FILES)[:-30], "locked.zip": locked(packed({"src/square.cpp": b"x"})), "none.zip": packed({"a": b""}),
               "link_in_zip.zip": packed({}, ["src/square.cpp"]), "large.zip": packed({"src/sum.cpp": b"\n" * (65 << 10)}),
               "twice.zip": packed({"a/src/sum.cpp": b"1", "b/src/sum.cpp": b"2"}), "-rf.zip": packed(FILES), "ada.zip": packed(FILES),
               "notes.txt": "x"}, self.folder)
        write(FILES, self.folder / "ada")
        for name in ("linked_file/src", "linked_src", "pipe/src", "empty"):
            (self.folder / name).mkdir(parents=True)
        (self.folder / "link").symlink_to(self.folder / "ada")
        (self.folder / "linked_file/src/square.cpp").symlink_to("/etc/passwd")
        (self.folder / "linked_src/src").symlink_to(self.folder / "ada/src")
        os.mkfifo(self.folder / "pipe/src/square.cpp")
        none = "none of the files src/square.cpp, src/sum.cpp, src/cube.cpp was submitted"
        special = "src/square.cpp is a link or a special file"
        self.assertEqual(self.found(), {
            "damaged": "the zip is damaged: File is not a zip file", "none": none, "notes.txt": none, "empty": none, "linked_src": none,
            "locked": "src/square.cpp cannot be read: it needs a password",
            "link_in_zip": special, "linked_file": special, "pipe": special, "large": "src/sum.cpp is larger than 64 kB",
            "twice": "src/sum.cpp was submitted twice", "link": none,
            "-rf": "its name is not an id: ids begin with a letter or digit and contain letters, digits, spaces and _.@+-",
            "ada": "there are two submissions, ada and ada.zip"})

    def test_paths_that_climb_out_of_a_zip_write_nothing(self):
        write({"ada.zip": packed({"../../climbed/src/square.cpp": b"square", "/etc/sum.cpp": b"sum"})}, self.folder)
        self.assertEqual(self.found()["ada"], {"src/square.cpp": b"square"})
        self.assertEqual(sorted(path.name for path in self.folder.parent.rglob("*")), ["ada.zip", "class"])

    def test_a_zip_bomb_is_read_only_up_to_the_size_limit(self):
        write({"ada.zip": packed({"src/square.cpp": b"\n" * 200_000_000})}, self.folder)
        self.assertLess((self.folder / "ada.zip").stat().st_size, 1_000_000)
        self.assertEqual(self.found()["ada"], "src/square.cpp is larger than 64 kB")

    def test_a_source_without_submissions_is_bad_input(self):
        write({"src/square.cpp": b""}, self.folder.parent / "single")
        (self.folder.parent / "text.zip").write_text("no zip")
        for name, error in (("class", "this folder or zip contains no submissions"),
                            ("text.zip", "the zip is damaged"), ("single", "this is a single submission")):
            with self.assertRaisesRegex(BadInput, error):
                self.found(self.folder.parent / name)


if __name__ == "__main__":
    toy_course.main()
