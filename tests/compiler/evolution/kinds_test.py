"""A member, a base and a parameter of every kind that an older process does not know take their defaults in a newer one.

  kinds_test.py --manager SUTURE_MANAGER --v1 PROGRAM --v2 PROGRAM
"""

import unittest

import kinds
from processes import LANES, run_tests, talk

PROGRAMS = {}

MEMBERS = {"base": "'d'", **{name: text for name, _, text in kinds.ADDED}}
PARAMETERS = {name: text for name, _, _, text in kinds.PARAMETERS}


def values(lines, source):
    """Returns what a process printed of the members that came from `source`."""
    words = [line.split(" ", 2) for line in lines]
    return {one[1]: one[2] for one in words if one[0] == source}


class Kinds(unittest.TestCase):
    maxDiff = None

    def test_a_new_provider_of_an_old_client(self):
        for lane in LANES:
            with self.subTest(lane):
                served, asked = talk(PROGRAMS, "v2", "v1", lane)
                self.assertEqual(asked[0], "put: done")
                self.assertEqual(values(served, "argument"), {"x": "2.5", **MEMBERS})
                self.assertEqual(values(served, "parameter"), PARAMETERS)
                self.assertEqual(values(asked, "event"), {"x": "2.5"})
                self.assertEqual(values(asked, "row"), {"x": "1.5"})

    def test_a_new_client_of_an_old_provider(self):
        for lane in LANES:
            with self.subTest(lane):
                served, asked = talk(PROGRAMS, "v1", "v2", lane)
                self.assertEqual(asked[0], "put: done")
                self.assertEqual(values(served, "argument"), {"x": "2.5"})
                self.assertEqual(values(asked, "event"), {"x": "2.5", **MEMBERS})
                self.assertEqual(values(asked, "row"), {"x": "1.5", **MEMBERS})


if __name__ == "__main__":
    run_tests(PROGRAMS)
