"""examples/03_own_data_type: what stands in the deployment file of one process is printed by the other."""

import unittest

from example import Example

EXAMPLE = "03_own_data_type"


class OwnDataType(Example):
    def station_of(self, process):
        return self.station(EXAMPLE, "deployment.json", "--process", process)

    def test_every_member_arrives(self):
        self.start_manager()
        theatre, console = self.station_of("theatre"), self.station_of("console")
        turn = r"^  tip at 0\.100 0\.020 0\.300 m, turned by (\d\.\d\d) rad$"
        lines = ("^needle driver, partly visible$", turn, r"^  jaws open by 0\.50 rad$",
                 r"^  marker 4 at 0\.090 0\.020 0\.250 m$", r"^  marker 7 at 0\.110 0\.020 0\.250 m$")
        first = [self.await_line(console.stdout, line) for line in lines]
        later = self.await_line(console.stdout, turn)
        self.assertGreater(float(later[1]), float(first[1][1]))
        self.end(console)
        self.end(theatre)


unittest.main()
