"""A header with a planted fault is made as small as the fault allows: reduced_test.py --suture BUILD

The tests plant a text, and an error that suturec finds, in headers that are drawn at random.
"""

import argparse
import pathlib
import shutil
import sys
import tempfile
import unittest

from random_header import Command, Header, is_away
from random_headers_test import failing
from random_types import Field
from reduce import reduced
from tools import Failure, Tools, way_of

parser = argparse.ArgumentParser()
parser.add_argument("--suture", type=pathlib.Path, required=True)
SUTURE = parser.parse_args().suture.resolve()


def large_header():
    """Returns the first header with a contract and at least two structs. The last, which gets the fault, can be alone and have no other member."""
    for header in map(Header, range(1, 1000)):
        last = list(header.structs)[-1]
        if len(header.structs) > 1 and header.contract and not is_away(last) and last not in header.templates:
            return header
    raise AssertionError("no header is like that")


class Reduced(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="reduced_", dir=SUTURE))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def test_one_member_is_left_of_all_types(self):
        header = large_header()
        fields = header.structs[list(header.structs)[-1]]
        fields.append(Field("planted", "std::map<std::int8_t, std::tuple<std::string, std::deque<float>>>", (2, 3, 4), True))
        small = reduced(header, lambda header: "std::deque<float>" in header.header())
        self.assertEqual(1, len(small.structs), small.header())
        [[member]] = small.structs.values()
        self.assertEqual(("planted", "std::deque<float>", (4,)), (member.name, member.type, member.bounds))
        self.assertEqual((None, {}), (small.contract, small.enums))

    def test_one_command_is_left_of_a_contract(self):
        header = large_header()
        header.commands.insert(1, Command("SUTURE_COMMAND() virtual void planted() = 0;", []))
        small = reduced(header, lambda header: "void planted()" in header.header())
        self.assertEqual(["SUTURE_COMMAND() virtual void planted() = 0;"], [command.text for command in small.commands])
        self.assertEqual(({}, {}), (small.structs, small.enums))

    def test_what_a_tool_refuses_is_reported_small(self):
        header = large_header()
        header.structs[list(header.structs)[-1]].append(Field("planted", "std::set<double>", (2,), True))
        said = []
        self.assertEqual([header], failing(Tools(SUTURE), [header], self.folder, said.append))
        report = said[0]
        self.assertIn(f"seed {header.name[1:]}: suturec refuses it: suture-", report)
        self.assertIn("std::set<double> planted{};", report)
        self.assertEqual(1, report.count("SUTURE_TYPE") + report.count("SUTURE_EXTERNAL_TYPE"), report)
        self.assertNotIn("SUTURE_INTERFACE", report)

    def test_a_fault_of_another_kind_does_not_count(self):
        """The command, which the reduction takes away first, keeps the other fault away."""
        header = large_header()
        header.commands = [Command("SUTURE_COMMAND() virtual void planted() = 0;", [])]
        header.structs[list(header.structs)[-1]].append(Field("other", "float"))

        def failure_of(smaller):
            if "void planted()" in smaller.header():
                return Failure("suturec", way_of("suturec", 1, "h.h:1:2: error: this is planted [suture-planted]"), "")
            return Failure("suturec", way_of("suturec", 1, "h.h:1:2: error: no 'planted'"), "")

        first = failure_of(header)
        small = reduced(header, lambda smaller: first.is_like(failure_of(smaller)))
        self.assertEqual("suturec refuses it: suture-planted", str(first))
        self.assertIn("void planted()", small.header())

    def test_the_way_of_a_failure_has_no_names(self):
        ways = [way_of("g++", 1, f"h{n}.suture.h:{n}:1: error: unused parameter ‘{name}’ [-Wunused]\nh.h: error: more")
                for n, name in ((1, "a"), (22, "b"))]
        self.assertEqual(["says: unused parameter _ [-Wunused]"] * 2, ways)
        self.assertEqual("crashes", way_of("suturec", -11, ""))
        self.assertEqual("differs: two encodings differ", way_of("round trip", 1, "::h1::Text: two encodings differ\n"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
