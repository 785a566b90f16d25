"""Runs processes of more components than the usual limit of descriptors lets them have, or without standard descriptors."""

import os
import resource
import unittest

from stations import MANAGER, Stations, component


class Descriptors(Stations):
    def test_the_hard_limit_is_used(self):
        components = [component(f"Spindle{i}", "Spindle", cycles=1_000_000) for i in range(100)]
        hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
        station = self.workstation({"processes": [{"name": "all", "components": components}]}, "--seconds", "0.2",
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (64, hard)))
        problems = station.communicate(timeout=60)[1]
        self.assertEqual(station.returncode, 0, problems)

    def test_a_manager_uses_its_hard_limit(self):
        """Each process of a system takes a descriptor of its manager."""
        hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
        manager = self.start(MANAGER, "--listen", f"unix:{self.folder}/manager.sock",
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (64, hard)))
        self.assertIn("ready on", manager.stdout.readline())
        self.assertEqual(resource.prlimit(manager.pid, resource.RLIMIT_NOFILE), (hard, hard))

    def test_a_standard_descriptor_that_is_closed_becomes_no_socket(self):
        """What the process says of a refusal would go into a peer's stream."""
        def close():
            os.close(0)
            os.close(2)

        address = f"unix:{self.folder}/manager.sock"
        manager = self.start(MANAGER, "--listen", address, preexec_fn=close)
        self.assertIn("ready on", manager.stdout.readline())
        station = self.workstation({"manager": address, "processes": [{"name": "drives", "components": []}]}, preexec_fn=close)
        self.await_true(lambda: any(self.folder.glob("drives.*.sock")))
        for process in (manager, station):
            for descriptor in (0, 2):
                self.assertEqual(os.readlink(f"/proc/{process.pid}/fd/{descriptor}"), "/dev/null")


if __name__ == "__main__":
    unittest.main()
