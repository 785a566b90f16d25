"""examples/01_counter counts in one process, and across two."""

import re
import unittest

from example import Example


class Counter(Example):
    def counts(self, *arguments):
        """Runs the client to its end and looks at what it has counted."""
        output = self.output_of(self.start("01_counter", *arguments))
        values = [int(value) for value in re.findall(r"^(\d+), [\d.]+ ms old$", output, re.M)]
        self.assertGreater(len(values), 5, output)
        self.assertEqual(values, sorted(values))
        self.assertGreater(values[-1], values[0])
        self.assertRegex(output, r"(?m)^passed \d+$")

    def test_one_process(self):
        self.counts()

    def test_two_processes(self):
        self.start_manager()
        self.start("01_counter", "provider")
        self.counts("client")

    def test_without_a_manager_the_client_says_what_to_start(self):
        refusal = self.refusal_of(self.start("01_counter", "client"))
        self.assertIn("suture-manager", refusal)
        self.assertRegex(refusal, '(?m)^`suture why "reach the global manager: .*"` tells more$')


unittest.main()
