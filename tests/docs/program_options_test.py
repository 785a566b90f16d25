"""Compares the tables of options in docs/howto/deployment.md with what the programs print for --help.

program_options_test.py ROOT PROGRAM...
The heading above a table names the program. The column "without it" has the default that --help shows.
"""

import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
PROGRAMS = [pathlib.Path(one) for one in sys.argv[1:]]
OWN = "--listen"  # its default is another for each user


def options_of(program):
    """Returns what --help says of each option, "" where it says nothing: {"--report-interval": ("FLOAT", "1")}."""
    text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True, timeout=60).stdout
    found = re.findall(r"^  (?:-\w,)?(--[\w-]+)(?: ([A-Z]{2,})(?::\{\S+\})?(?:=(\S+))?)?", text, re.M)
    return {option: (value, default) for option, value, default in found if option != "--help"}


def rows_of(program):
    """Returns the cells of each row below the heading that names the program."""
    page = (ROOT / "docs/howto/deployment.md").read_text(encoding="utf-8")
    table = page.partition(f"\n## The options of `{program}`\n")[2].partition("\n## ")[0]
    return [line.strip("| ").split(" | ") for line in table.split("\n") if line.startswith("| `")]


class ProgramOptions(unittest.TestCase):
    def test_each_option_has_one_row(self):
        for program in PROGRAMS:
            rows = rows_of(program.name)
            self.assertGreater(len(rows), 2, program.name)
            self.assertEqual(sorted(row[0].strip("`") for row in rows), sorted(options_of(program)), program.name)

    def test_defaults_are_those_of_the_program(self):
        for program in PROGRAMS:
            without = {row[0].strip("`"): row[-1] for row in rows_of(program.name)}
            for option, (_, default) in options_of(program).items():
                if default and option != OWN:
                    self.assertEqual(without[option], f"`{default}`", option)

    def test_an_option_without_a_value_takes_none(self):
        for program in PROGRAMS:
            options = options_of(program)
            for row in rows_of(program.name):
                self.assertEqual(row[1] == "none", options[row[0].strip("`")][0] == "", row[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
