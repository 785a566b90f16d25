"""These tests say what is said when something is not there, or is not what it should be."""

import json
import os
import resource
import signal
import socket
import subprocess
import unittest

from system import MANAGER, PATIENCE, SUTURE, System

GRIPPER = "robot:Hand/Gripper"
ROTATION = {f"m{row}{column}": 0 for row in range(3) for column in range(3)}
GOAL = json.dumps({"goal": {"pose": {**ROTATION, "x": 0, "y": 0, "z": 0}, "stamp": 7, "valid": True}})


class Fail(System):
    def examined(self, *targets):
        """Returns the doctor's steps on the way to the last target, and what it says to people."""
        done = self.run_suture("doctor", *targets, "--timeout", "2s", "--json")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        told = json.loads(done.stdout)
        self.assertFalse(told["good"])
        return told["examinations"][-1]["steps"]

    def failed(self, name, *targets):
        """The step that failed is this one; those behind it have not been tried."""
        steps = self.examined(*targets)
        states = [step["state"] for step in steps]
        (failed,) = [step for step in steps if step["state"] == "failed"]
        self.assertEqual(failed["step"], name)
        self.assertEqual(set(states[states.index("failed") + 1:]) - {"not tried"}, set())
        self.assertTrue(failed["remedy"])
        text = self.run_suture("doctor", *targets, "--timeout", "2s").stdout
        self.assertIn(failed["found"], text)
        self.assertIn(failed["remedy"], text)
        return failed

    def test_an_unknown_verb(self):
        done = self.run_suture("raed", "x")
        self.assertEqual(done.returncode, 2)
        self.assertIn("Did you mean 'read'?", done.stderr)

    def test_a_command_line_that_cannot_be_meant(self):
        for words in (("read", GRIPPER), ("ps", "--jsn"), ("describe",), ("watch", GRIPPER, "opening", "--rate", "0"),
                      ("call", GRIPPER, "open", "--timeout", "soon")):
            with self.subTest(words=words):
                self.assertIn("--help", self.refused(*words, status=2))
        for name in ("robot", "robot:Hand", "Hand/Gripper", ":Hand/Gripper", "a:b/c/d:e"):
            with self.subTest(name=name):
                self.assertIn("is not of the form", self.refused("read", name, "x", status=2))
        self.assertIn("manager", self.refused("ps", "--manager", "somewhere", status=2))

    def test_a_time_that_is_none(self):
        """Each of these would mean another time, or none, instead of being an error."""
        for option in ("--timeout", "--for"):
            for time in ("-1", "0", "1e12", "1e-9s", "nan", "inf", "1e300min"):
                with self.subTest(option=option, time=time):
                    error = self.refused("watch", GRIPPER, f"{option}={time}", status=2)
                    self.assertTrue(error.startswith(option + ": "), error)
        self.assertIn("--timeout: Give a time from 1 ms to 1e9 s.", self.refused("ps", "--timeout", "0", status=2))
        for rate in ("nan", "inf", "-1", "0", "1e6"):
            with self.subTest(rate=rate):
                self.assertIn("--rate: Give a number from 0.001 to 1000.",
                              self.refused("watch", GRIPPER, "opening", f"--rate={rate}", status=2))

    def test_watch_can_be_ended_while_it_looks_for_its_provider(self):
        with socket.socket(socket.AF_UNIX) as silent:
            silent.bind(self.address.removeprefix("unix:"))
            silent.listen()
            watching = subprocess.Popen([SUTURE, "watch", "--manager", self.address, GRIPPER, "--timeout", "1000s"])
            self.addCleanup(watching.kill)
            with silent.accept()[0] as link:
                link.recv(1)
                watching.send_signal(signal.SIGTERM)
                self.assertEqual(watching.wait(PATIENCE), -signal.SIGTERM)

    def test_a_standard_descriptor_that_is_closed_becomes_no_socket(self):
        with socket.socket(socket.AF_UNIX) as silent:
            silent.bind(self.address.removeprefix("unix:"))
            silent.listen()
            asking = subprocess.Popen([SUTURE, "ps", "--manager", self.address, "--timeout", "1000s"], stdout=subprocess.DEVNULL,
                                      preexec_fn=lambda: (os.close(0), os.close(2)))
            self.addCleanup(asking.wait)
            self.addCleanup(asking.kill)
            with silent.accept()[0]:
                for descriptor in (0, 2):
                    self.assertEqual(os.readlink(f"/proc/{asking.pid}/fd/{descriptor}"), "/dev/null")

    def test_too_few_descriptors_are_no_peers_fault(self):
        self.start_manager()
        self.start_robot()

        def limited(limit, *words):
            return subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (limit, limit)))

        for limit in range(5, 10):
            with self.subTest(limit=limit):
                done = limited(limit, SUTURE, "read", "--manager", self.address, GRIPPER, "opening")
                self.assertIn(done.returncode, (0, 1), done)
                self.assertNotIn("what the process sent", done.stderr)
        self.assertIn("Raise the limit of open files (ulimit -n)", limited(5, SUTURE, "ps").stderr)
        # UBSan needs two free descriptors to look at an object, and reports a defect if it has none; at six it has them.
        done = limited(6, MANAGER, "--listen", self.address + "2")
        self.assertEqual(done.returncode, 1, done)
        self.assertTrue(done.stderr.startswith("suture-manager: "), done.stderr)

    def test_a_path_that_is_too_long(self):
        for words in (("--deployment", "x" * 300, "--out", "k"), ("--process", "left", "--out", "x" * 300)):
            done = self.run_without_manager("keys", *words)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("File name too long", done.stderr)

    def test_what_is_missing_on_the_command_line(self):
        keys = self.run_without_manager("keys", "--out", "k2")
        self.assertEqual(keys.returncode, 2)
        self.assertIn("--deployment FILE or --process NAME is required", keys.stderr)
        self.assertIn("--read requires name", self.refused("watch", GRIPPER, "--read", status=2))

    def test_a_reader_that_has_gone_changes_no_status(self):
        for words, status in (((SUTURE, "--help"), 0), ((SUTURE, "read", "--help"), 0), ((SUTURE, "psx", "--json"), 2),
                              ((SUTURE, "ps", "--json", "--manager", self.address), 1), ((MANAGER, "--help"), 0)):
            with self.subTest(words=words):
                reader, writer = os.pipe()
                os.close(reader)
                done = subprocess.run(words, stdout=writer, stderr=subprocess.PIPE, text=True, timeout=PATIENCE)
                os.close(writer)
                self.assertEqual((done.returncode, done.stderr), (status, ""))

    def test_the_help_of_a_manager_may_be_lost(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([MANAGER, "--help"], stdout=full, stderr=subprocess.PIPE, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 1)
        self.assertTrue(done.stderr.startswith("suture-manager: write to standard output: No space left on device."), done.stderr)

    def test_a_manager_that_is_asked_for_what_cannot_be_meant(self):
        for words in (("--lisen", "x"), ("--user", "me"), ("--keys",), ("again",)):
            with self.subTest(words=words):
                done = subprocess.run([MANAGER, *words], capture_output=True, text=True, timeout=PATIENCE)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertIn("--help", done.stderr)
        self.assertEqual(subprocess.run([MANAGER, "--help"], capture_output=True, timeout=PATIENCE).returncode, 0)

    def test_an_error_that_is_none(self):
        error = self.refused("why", "Errc::NotYett", status=2)
        self.assertIn("explain 'Errc::NotYett': no error has that name or text. There are 'awaiting-operator', ", error)
        self.assertIn("or name two interfaces", error)

    def test_a_page_shows_the_language_of_a_block_only(self):
        self.assertRegex(self.run_without_manager("why", "Invalid").stdout, "\n```cpp\n")

    def test_each_error_says_where_more_is(self):
        self.assertIn('\nsuture: `suture why "reach the global manager: ..."` tells more\n', self.run_suture("ps").stderr)

    def test_no_manager(self):
        error = self.refused("ps")
        self.assertIn("reach the global manager: connect to ", error)
        self.assertIn("there is no such socket. Start the process that should listen there, or correct the address.", error)
        self.assertIn(f"suture-manager --listen {self.address}", error)
        self.assertIn("suture-manager", self.failed("manager", "robot")["remedy"])

    def test_a_socket_of_a_process_is_no_manager(self):
        self.start_manager()
        self.start_robot()
        process = self.told("ps")[0]["addresses"][0]
        self.address = process
        self.assertEqual(self.refused("ps"), f"talk to {process}: what listens there is no global manager. Correct the address.")

    def test_a_manager_that_hangs(self):
        manager = self.start_manager()
        self.stop(manager)
        try:
            self.assertIn("does not answer as a global manager", self.failed("manager")["found"])
        finally:
            manager.send_signal(signal.SIGCONT)

    def test_names_that_are_not_there(self):
        self.start_manager()
        self.start_robot()
        self.assertIn("Did you mean 'robot'?", self.refused("describe", "robt"))
        self.assertIn("Did you mean 'Hand'?", self.refused("describe", "robot:Hnd"))
        self.assertIn("Did you mean 'Gripper'?", self.refused("describe", "robot:Hand/Griper"))
        self.assertIn("Did you mean 'Gripper'?", self.refused("read", "robot:Hand/Griper", "mode"))
        self.assertIn("Did you mean 'opening'?", self.refused("read", GRIPPER, "openin"))
        self.assertIn("Did you mean 'open'?", self.refused("call", GRIPPER, "opn"))
        error = self.refused("watch", GRIPPER, "stoped")
        self.assertIn(" has events and commands ", error)
        self.assertIn("Did you mean 'stopped'?", error)
        self.assertIn("Did you mean 'opening'?", self.refused("watch", GRIPPER, "openin"))
        self.assertIn("Did you mean 'Names'?", self.refused("why", "robot:Surgeon/Name", GRIPPER))

    def test_the_doctor_on_each_step(self):
        self.start_manager()
        robot = self.start_robot()
        self.assertIn("Did you mean 'robot'?", self.failed("resolve", "robt")["remedy"])
        self.assertIn("Did you mean 'Hand'?", self.failed("schema", "robot:Hnd")["remedy"])
        self.assertIn("Did you mean 'Gripper'?", self.failed("schema", "robot:Hand/Griper")["remedy"])
        self.stop(robot)
        try:
            self.await_silence("robot")
            self.assertIn("has not renewed its name in time", self.failed("resolve", "robot")["found"])
        finally:
            robot.send_signal(signal.SIGCONT)

    def test_another_version_of_the_protocol(self):
        self.start_manager()
        self.start_stranger("version")
        failed = self.failed("version", "version")
        self.assertIn("it speaks version 99", failed["found"])
        self.assertEqual(failed["remedy"], "Build both from the same release.")
        self.assertIn("it speaks version 99", self.refused("describe", "version"))

    def test_a_process_without_an_address(self):
        self.start_manager()
        self.start_stranger("homeless")
        self.assertEqual(self.refused("describe", "homeless"), "reach process 'homeless': it has no address. Restart it.")

    def test_a_process_that_is_older_than_its_explanations(self):
        self.start_manager()
        self.start_stranger("older")
        self.assertEqual(self.refused("read", "older:Odd/Arm", "mode"),
                         "ask process 'older' what it is: its Suture is older than that question. Rebuild it.")

    def test_a_socket_without_a_listener(self):
        self.start_manager()
        stranger = self.start_stranger("silent")
        self.assertIn("does not answer", self.failed("version", "silent")["found"])
        os.unlink(self.address.removeprefix("unix:") + ".silent")
        self.assertIn("there is no such socket", self.failed("connect", "silent")["found"])
        self.assertIsNone(stranger.poll())

    def test_control_characters_are_not_printed(self):
        self.start_manager()
        self.start_stranger("escapes")
        for verb in (("ps",), ("describe", "escapes"), ("doctor",)):
            with self.subTest(verb=verb):
                self.assertNotIn("\x1b", self.said(*verb))
        self.assertEqual(self.told("ps")[0]["host"], "\x1b[2J")

    def test_a_process_that_explains_itself_with_nonsense(self):
        self.start_manager()
        for how, found in (("description", "its description is not one"), ("depth", "its description is not one"),
                           ("incomplete", "its schema is not one"), ("broken", "its schema is not one")):
            with self.subTest(how=how):
                self.start_stranger(how)
                for words in (("describe", f"{how}:Odd/Arm"), ("read", f"{how}:Odd/Arm", "mode"),
                              ("call", f"{how}:Odd/Arm", "servo_cp", "--args", GOAL),
                              ("watch", f"{how}:Odd/Arm", "stopped")):
                    self.assertIn(found, self.refused(*words))
                self.assertIn(found, self.failed("schema", f"{how}:Odd/Arm")["found"])

    def test_a_resume_that_answers_no_text(self):
        self.start_manager()
        self.start_stranger("wordless")
        self.assertIn("it answers '0', which this program does not know", self.refused("resume", "wordless:Odd/Arm"))

    def test_a_type_that_holds_itself(self):
        self.start_manager()
        self.start_stranger("groups")
        self.assertIn("nested deeper than anything of ours", self.refused("read", "groups:Odd/Arm", "everything"))


unittest.main()
