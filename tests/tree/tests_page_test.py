"""Every test that docs/tests.md says runs now is in the tree, and so is every one that SECURITY.md names.

tests_page_test.py ROOT BUILD
The first column of a table of moved tests has names as they were; all other names in backquotes have to be there: suites and cases of
gtest, programs and libraries, tests of ctest (which BUILD knows), figures of suture-bench, and files.
"""

import json
import pathlib
import re
import subprocess
import sys
import unittest

ROOT, BUILD = (pathlib.Path(one).resolve() for one in (sys.argv.pop(1), sys.argv.pop(1)))
NAME = re.compile(r"`([^`]+)`")
CASE = re.compile(r"\bTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)")
TARGET = re.compile(r"\b(?:suture_)?add_(?:executable|library|types_test)\(\s*([\w.-]+)")
OLD = {"Test", "Scenario"}  # the head of a column of what was


def names_of(page):
    """Returns the names that the page says are there."""
    head, names = "", []
    for line in page.splitlines():
        cells = line.strip("|").split("|") if line.startswith("|") else [line]
        head = (head or cells[0].strip()) if line.startswith("|") else ""
        for cell in cells[1:] if head in OLD else cells:
            names += NAME.findall(cell)
    return names


class Known:
    def __init__(self, sources, lists, tests, files=()):
        self.cases = {found for text in sources for found in CASE.findall(text)}
        self.suites = {suite for suite, _ in self.cases}
        self.targets = {name for text in lists for name in TARGET.findall(text)}
        self.tests = set(tests)
        self.texts = sources
        self.files = set(files)

    def has(self, name):
        if re.fullmatch(r"[A-Z]\w+", name):
            return name in self.suites
        if case := re.fullmatch(r"([A-Z]\w+)\.(?:\*|(\w+)(\.\.\.)?)", name):
            suite, begin, more = case.groups()
            return any(one == suite and (not begin or other == begin or (more and other.startswith(begin))) for one, other in self.cases)
        if re.fullmatch(r"[a-z]\w*[_-][\w-]+", name):
            return name in self.targets
        if re.fullmatch(r"\w+\.(cpp|h|sh)", name):
            return name in self.files
        if re.fullmatch(r"[a-z]\w*(\.\w+)+", name):
            return any(test == name or test.endswith("." + name) for test in self.tests) or any(name in text for text in self.texts)
        return True  # a word, a command or a file


def read(*patterns):
    return [path.read_text(encoding="utf-8") for pattern in patterns for path in ROOT.glob(pattern)]


class Page(unittest.TestCase):
    def test_each_name_is_there(self):
        listed = subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1"], capture_output=True, text=True, check=True)
        tests = [one["name"] for one in json.loads(listed.stdout)["tests"]]
        known = Known(read("tests/**/*.cpp", "tests/bench/bounds.txt"), read("tests/**/CMakeLists.txt", "runtime/**/CMakeLists.txt"), tests,
                      [path.name for path in ROOT.glob("tests/**/*.*")])
        for page, least in (("docs/tests.md", 50), ("SECURITY.md", 30)):
            names = names_of((ROOT / page).read_text(encoding="utf-8"))
            self.assertGreater(len(names), least)
            self.assertEqual([name for name in names if not known.has(name)], [], page)

    def test_files_are_there(self):
        for name in names_of((ROOT / "docs/tests.md").read_text(encoding="utf-8")):
            if name.startswith("tests/"):
                self.assertTrue((ROOT / name.split()[0]).exists(), name)

    def test_a_name_that_is_gone_is_found(self):
        known = Known(["TEST_F(Law, HoldsAlways) {}\nreport(\"network.reconnect\");"], ["add_executable(law_test x.cpp)"], ["a.cmake.rest"], ["law.h"])
        for name in ("Law", "Law.*", "Law.HoldsAlways", "Law.Holds...", "law_test", "cmake.rest", "network.reconnect", "law.h", "long"):
            self.assertTrue(known.has(name), name)
        for name in ("Lore", "Lore.*", "Law.Holds", "Law.Breaks...", "lore_test", "cmake.first", "network.forgets", "lore.h"):
            self.assertFalse(known.has(name), name)

    def test_what_was_may_be_gone(self):
        self.assertEqual(names_of("Run `a`.\n\n| Test | Runs now |\n|---|---|\n| `b` | `c`, `d` |\n\n| Tier | Does |\n|---|---|\n| `e` | `f` |"),
                         ["a", "c", "d", "e", "f"])


if __name__ == "__main__":
    unittest.main()
