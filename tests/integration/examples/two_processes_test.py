"""examples/02_two_processes: one program counts in one process or in two, by its deployment file alone."""

import unittest

from example import Example

EXAMPLE = "02_two_processes"


class TwoProcesses(Example):
    def counts(self, station):
        first = self.await_line(station.stdout, r"^(\d+), [\d.]+ ms old$")
        self.await_line(station.stdout, r"^passed \d+$")
        last = self.await_line(station.stdout, r"^(\d+), [\d.]+ ms old$")
        self.assertGreater(int(last[1]), int(first[1]))
        self.end(station)

    def test_one_process(self):
        self.counts(self.station(EXAMPLE, "one_process.json"))

    def test_two_processes(self):
        self.start_manager()
        provider = self.station(EXAMPLE, "two_processes.json", "--process", "provider")
        self.counts(self.station(EXAMPLE, "two_processes.json", "--process", "client"))
        self.end(provider)

    def test_ends_by_itself_when_its_time_is_over(self):
        self.output_of(self.station(EXAMPLE, "one_process.json", "--seconds", "0.1"))

    def test_one_of_several_processes_must_be_named(self):
        errors = self.refusal_of(self.station(EXAMPLE, "two_processes.json"))
        self.assertIn("'provider' and 'client'; say which one with --process", errors)


unittest.main()
