"""Runs the demo for three seconds on one topology and lane, and checks what it says."""

import pathlib
import sys

from programs import Demo

PROCESSES = {"single": 1, "fig3a": 2, "fig3c": 2}
SLAVES = {
    "single": {"console:PSM2": "console:MTML", "console:PSM1": "console:MTMR"},
    "fig3a": {"left:PSM2": "left:MTML", "right:PSM1": "right:MTMR"},
    "fig3c": {"right:PSM1": "left:MTML", "left:PSM2": "right:MTMR"},
}


def expected_lane(connection, lane):
    source, target = connection["name"].split(" -> ")
    if lane != "auto":
        return lane
    return "local" if source.split(":")[0] == target.split(":")[0] else "shm"


def check(result, topology, lane):
    assert result["passed"], result["checks"]
    assert len(result["processes"]) == PROCESSES[topology]
    assert len(result["connections"]) == 12
    for connection in result["connections"]:
        wanted = expected_lane(connection, lane)
        assert connection["lane"] == wanted, connection
        assert connection["end"] == "both", connection
        on_wire = connection["bytes_sent"] + connection["bytes_received"]
        assert (on_wire > 0) == (wanted != "local"), connection
    slaves = {arm["name"]: arm for arm in result["arms"] if "follows" in arm}
    assert {name: arm["follows"] for name, arm in slaves.items()} == SLAVES[topology]
    for arm in slaves.values():
        assert arm["travel"] >= 0.03, arm
        assert arm["position_error"]["p99"] <= 0.001, arm
        assert arm["orientation_error"]["p99"] <= 0.0174533, arm


def main():
    programs, topology, lane = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    with Demo(programs, "--topology", topology, "--lane", lane, "--seconds", "3") as demo:
        status, output = demo.finish()
        print(output)
        assert status == 0, f"exit status {status}"
        check(demo.result(), topology, lane)
        assert "\x1b" not in output, "colours in a pipe"
        assert demo.leftovers() == [], demo.leftovers()


main()
