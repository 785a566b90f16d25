"""These tests run ps, describe, doctor and why."""

import os
import pathlib
import re
import signal
import subprocess
import unittest

from system import PATIENCE, SUTURE, System

GRIPPER = "robot:Hand/Gripper"


class Inspect(System):
    def setUp(self):
        super().setUp()
        self.start_manager()

    def test_the_version_is_the_project_s(self):
        project = (pathlib.Path(__file__).resolve().parents[3] / "CMakeLists.txt").read_text(encoding="utf-8")
        version = re.search(r"project\(Suture VERSION ([\d.]+)", project)[1]
        done = subprocess.run([SUTURE, "--version"], capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, f"suture {version}\n", ""))

    def test_ps_says_that_no_process_is_known(self):
        self.assertEqual(self.said("ps"), f"No process is known to {self.address}.\n")
        self.assertEqual(self.told("ps"), [])

    def test_ps_shows_processes_and_their_interfaces(self):
        robot = self.start_robot()
        text = self.said("ps")
        self.assertIn(f"robot   pid {robot.pid}   host {os.uname().nodename}   unix:/", text)
        self.assertIn("  Hand\n    provides  Gripper    robots::Gripper    fingers in wrist\n    provides  component  suture::Lifecycle\n", text)
        self.assertRegex(text, r"requires  Names +robots::Names +not connected\n")
        (process,) = self.told("ps")
        self.assertEqual((process["name"], process["pid"]), ("robot", robot.pid))
        hand, surgeon = process["components"]
        self.assertEqual([one["name"] for one in hand["provided"]], ["Gripper", "component"])
        self.assertEqual([one["contract"] for one in surgeon["required"]],
                         ["robots::Arm", "robots::Gripper", "robots::Names", "robots::Arm"])

    def test_what_is_connected_is_told(self):
        self.start_robot()
        line = r"requires +Gripper +robots::Gripper +-> robot:Hand/Gripper +local +connected for \d+\.\d s(, awaits its operator)?\n"
        for words in (("ps",), ("describe", "robot"), ("describe", "robot:Surgeon")):
            with self.subTest(words=words):
                text = self.said(*words)
                self.assertRegex(text, line)
                self.assertRegex(text, r"requires +Names +robots::Names +not connected\n")
        for told in (self.told("ps")[0], self.told("describe", "robot")):
            required = {one["name"]: one["connection"] for one in told["components"][1]["required"]}
            self.assertEqual({name: required[name] for name in ("Arm", "Names", "FarArm")}, {"Arm": None, "Names": None, "FarArm": None})
            connection = required["Gripper"]
            self.assertEqual((connection["provided"], connection["lane"], connection["status"]), ("robot:Hand/Gripper", "local", "connected"))
            self.assertGreaterEqual(connection["seconds"], 0)

    def test_a_suspended_provider_is_told(self):
        self.start_robot()
        self.said("call", "robot:Hand/component", "suspend")
        for _ in range(1000):  # the hand suspends in its own cycle
            if "suspended for" in (text := self.said("ps")):
                break
        self.assertRegex(text, r"-> robot:Hand/Gripper +local +suspended for ")

    def test_connections_that_a_process_does_not_tell(self):
        """It is of a build that knows nothing of them."""
        self.start_stranger("older")
        self.assertIn("  its connections are not known: its Suture is older than that question\n", self.said("ps"))
        self.assertIn("older than that question", self.told("ps")[0]["connections_unknown"])
        self.assertNotIn("connected", self.said("describe", "older"))

    def test_ps_tells_which_process_is_silent(self):
        robot = self.start_robot()
        self.assertNotIn("silent", self.said("ps"))
        self.stop(robot)
        try:
            self.await_silence("robot")
            self.assertIn(".sock   silent\n", self.said("ps"))
        finally:
            robot.send_signal(signal.SIGCONT)

    def test_the_first_manager_that_answers_is_asked(self):
        self.start_robot()
        living = self.address
        self.address = f"{living}.none,{living}"
        self.assertIn("robot   pid", self.said("ps"))
        self.assertIn(f"{living}, processes known: 1", self.said("doctor"))
        self.address = f"{living}.none,{living}.neither"
        self.assertIn(f"suture-manager --listen {living}.none", self.refused("ps"))

    def test_describe_shows_a_process_and_a_component(self):
        self.start_robot()
        self.assertIn("  Hand\n", self.said("describe", "robot"))
        self.assertIn("  Surgeon\n", self.said("describe", "robot"))
        self.assertNotIn("  Hand\n", self.said("describe", "robot:Surgeon"))
        names = [one["name"] for one in self.told("describe", "robot")["components"]]
        self.assertEqual(names, ["Hand", "Surgeon"])

    def test_describe_says_how_the_clocks_stand(self):
        self.start_robot()
        self.assertNotIn("clock", self.said("describe", "robot"))
        self.assertEqual(self.told("describe", "robot")["clock"], {"same": True, "offset_ms": 0, "error_ms": 0})
        self.assertEqual(self.told("read", GRIPPER, "opening")["age_error_ms"], 0)

    def test_describe_says_how_another_clock_stands(self):
        if os.geteuid() != 0:
            self.skipTest("only root may give a process another clock")
        for ahead in (5000, -60):
            with self.subTest(ahead=ahead):
                name = f"skewed{ahead}"
                self.start_robot_ahead(ahead, name)
                which = "ahead of" if ahead > 0 else "behind"
                self.assertRegex(self.said("describe", name), rf"^{name}\n  clock  [\d.]+ s {which} ours, known to \d+ us\n  Hand\n")
                clock = self.told("describe", name)["clock"]
                self.assertEqual((clock["same"], clock["error_ms"] > 0), (False, True))
                self.assertLessEqual(abs(clock["offset_ms"] - ahead * 1000), clock["error_ms"] + 1e-3)
                self.assertRegex(self.said("read", f"{name}:Hand/Gripper", "opening"), r" ms old, known to \d+ us\n$")
                told = self.told("read", f"{name}:Hand/Gripper", "opening")
                self.assertGreaterEqual(told["age_ms"], -told["age_error_ms"])
                self.assertLess(told["age_ms"], 60_000)

    def test_describe_shows_an_interface(self):
        self.start_robot()
        text = self.said("describe", GRIPPER)
        for line in ("robot:Hand/Gripper, provided: robots::Gripper",
                     "    An arm with a gripper.",
                     "    open(width: Float64 [m])   write, queue 16",
                     "    servo_cp(goal: robots::PoseStamped)   write, newest wins, ttl 20.0 ms, from robots::Arm",
                     "        Follow the goal.",
                     "    grasp(width: Float64, mode: robots::Mode) -> Bool   write with return, deadline 50.0 ms, queue 2,"
                     " from robots::Arm",
                     "    measured_cp() -> robots::PoseStamped   read, from robots::Arm",
                     "    mode_changed(robots::Mode)   write, latched, queue 8, from robots::Arm",
                     "    enum robots::Mode",
                     "        Disabled, HoldStill, Servo"):
            self.assertIn(line + "\n", text)
        self.assertRegex(text, r"\n        speed +Float64 \[m/s\], -0.5 to 2\.?0? +Along the path\.\n")
        told = self.told("describe", GRIPPER)
        self.assertEqual((told["interface"], told["side"]), (GRIPPER, "provided"))
        self.assertEqual(told["description"]["name"], "robots::Gripper")
        self.assertEqual(self.told("describe", "robot:Surgeon/Names")["side"], "required")

    def test_the_doctor_finds_all_well(self):
        self.start_robot()
        for words in ((), ("robot",), ("robot:Hand",), (GRIPPER,), ("robot:Surgeon/Names", GRIPPER)):
            told = self.told("doctor", *words)
            self.assertTrue(told["good"])
            manager, *others = told["examinations"]
            self.assertEqual([step["step"] for step in manager["steps"]], ["manager"])
            self.assertEqual(len(others), max(1, len(words)))
            for one in others:
                self.assertEqual([(step["step"], step["state"]) for step in one["steps"]],
                                 [("resolve", "ok"), ("connect", "ok"), ("tls", "skipped"), ("version", "ok"),
                                  ("schema", "ok")])
        text = self.said("doctor", GRIPPER)
        self.assertIn("  tls      skipped  not needed: a Unix socket does not leave this machine\n", text)
        self.assertIn("  schema   ok       robots::Gripper: 14 commands, 5 events\n", text)

    def test_why_says_that_two_connect(self):
        self.start_robot()
        self.start_robot("other")
        for provider in ("robot", "other"):  # in the same process, and in another
            with self.subTest(provider=provider):
                self.assertIn(f"robot:Surgeon/Gripper -> {provider}:Hand/Gripper: they connect\n",
                              self.said("why", "robot:Surgeon/Gripper", f"{provider}:Hand/Gripper"))
                # They connect in either order: an arm is wanted, and this gripper is one.
                told = self.told("why", f"{provider}:Hand/Gripper", "robot:Surgeon/Arm")
                self.assertEqual((told["connects"], told["requires"], told["offers"], told["missing_commands"]),
                                 (True, "robots::Arm", "robots::Gripper", []))

    def test_frames_are_told_and_compared(self):
        self.start_robot()
        self.assertRegex(self.said("describe", "robot"), r"provides +Gripper +robots::Gripper +fingers in wrist\n")
        self.assertRegex(self.said("describe", "robot"), r"requires +FarArm +robots::Arm +in camera +not connected\n")
        hand = self.told("describe", "robot:Hand")["components"][0]["provided"][0]
        self.assertEqual((hand["reference_frame"], hand["moving_frame"]), ("wrist", "fingers"))
        done = self.run_suture("why", "robot:Surgeon/FarArm", GRIPPER)
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("they do not connect\n", done.stdout)
        self.assertIn("\n    it expects reference frame 'camera' and is offered 'wrist'\n", done.stdout)
        self.assertIn("Connect interfaces of the same frames, or correct what is declared of them.\n", done.stdout)

    def test_why_says_why_two_do_not_connect(self):
        self.start_robot()
        done = self.run_suture("why", "robot:Surgeon/Names", GRIPPER)
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertTrue(done.stdout.endswith("they do not connect\n  requires robots::Names, is offered robots::Gripper\n"
                                             "Connect interfaces of the same contract.\n"), done.stdout)

    def test_why_compares_field_by_field(self):
        self.start_robot()
        self.start_stranger("changed")
        done = self.run_suture("why", "robot:Surgeon/Arm", "changed:Odd/Arm")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("\n  both are called robots::Arm, and differ\n", done.stdout)
        self.assertRegex(done.stdout, r"""\n    'speed' of 'setSpeed' of interface Arm: Float64 unit "m/s" required, Float32 unit "m/s" provided\n""")
        self.assertIn("Build both sides from the same header.\n", done.stdout)

    def test_why_explains_an_error(self):
        done = self.run_without_manager("why", "NotYet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith("# not produced yet: `Errc::NotYet`\n"), done.stdout)
        self.assertIn("'not-yet'", self.refused("why", "NotJet", status=2))

    def test_why_needs_two_sides(self):
        self.start_robot()
        self.assertIn("each of them requires its contract", self.refused("why", "robot:Surgeon/Arm", "robot:Surgeon/Names"))


unittest.main()
