"""These tests run read, call, watch and resume."""

import json
import signal
import subprocess
import unittest

from system import PATIENCE, SUTURE, System

GRIPPER = "robot:Hand/Gripper"
POSE = {f"m{row}{column}": float(row == column) for row in range(3) for column in range(3)} | {"x": 1.5, "y": 0.0, "z": -2.0}
GOAL = json.dumps({"goal": {"pose": POSE, "stamp": 7, "valid": True}})


class Use(System):
    def setUp(self):
        super().setUp()
        self.start_manager()
        self.robot = self.start_robot()

    def test_read_prints_a_number_and_its_age(self):
        self.said("call", GRIPPER, "open", "width=0.25")
        self.assertRegex(self.said("read", GRIPPER, "opening"), r"^0\.25, \d+\.\d ms old\n$")
        told = self.told("read", GRIPPER, "opening")
        self.assertEqual((told["command"], told["kind"], told["value"]), ("opening", "read", 0.25))
        self.assertGreaterEqual(told["age_ms"], 0)

    def test_read_prints_values_of_all_types(self):
        value = self.told("read", GRIPPER, "everything")["value"]
        self.assertEqual(value["label"], "hand")
        self.assertEqual(value["bytes"], [1, 2, 255])
        self.assertEqual(value["flags"], [True, False])
        self.assertEqual(value["names"], ["left", "right"])
        self.assertEqual(value["ratio"], 0.1)
        self.assertEqual(value["mode"], "Servo")
        self.assertEqual(value["goal"]["pose"]["x"], 0.5)
        self.assertEqual(value["point"], {"x": 0.0, "y": 2.0, "z": 0.0})

    def test_a_pose_is_shown_as_a_matrix_with_its_unit(self):
        text = self.said("read", GRIPPER, "everything")
        self.assertRegex(text, r"\ngoal\n  pose\n    1\.0  0\.0  0\.0  \| 0\.5\n    0\.0  1\.0  0\.0  \| 0\.0\n")
        self.assertRegex(text, r"\nspeed \[m/s\] +0\.25\n")
        self.assertRegex(text, r"\nnames +\[\"left\", \"right\"\]\n")

    def test_call_runs_commands_of_each_kind(self):
        self.assertEqual(self.said("call", GRIPPER, "enable"), "done\n")
        self.assertEqual(self.told("call", GRIPPER, "enable"), {"command": "enable", "kind": "void"})
        self.assertEqual(self.said("call", GRIPPER, "set_speed", "speed=0.5"), "done\n")
        self.assertEqual(self.said("call", GRIPPER, "next_token"), "1\n")
        self.assertEqual(self.told("call", GRIPPER, "next_token")["value"], 2)
        self.assertEqual(self.said("call", GRIPPER, "grasp", "width=1", "mode=HoldStill"), "true\n")
        self.assertEqual(self.said("call", GRIPPER, "fits", "width=0.2"), "false\n")
        self.assertEqual(self.told("call", GRIPPER, "mode")["value"], "HoldStill")

    def test_resume_lets_commands_go_through_again(self):
        for _ in range(100):  # each request wakes the surgeon, who reads what is too old
            done = self.run_suture("resume", "robot:Surgeon/Gripper")
            if done.returncode == 0:
                break
            self.assertIn("it does not await an operator", done.stderr)
        self.assertEqual(done.stdout, "robot:Surgeon/Gripper: commands go through again\n")

    def test_resume_is_refused_while_the_provider_cannot_run(self):
        for _ in range(100):
            if "does not await" not in self.run_suture("resume", "robot:Surgeon/Gripper").stderr:
                break
        self.said("call", "robot:Hand/component", "suspend")
        for _ in range(100):  # the surgeon, who reads what is too old, hears of both in his own cycle
            error = self.run_suture("resume", "robot:Surgeon/Gripper").stderr
            if "its provider is lost, suspended or faulted" in error:
                break
        self.assertIn("its provider is lost, suspended or faulted", error)

    def test_a_wrong_resume_is_refused(self):
        self.assertIn("it is not connected", self.refused("resume", "robot:Surgeon/Arm"))
        self.assertRegex(self.refused("resume", "robot:Surgeon/Griper"),
                         "requires no such interface; it has required interfaces .*'Gripper'.* Did you mean 'Gripper'\\?$")
        self.assertRegex(self.refused("resume", "robot:Surgeon/component"),
                         "requires no such interface; it has required interfaces .*'Gripper'.* Use one of those names$")
        self.assertIn("is not of the form", self.refused("resume", "robot:Surgeon", status=2))

    def test_arguments_are_given_as_json_and_by_their_paths(self):
        self.said("call", GRIPPER, "servo_cp", "--args", GOAL)
        self.assertEqual(self.told("read", GRIPPER, "measured_cp")["value"]["pose"], POSE)
        self.said("call", GRIPPER, "servo_cp", "--args", GOAL, "goal.pose.x=0.125", "goal.stamp=9")
        value = self.told("read", GRIPPER, "measured_cp")["value"]
        self.assertEqual((value["pose"]["x"], value["pose"]["z"], value["stamp"], value["valid"]), (0.125, -2.0, 9, True))

    def test_what_was_read_can_be_sent(self):
        """This shows that nothing of a type is lost on the way through JSON."""
        value = self.told("read", GRIPPER, "everything")["value"]
        arguments = json.dumps({"x": value["goal"]})
        self.assertEqual(self.told("call", GRIPPER, "inverse_kinematics", "--args", arguments, "tolerance=1")["value"], value)

    def test_wrong_arguments_are_refused(self):
        def error(*arguments):
            return self.refused("call", GRIPPER, *arguments, status=2)

        self.assertEqual(error("open"), "argument 'width': it is not given. Give 'width'; nothing is filled in")
        self.assertIn("argument 'widht': no such name; known are 'width'. Did you mean 'width'?", error("open", "widht=1"))
        self.assertIn("argument 'width': it is \"wide\". Give a number", error("open", "width=wide"))
        self.assertIn("argument 'mode': it is \"Serv\". Give one of 'Disabled', 'HoldStill' and 'Servo'",
                      error("grasp", "width=1", "mode=Serv"))
        self.assertIn("argument 'goal.pose.y': it is not given",
                      error("servo_cp", *(f"goal.pose.{name}={value}" for name, value in POSE.items() if name != "y")))
        self.assertIn("argument 'goal.valid': it is 1. Give true or false", error("servo_cp", "--args", GOAL, "goal.valid=1"))
        self.assertIn("argument 'goal.stamp': it is 0.5. Give a whole number", error("servo_cp", "--args", GOAL, "goal.stamp=0.5"))
        self.assertIn("is not a JSON object", error("open", "--args", "[1]"))
        self.assertIn("it has no name", error("open", "0.5"))

    def test_the_providers_refusal_is_told(self):
        error = self.refused("call", GRIPPER, "inverse_kinematics", "--args", json.dumps({"x": json.loads(GOAL)["goal"]}),
                             "tolerance=2")
        self.assertEqual(error, f"call inverse_kinematics of {GRIPPER}: value outside its declared limits: "
                                f"inverse_kinematics.tolerance; 'tolerance' is 2, and declared as Float64, 0.0 to 1.0. `suture describe {GRIPPER}` tells what it takes and answers")

    def test_a_text_is_taken_as_it_is_typed(self):
        """The shell takes the quotes that a text has in JSON."""
        def answer(text):
            return self.told("call", "robot:Hand/component", "resume_connection", f"required={text}")["value"]

        for text in ("123", "true", "null", "[1]", '"123"', "Gripper"):
            with self.subTest(text=text):
                self.assertEqual(answer(text), "NoSuchInterface")
        error = self.refused("call", "robot:Hand/component", "resume_connection", f"required={'1' * 64}")
        self.assertIn("'required' has 64 bytes", error)
        self.assertIn("'required'", self.refused("call", "robot:Hand/component", "resume_connection", "required.-=1", status=2))
        error = self.refused("call", "robot:Hand/component", "resume_connection", "--args", '{"required": 123}', status=2)
        self.assertIn("argument 'required': it is 123. Give a text, \"like this\"", error)

    def test_what_is_too_large_is_named(self):
        error = self.refused("call", "robot:Hand/component", "resume_connection", f"required={'x' * 64}")
        self.assertIn("; 'required' has 64 bytes, and declared as text of at most 63 bytes. `suture describe", error)

    def test_a_handlers_exception_is_told(self):
        error = self.refused("call", GRIPPER, "grasp", "width=-1", "mode=Servo")
        reason = "the provider's handler threw; component 'Hand' is faulted: the width is negative. Correct the cause"
        self.assertEqual(error, f"call grasp of {GRIPPER}: {reason}, and start process 'robot' anew")
        self.assertIn(reason, self.refused("read", GRIPPER, "opening"))
        self.assertRegex(self.said("read", "robot:Hand/component", "component_state"), "^Faulted, ")

    def test_only_reads_are_read(self):
        error = self.refused("read", GRIPPER, "enable")
        self.assertIn(f"it is a command of kind void. Run it: suture call {GRIPPER} enable", error)

    def watch(self, *words):
        process = subprocess.Popen([SUTURE, "watch", "--manager", self.address, "--json", *words], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def test_watch_prints_a_read(self):
        lines = self.said("watch", GRIPPER, "opening", "--rate", "100", "--count", "3").splitlines()
        self.assertEqual(len(lines), 3)
        for line in lines:
            self.assertRegex(line, r"^ +\d+\.\d{3} s  opening  0\.0$")
        values = [json.loads(line) for line in self.said("watch", GRIPPER, "opening", "--for", "100ms", "--json").splitlines()]
        self.assertGreaterEqual(len(values), 1)
        self.assertEqual({one["value"] for one in values}, {0.0})

    def test_watch_prints_an_event(self):
        self.said("call", GRIPPER, "set_speed", "speed=0.5")  # `moved` is latched: it is there when we come
        watching = self.watch(GRIPPER, "moved", "--count", "2")
        first = json.loads(watching.stdout.readline())
        self.assertEqual((first["event"], first["value"]["value2"], first["value"]["value3"]), ("moved", 0.5, "Servo"))
        self.said("call", GRIPPER, "set_speed", "speed=0.75")
        second = json.loads(watching.stdout.readline())
        self.assertEqual(second["value"]["value2"], 0.75)
        self.assertGreaterEqual(second["elapsed"], first["elapsed"])
        self.assertEqual(watching.wait(PATIENCE), 0)

    def test_watch_prints_all_events_until_a_signal(self):
        for told in (signal.SIGINT, signal.SIGTERM):
            self.said("call", GRIPPER, "set_speed", "speed=0.5")
            watching = self.watch(GRIPPER)
            watching.stdout.readline()  # a latched event came, so watch listens now
            self.said("call", GRIPPER, "enable")
            while (heard := json.loads(watching.stdout.readline()))["event"] != "stopped":
                pass
            self.assertIsNone(heard["value"])
            watching.send_signal(told)
            self.assertEqual(watching.wait(PATIENCE), 0)

    def test_watch_ends_with_the_provider(self):
        self.said("call", GRIPPER, "set_speed", "speed=0.5")
        watching = self.watch(GRIPPER, "moved")
        watching.stdout.readline()
        self.robot.kill()
        output, errors = watching.communicate(timeout=PATIENCE)
        self.assertEqual((watching.returncode, errors), (1, ""))
        self.assertIn("process 'robot' is gone. Start it again.", json.loads(output)["error"])
        self.assertEqual(output.count("\n"), 1, "each line is an object")
        self.robot.returncode = 0  # the test has killed it, so that this is no failure

    def test_watch_ends_when_its_provider_hangs(self):
        self.said("call", GRIPPER, "set_speed", "speed=0.5")
        watching = self.watch(GRIPPER, "moved", "--timeout", "2s")
        watching.stdout.readline()
        self.stop(self.robot)
        try:
            output, errors = watching.communicate(timeout=PATIENCE)
        finally:
            self.robot.send_signal(signal.SIGCONT)
        self.assertEqual((watching.returncode, errors), (1, ""))
        self.assertIn("talk to process 'robot': it is there, but does not answer.", json.loads(output)["error"])

    def test_watch_ends_when_no_one_reads_any_more(self):
        for name in ("opening", "moved"):
            self.said("call", GRIPPER, "set_speed", "speed=0.5")
            watching = self.watch(GRIPPER, name)
            watching.stdout.readline()
            watching.stdout.close()
            self.said("call", GRIPPER, "set_speed", "speed=0.75")
            self.assertEqual((watching.wait(PATIENCE), watching.stderr.read()), (0, ""))

    def test_watch_ends_when_its_reader_goes_and_nothing_happens(self):
        self.said("call", GRIPPER, "set_speed", "speed=0.5")
        watching = self.watch(GRIPPER, "moved")
        watching.stdout.readline()
        watching.stdout.close()
        self.assertEqual((watching.wait(PATIENCE), watching.stderr.read()), (0, ""))

    def test_output_that_is_lost_is_an_error(self):
        self.said("call", GRIPPER, "set_speed", "speed=0.5")
        for words in (("ps",), ("ps", "--json"), ("read", GRIPPER, "opening"), ("watch", GRIPPER, "opening"),
                      ("watch", GRIPPER, "moved"), ("why", "NotYet"), ("read", GRIPPER, "openin", "--json"), ("--help",)):
            with self.subTest(words=words), open("/dev/full", "w", encoding="utf-8") as full:
                address = () if words == ("--help",) else ("--manager", self.address)
                done = subprocess.run([SUTURE, *words, *address], stdout=full, stderr=subprocess.PIPE, text=True, timeout=PATIENCE)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("suture: write to standard output: No space left on device. Make room, or write elsewhere\n",
                              done.stderr)

    def test_output_that_is_closed_is_lost(self):
        for words in ("ps", f"watch {GRIPPER} opening --count 1", "why NotYet", "--help"):
            with self.subTest(words=words):
                address = "" if words == "--help" else f"--manager {self.address}"
                done = subprocess.run(["sh", "-c", f"{SUTURE} {words} {address} >&-"], stderr=subprocess.PIPE, text=True,
                                      timeout=PATIENCE, check=False)
                self.assertEqual(done.returncode, 1)
                self.assertIn("suture: write to standard output: Bad file descriptor. Make room", done.stderr)

    def test_watch_ends_while_an_answer_is_awaited(self):
        stranger = self.start_stranger("deaf")
        for name in ("mode", "stopped"):
            for told in (signal.SIGINT, signal.SIGTERM):
                watching = self.watch("deaf:Odd/Arm", name, "--timeout", "1000s")
                self.assertEqual(stranger.stdout.readline(), "asked\n")
                watching.send_signal(told)
                self.assertEqual(watching.wait(PATIENCE), 0)
        for name in ("mode", "stopped"):
            self.assertEqual(self.said("watch", "deaf:Odd/Arm", name, "--timeout", "1000s", "--for", "50ms"), "")


unittest.main()
