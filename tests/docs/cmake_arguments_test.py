"""Compares docs/howto/cmake.md with the arguments that suture_generate() reads, and with the words of its refusals.

cmake_arguments_test.py ROOT
"""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
CMAKE = ROOT / "compiler" / "cmake"


def section(text, heading):
    return text.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]


def rows(text):
    """Returns the cells of each row that begins with a name."""
    return [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.split("\n") if line.startswith("| `")]


def names_in(words):
    return re.findall(r"[A-Z][A-Z_]+", words)


class CMakePage(unittest.TestCase):
    def setUp(self):
        page = (ROOT / "docs/howto/cmake.md").read_text(encoding="utf-8")
        self.arguments = section(page, "The arguments")
        self.others = section(page, "Variables and targets")
        self.function = (CMAKE / "suture_generate.cmake").read_text(encoding="utf-8")
        self.checks = (CMAKE / "suture_generate_checks.cmake").read_text(encoding="utf-8")
        self.read = re.search(r'cmake_parse_arguments\(PARSE_ARGV 0 arg (.*)\)', self.function)[1]

    def test_the_table_has_the_arguments_that_are_read(self):
        self.assertEqual(sorted(row[0].strip("`") for row in rows(self.arguments)), sorted(names_in(self.read)))

    def test_only_options_have_no_value(self):
        options = names_in(self.read.split('"')[1])
        self.assertEqual([row[0].strip("`") for row in rows(self.arguments) if row[1] == "none"], options)

    def test_a_refusal_names_the_arguments_that_are_read(self):
        known = re.search(r'set\(known "it takes (.*)"\)', self.checks)[1]
        self.assertEqual(sorted(names_in(known)), sorted(names_in(self.read)))

    def test_the_first_lines_of_the_function_name_them_too(self):
        head = self.function.partition("\ninclude(")[0]
        self.assertEqual(set(names_in(self.read)) - set(names_in(head)), set())

    def test_each_refusal_has_the_words_of_the_page(self):
        refusals = re.findall(r"message\(FATAL_ERROR(.*?)\)\n", self.checks, re.S)
        told = [words for row in rows(self.arguments) for words in re.findall(r"`([^`]+)`", row[-1])]
        told += re.findall(r"with `([^`]+)`", self.arguments)
        self.assertGreater(len(told), 15)
        for words in told:
            self.assertTrue(any(words in refusal for refusal in refusals), f"no refusal says '{words}'")
        committed = ("SUTUREC_EXECUTABLE", "there is no suturec")  # they are about variables, not arguments
        for refusal in refusals:
            self.assertTrue(any(words in refusal for words in (*told, *committed)), f"the page does not tell of {refusal}")

    def test_variables_and_targets_are_there(self):
        text = "\n".join(path.read_text(encoding="utf-8") for path in CMAKE.glob("suture_generate*.cmake"))
        found = rows(self.others)
        self.assertGreater(len(found), 5)
        for row in found:
            self.assertIn(row[0].strip("`"), text)


if __name__ == "__main__":
    unittest.main()
