"""A process listens at the port that its deployment file gives it, and again after a restart."""

import os
import pathlib
import random
import signal
import socket
import unittest

from stations import Stations, component

ESTABLISHED, LISTENS = "01", "0A"


def free_ports(count):
    """Returns ports that nothing has, below those that the kernel takes for connections."""
    lowest = int(pathlib.Path("/proc/sys/net/ipv4/ip_local_port_range").read_text().split()[0])
    found = []
    while len(found) < count:
        port = random.randrange(10000, lowest) if lowest > 10000 else random.randrange(2000, 65000)
        with socket.socket() as probe:
            try:
                probe.bind(("127.0.0.1", port))
            except OSError:
                continue
        if port not in found:
            found.append(port)
    return found


def sockets_at(state):
    """Returns the local port and the inode of each TCP socket in that state."""
    rows = [line.split() for line in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]]
    return [(int(row[1].split(":")[1], 16), row[9]) for row in rows if row[3] == state]


def listening(process):
    """Returns the ports at which this process listens."""
    folder = pathlib.Path(f"/proc/{process.pid}/fd")
    sockets = set()
    for descriptor in folder.iterdir():
        try:
            sockets.add(os.readlink(descriptor))
        except FileNotFoundError:  # it has closed that
            continue
    return {port for port, inode in sockets_at(LISTENS) if f"socket:[{inode}]" in sockets}


class Ports(Stations):
    def setUp(self):
        super().setUp()
        manager, self.here, self.there = free_ports(3)
        self.address = f"tcp://127.0.0.1:{manager}"
        self.manager(self.address)
        self.deployment = {
            "manager": self.address,
            "processes": [{"name": "here", "port": self.here, "components": [component("Hand", "Hand")]},
                          {"name": "there", "port": self.there, "components": [component("Platter", "Platter", angle=0)]}],
            "connections": [{"from": "here:Hand/Turntable", "to": "there:Platter/Turntable"}]}

    def started(self, name, shown):
        station = self.workstation(self.deployment, "--process", name)
        self.await_line(station, f"runs '{shown}'\n")
        return station

    def test_each_listens_at_its_port_and_has_it_again_at_once(self):
        platter = self.started("there", "Platter")
        hand = self.started("here", "Hand")
        self.assertEqual(listening(hand), {self.here})
        for end in (signal.SIGTERM, signal.SIGKILL, signal.SIGTERM):
            self.assertEqual(listening(platter), {self.there})
            self.await_true(lambda: self.there in [port for port, _ in sockets_at(ESTABLISHED)])
            platter.send_signal(end)  # its ends of connections close first, so the kernel keeps them for a minute
            platter.communicate(timeout=60)
            platter = self.started("there", "Platter")
        self.assertEqual(listening(platter), {self.there})

    def test_a_port_that_is_taken_is_told_with_who_wants_it(self):
        self.started("there", "Platter")
        self.deployment["processes"][0]["port"] = self.there
        self.deployment["manager"] = self.address.replace("127.0.0.1", "localhost")
        problems = self.workstation(self.deployment, "--process", "here").communicate(timeout=60)[1]
        self.assertIn(f"give process 'there' port {self.there}: process 'here' has that port", problems)
        del self.deployment["processes"][1]["port"]
        station = self.workstation(self.deployment, "--process", "here")
        problems = station.communicate(timeout=60)[1]
        self.assertEqual(station.returncode, 1)
        self.assertIn(f"give process 'here' port {self.there}: listen at tcp://127.0.0.1:{self.there}: "
                      "another process listens there. Stop it, or choose another address", problems)


if __name__ == "__main__":
    unittest.main()
