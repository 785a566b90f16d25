"""examples/04_contract_and_loss: the client is told how its provider does, and holds still until it is back."""

import json
import signal
import unittest

from example import Example

EXAMPLE = "04_contract_and_loss"
POSITION = r"(-?\d+\.\d+) rad"


class ContractAndLoss(Example):
    def station_of(self, process):
        return self.station(EXAMPLE, "deployment.json", "--process", process)

    def setUp(self):
        super().setUp()
        self.start_manager()
        self.console, self.robot = self.station_of("console"), self.station_of("robot")
        self.await_line(self.robot.stdout, f"^fresh: follows from {POSITION}$")

    def test_too_old_values_are_told_until_fresh_ones_come(self):
        self.console.send_signal(signal.SIGSTOP)
        self.await_line(self.robot.stdout, f"^older than the connection's max_age: holds at {POSITION}$")
        self.console.send_signal(signal.SIGCONT)
        # It says "back" if it stood still for so long that it was lost, too.
        self.await_line(self.robot.stdout, f"^(fresh|back): follows from {POSITION}$")

    def test_holds_still_while_the_provider_is_lost(self):
        self.console.kill()
        held = self.await_line(self.robot.stdout, f"^connection lost: holds at {POSITION}$")
        self.await_line(self.robot.stderr, "is lost, closed: ")
        self.station_of("console")
        back = self.await_line(self.robot.stdout, f"^back: follows from {POSITION}$")
        self.assertGreater(float(held[1]), 0)
        self.assertEqual(held[1], back[1])
        self.await_line(self.robot.stderr, "is there again")
        self.end(self.robot)  # a loss that is over is no failure

    def test_why_a_lost_provider_cannot_be_connected_to_anew_is_told(self):
        self.console.kill()
        self.await_line(self.robot.stderr, "is lost, closed: ")
        changed = json.loads((self.folder / "deployment.json").read_text())
        changed["connections"] = []
        changed["processes"] = changed["processes"][:1]
        changed["processes"][0]["components"][0]["name"] = "Gamepad"
        file = self.folder / "changed.json"
        file.write_text(json.dumps(changed))
        console = self.start(EXAMPLE, "--deployment", file, "--process", "console")
        self.await_line(self.robot.stderr, "^robot: connection 'robot:Axis/Joystick -> console:Joystick/Joystick' "
                                           "cannot be made anew: .*'Gamepad'")
        console.kill()
        self.station_of("console")
        self.await_line(self.robot.stderr, "is there again")


unittest.main()
