"""What suturec calls fine is fine between two processes, whichever provides; and what it calls a break is refused there.

  wire_test.py --manager SUTURE_MANAGER --v1 PROGRAM --v2 PROGRAM
"""

import pathlib
import sys
import unittest

from breaking import BREAKING
from compatible import COMPATIBLE

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from processes import run_tests, talk  # noqa: E402

PROGRAMS = {}


def members(path, side_of):
    """Returns the lines of what came by one path to the peer whose side of an edit is side_of(edit)."""
    return [f"{path} {edit.stem}.{name} {value}" for edit in COMPATIBLE for name, value in side_of(edit).sees.items()]


class Conversation(unittest.TestCase):
    """The client is of one version, the provider of the other; they talk by one lane."""

    maxDiff = None
    server, client, lane = "", "", ""

    @classmethod
    def setUpClass(cls):
        if not cls.server:
            raise unittest.SkipTest("only those that derive from it say who talks")
        cls.served, cls.asked = talk(PROGRAMS, cls.server, cls.client, cls.lane)

    @classmethod
    def of_client(cls, edit):
        return edit.old if cls.client == "v1" else edit.new

    @classmethod
    def of_server(cls, edit):
        return edit.new if cls.client == "v1" else edit.old

    def each(self, edits, judge):
        for edit in edits:
            with self.subTest(edit.name):
                judge(edit)

    def test_members_arrive_by_command(self):
        got = [line for line in self.served if line.startswith("argument ")]
        self.assertEqual(got, members("argument", self.of_server))

    def test_members_arrive_by_event_answer_and_row(self):
        for path in ("event", "answer", "row"):
            got = [line for line in self.asked if line.startswith(f"{path} ") and "." in line.split()[1]]
            self.assertEqual(got, members(path, self.of_client))

    def test_commands_are_answered_as_the_table_says(self):
        expected = [f"{command.name}: {call.answer}" for edit in COMPATIBLE for command in self.of_client(edit).commands
                    for call in command.calls]
        begin = self.asked.index("put: done") + 1
        self.assertEqual([line for line in self.asked[begin:] if ": " in line], expected)

    def test_commands_are_heard_as_the_table_says(self):
        self.each(COMPATIBLE, self.judge_heard)

    def judge_heard(self, edit):
        theirs = {command.name for command in self.of_server(edit).commands}
        heard = [line.split(" ", 2)[2] for line in self.served if line.startswith("heard ") and line.split()[1] in theirs]
        calls = [call for command in self.of_client(edit).commands for call in command.calls]
        floods = [f"a={call.flood}" for call in calls if call.flood]
        self.assertEqual([one for one in heard if one not in floods], [call.heard for call in calls if call.heard is not None])

    def test_events_are_heard_as_the_table_says(self):
        for edit in COMPATIBLE:
            for event in self.of_client(edit).events:
                with self.subTest(edit.name):
                    got = [line for line in self.asked if line.startswith(f"event {event.name} ")]
                    self.assertEqual(got, [] if event.heard is None else [f"event {event.name} {event.heard}"])

    def test_a_base_that_grew_is_read_and_heard_as_before(self):
        self.assertEqual([line for line in self.asked if line.startswith(("latched ", "row depth "))],
                         ["latched 3", "row depth 4"])

    def test_breaking_edits_do_not_connect(self):
        self.each(BREAKING, self.judge_refusal)

    def judge_refusal(self, edit):
        said = [line for line in self.asked if line.startswith(f"{edit.title}: ")]
        new, old = edit.refusal
        (required, major), (provided, other) = ((new, 2), (old, 1)) if self.client == "v2" else ((old, 1), (new, 2))
        self.assertIn(f"major {major} required, {other} provided", said[0])
        self.assertIn(f"{required} required", said[0])
        self.assertIn(f"{provided} provided", said[0])


class ANewProviderOfAnOldClientByFrames(Conversation):
    server, client, lane = "v2", "v1", "frame"


class AnOldProviderOfANewClientByFrames(Conversation):
    server, client, lane = "v1", "v2", "frame"


class ANewProviderOfAnOldClientByCalls(Conversation):
    server, client, lane = "v2", "v1", "rpc"


class AnOldProviderOfANewClientByCalls(Conversation):
    server, client, lane = "v1", "v2", "rpc"


if __name__ == "__main__":
    run_tests(PROGRAMS)
