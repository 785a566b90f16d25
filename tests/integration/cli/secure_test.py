"""These tests run `suture` beside a system whose processes prove who they are."""

import json
import pathlib
import re
import stat
import subprocess
import unittest

from system import MANAGER, ROBOT, STRANGER, System


class SecureSystem(System):
    def setUp(self):
        super().setUp()
        self.keys = str(pathlib.Path(self.address.removeprefix("unix:")).parent / "keys")

    def make_keys(self, *names, out=None):
        words = [word for name in names for word in ("--process", name)]
        return self.told_without_manager("keys", *words, "--out", out or self.keys)["made"]

    def make_ca(self, days):
        """Returns a new folder with a CA that ends after so many days."""
        folder = pathlib.Path(self.keys + "-short")
        folder.mkdir(mode=0o700)
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ed25519", "-nodes", "-days", str(days), "-subj", "/CN=Suture CA",
                        "-keyout", folder / "ca.key", "-out", folder / "ca.crt"], check=True, capture_output=True)
        (folder / "ca.key").chmod(0o600)
        return folder

    def start_system(self):
        self.make_keys("robot", "suture")
        manager = self.start_and_hear(MANAGER, "--listen", "tls://127.0.0.1:0", "--keys", self.keys)
        self.address = manager.split(" ready on ")[1].strip()
        self.complaints = pathlib.Path(self.keys + "-complaints")
        with self.complaints.open("w") as stderr:
            self.start(ROBOT, self.address, "robot", self.keys, stderr=stderr)

    def test_keys_are_made_for_their_owner_alone(self):
        made = [pathlib.Path(file) for file in self.make_keys("robot", "suture")]
        self.assertEqual(sorted(file.name for file in made if file.suffix == ".key"),
                         ["ca.key", "robot.key", "suture-manager.key", "suture.key"])
        for file in made:
            if file.suffix == ".key":
                self.assertEqual(stat.S_IMODE(file.stat().st_mode), 0o600, file)
        late = self.make_keys("late")
        self.assertEqual(len(late), 2)
        done = self.run_without_manager("keys", "--process", "late", "--out", self.keys)
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("late", done.stderr)

    def test_a_manager_warns_before_its_ca_ends(self):
        folder = self.make_ca(days=20)
        self.run_without_manager("keys", "--process", "suture-manager", "--out", str(folder))
        with (folder / "told").open("w") as stderr:
            self.start(MANAGER, "--listen", "tls://127.0.0.1:0", "--keys", folder, stderr=stderr)
        self.assertRegex((folder / "told").read_text(),
                         rf"^suture-manager: warning: the CA {folder}/ca.crt ends at .* UTC. Before that, make the keys of all processes anew")

    def test_it_says_that_a_ca_shortens_the_life_of_a_certificate(self):
        self.assertNotIn("warning", self.told_without_manager("keys", "--process", "robot", "--out", self.keys))
        short = self.make_ca(days=100)
        done = self.run_without_manager("keys", "--process", "robot", "--out", str(short))
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertRegex(done.stdout.splitlines()[-1], r"^These certificates end at 20\d\d-\d\d-\d\d \d\d:\d\d UTC, which is sooner than usual, "
                                                       r"because their CA does\. Before that, make the keys of all processes anew")
        self.assertIn("sooner than usual", self.told_without_manager("keys", "--process", "late", "--out", str(short))["warning"])

    def test_it_shows_its_certificate_and_asks_for_theirs(self):
        self.start_system()
        self.assertIn("robot", self.said("ps", "--keys", self.keys))
        self.assertIn("commands", self.said("describe", "robot:Hand/Gripper", "--keys", self.keys))
        told = self.told("doctor", "robot:Hand/Gripper", "--keys", self.keys)
        self.assertTrue(told["good"], told)
        steps = {step["step"]: step for step in told["examinations"][1]["steps"]}
        self.assertEqual(steps["tls"]["state"], "ok")
        self.assertRegex(steps["tls"]["found"], r"^it has the certificate of 'robot', which ends at 20\d\d-\d\d-\d\d \d\d:\d\d UTC$")
        self.assertEqual(self.complaints.read_text(), "")

    def test_a_registered_address_does_not_lead_out_of_tls(self):
        self.start_system()
        self.make_keys("outside")
        self.start(STRANGER, self.address, "outside", "outside", self.keys)
        why = (r"^connect to process 'outside': it listens at tcp://127\.0\.0\.1:\d+, and the global manager is reached at "
               + re.escape(self.address))
        self.assertRegex(self.refused("read", "outside:Odd/Arm", "mode", "--keys", self.keys), why)
        done = self.run_suture("doctor", "outside", "--keys", self.keys, "--json")
        self.assertEqual(done.returncode, 1, done)
        steps = {step["step"]: step for step in json.loads(done.stdout)["examinations"][1]["steps"]}
        self.assertEqual(steps["resolve"]["state"], "failed")
        self.assertRegex(steps["resolve"]["found"], why)
        self.assertNotEqual(steps["tls"]["state"], "ok")

    def test_without_keys_it_says_what_to_do(self):
        self.start_system()
        self.assertIn("keys", self.refused("ps"))

    def test_keys_of_another_system_are_refused(self):
        self.start_system()
        other = self.keys + "-of-others"
        self.make_keys("suture", out=other)
        done = self.run_suture("doctor", "robot", "--keys", other)
        self.assertEqual(done.returncode, 1, done)
        self.assertIn("failed", done.stdout)
        self.assertIn("certificate", done.stdout)
        self.assertNotIn("start it with", done.stdout, "the manager runs")

    def test_an_address_of_the_wrong_kind_is_named(self):
        self.start_system()
        self.address = self.address.replace("tls", "tcp")
        error = self.refused("ps")
        self.assertEqual(error, f"talk to {self.address}: it speaks TLS, and this end does not. Correct the address: tls:// at "
                                "both ends, or at neither.")


if __name__ == "__main__":
    unittest.main()
