"""examples/06_one_arm: the slave moves by the scale of its teleoperation."""

import unittest

from example import SCALE, Example

EXAMPLE = "06_one_arm"


class OneArm(Example):
    def test_slave_moves_by_a_scale_of_what_its_master_does(self):
        station = self.station(EXAMPLE, "deployment.json")
        for _ in range(3):
            master, slave = self.await_motion(station.stdout, "Display")
            self.assertAlmostEqual(slave / master, SCALE, delta=0.1 * SCALE)
        self.end(station)


unittest.main()
