"""examples/05_events: a client that is there from the start hears all, one that comes late hears the state."""

import re
import unittest

from example import Example


class Events(Example):
    def test_each_listener_hears_what_it_is_told_it_would(self):
        output = self.output_of(self.start("05_events"))

        def heard(name):
            return re.findall(f"(?m)^{name} hears: (.*)$", output)

        self.assertEqual(heard("early"), [
            "the jaws are open", "the jaws are closing", "touched with 0.5 N", "touched with 1.0 N",
            "touched with 1.5 N", "the jaws are holding", "the jaws are open"])
        self.assertEqual(heard("late"), ["the jaws are holding", "the jaws are open"])
        self.assertRegex(output, r"(?m)^the first touch has come, 0\.5 N$")
        self.assertRegex(output, r"(?m)^the answer is: it held something$")


unittest.main()
