"""examples/08_bimanual_knot: with fixtures the knot comes to its target, without them it does not stay there."""

import json
import unittest

from example import EXAMPLES, Example

EXAMPLE = "08_bimanual_knot"
SEEN = r"^both hands are guided: the knot is ([\d.]+) mm from its target, ([\d.]+) mm beside its line$"


class BimanualKnot(Example):
    def distance(self, station):
        return float(self.await_line(station.stdout, SEEN)[1])

    def test_fixtures_bring_it_to_its_target(self):
        station = self.station(EXAMPLE, "deployment.json")
        first = self.distance(station)
        self.assertGreater(first, 5)
        while self.distance(station) > 1.5:
            pass
        self.end(station)

    def test_without_fixtures_it_goes_where_the_hands_go(self):
        deployment = json.loads((EXAMPLES / EXAMPLE / "deployment.json").read_text())
        guide = next(one for one in deployment["processes"][0]["components"] if one["name"] == "Guide")
        guide["parameters"]["fixtures"] = False
        file = self.folder / "free.json"
        file.write_text(json.dumps(deployment))
        station = self.start(EXAMPLE, "--deployment", file)
        nearest = self.distance(station)
        while (now := self.distance(station)) <= nearest + 2:  # it comes nearer, and goes past
            nearest = min(nearest, now)
        self.end(station)


unittest.main()
