"""Processes of two versions of one contract work together, whichever provides.

  peers_test.py --manager SUTURE_MANAGER --v1 PROGRAM --v2 PROGRAM
"""

import unittest

from processes import LANES, run_tests, talk

PROGRAMS = {}

V1_SEES_V1 = "label='first' x=1.5 gone=8 mode=On"
V2_SEES_V1 = "label='first' east=1.5 weight=2.5 note='' mode=On"
V1_SEES_V2 = "label='second' x=-2.5 gone=0 mode=Off"
V2_SEES_V2 = "label='second' east=-2.5 weight=3 note='new' mode=Off"
V1_BACK_FROM_V2 = "label='first' x=1.5 gone=0 mode=On"
V2_BACK_FROM_V1 = "label='second' east=-2.5 weight=2.5 note='' mode=Off"


class Peers(unittest.TestCase):
    def judge(self, server, client, served, asked):
        for lane in LANES:
            with self.subTest(lane):
                self.assertEqual(talk(PROGRAMS, server, client, lane), (served, asked))

    def test_the_first_among_itself(self):
        self.judge("v1", "v1", [f"got {V1_SEES_V1} speed=0.5"], ["put: done", f"moved {V1_SEES_V1}", "mode: On"])

    def test_an_old_client_of_a_new_provider(self):
        self.judge("v2", "v1", [f"got {V2_SEES_V1} speed=0.5 now=0"], ["put: done", f"moved {V1_BACK_FROM_V2}", "mode: On"])

    def test_a_new_client_of_an_old_provider(self):
        self.judge("v1", "v2", [f"got {V1_SEES_V2} speed=0.5"],
                   ["put: done", f"moved {V2_BACK_FROM_V1}", "mode: On", "clear: the provider does not have this command"])

    def test_the_second_among_itself(self):
        self.judge("v2", "v2", [f"got {V2_SEES_V2} speed=0.5 now=1", "cleared"],
                   ["put: done", f"moved {V2_SEES_V2}", "mode: On", "clear: done"])


if __name__ == "__main__":
    run_tests(PROGRAMS)
