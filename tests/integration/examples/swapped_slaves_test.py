"""examples/07_swapped_slaves: the deployment file alone decides which slave the left master drives."""

import unittest

from example import SCALE, Example

EXAMPLE = "07_swapped_slaves"


class SwappedSlaves(Example):
    def stations_of(self, file):
        self.start_manager()
        return [self.station(EXAMPLE, file, "--process", name, program="06_one_arm") for name in ("left", "right")]

    def test_straight(self):
        left, right = self.stations_of("straight.json")
        master, slave = self.await_motion(left.stdout, "Left")
        self.assertAlmostEqual(slave / master, SCALE, delta=0.1 * SCALE)
        self.await_line(right.stdout, r"^Right: master moved by +0\.0 mm, slave by +0\.0 mm$")
        self.end(left)
        self.end(right)

    def test_swapped(self):
        left, right = self.stations_of("swapped.json")
        master, slave = self.await_motion(left.stdout, "Left")
        self.assertGreater(master, 30)
        self.assertEqual(slave, 0)
        master, slave = self.await_motion(right.stdout, "Right")
        self.assertEqual(master, 0)
        self.assertGreater(slave, 30 * SCALE)
        left.kill()
        self.await_line(right.stdout, "^Right: the arms are being prepared$")


unittest.main()
