"""Checks the deployments that are shipped: each connection that carries places or poses has its coordinate frames declared at
both ends, so that one which is wired to the wrong provider is refused and does not move.

  frames_test.py ROOT      checks the deployments of that tree, and that it finds what is planted in one of them
"""

import json
import pathlib
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()

# The values of these contracts are of more than one frame and name those themselves.
OF_SEVERAL_FRAMES = {"robots::Registration", "robots::Teleoperation"}


class Contracts:
    """Knows what `suturec` has written of the tree's types, contracts and component classes."""

    def __init__(self, root):
        self.structs, self.components, self.frames = {}, {}, {}
        headers = [json.loads(path.read_text()) for path in (root / "generated").rglob("*.suture.json")]
        for header in headers:
            self.structs.update({one["name"]: one for one in header["structs"]})
            self.components.update({one["name"].rsplit("::", 1)[-1]: one for one in header["components"]})
        for header in headers:
            self.frames.update({one["name"]: self.frames_of(one) for one in header["interfaces"]})

    def frames_of(self, contract):
        """Returns which frames a reader of its values has to know: a place has a reference, a pose a moving frame too."""
        found = set()
        for one in contract["commands"] + contract["events"]:
            for value in [one.get("result"), one.get("payload"), *one.get("parameters", [])]:
                if value:
                    self.look(value["type"], value.get("unit"), found)
        return found if contract["name"] not in OF_SEVERAL_FRAMES else set()

    def look(self, kind, unit, found):
        if kind["kind"] == "isometry":
            found |= {"reference", "moving"}
        elif kind["kind"] == "matrix" and kind["rows"] == 3 and unit == "m":
            found |= {"reference"}
        elif kind["kind"] == "struct" and kind["name"] in self.structs:
            for field in self.structs[kind["name"]]["fields"]:
                self.look(field["type"], field.get("unit"), found)

    def of(self, component, interface):
        """Returns the frames of an interface. One that is a member of a part of the class is not known, and the other end has its frames."""
        known = self.components[component["class"]]
        sides = known.get("required", []) + known.get("provided", [])
        return next((self.frames[one["interface"]] for one in sides if one["name"] == interface), set())


def undeclared(deployment, contracts):
    """Returns each end of a connection that does not declare a frame of what the connection carries."""
    components = {f"{process['name']}:{one['name']}": one for process in deployment["processes"]
                  for one in process["components"]}
    problems = []
    for connection in deployment["connections"]:
        ends = [(end, components[end.split("/")[0]], end.split("/")[1]) for end in (connection["from"], connection["to"])]
        carried = set().union(*(contracts.of(component, interface) for _, component, interface in ends))
        for end, component, interface in ends:
            lacking = carried - set(component.get("frames", {}).get(interface, {}))
            problems += [f"{end} declares no {frame} frame" for frame in sorted(lacking)]
    return sorted(set(problems))


class Frames(unittest.TestCase):
    def setUp(self):
        self.contracts = Contracts(ROOT)

    def test_both_ends_of_each_connection_declare_them(self):
        files = [path for path in (ROOT / "examples").rglob("*.json") if "connections" in json.loads(path.read_text())]
        self.assertGreaterEqual(len(files), 12)
        for path in files:
            with self.subTest(path.relative_to(ROOT)):
                self.assertEqual(undeclared(json.loads(path.read_text()), self.contracts), [])

    def test_an_end_that_declares_none_is_found(self):
        deployment = json.loads((ROOT / "examples/teleoperation/fig3b.json").read_text())
        for process in deployment["processes"]:
            for component in process["components"]:
                if component["name"] == "Guide":
                    del component["frames"]["LeftMaster"], component["frames"]["Vision"]
        self.assertEqual(undeclared(deployment, self.contracts),
                         ["left:Guide/LeftMaster declares no moving frame", "left:Guide/LeftMaster declares no reference frame",
                          "left:Guide/Vision declares no reference frame"])


unittest.main()
