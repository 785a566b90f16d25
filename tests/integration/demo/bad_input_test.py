"""Runs programs that cannot start: each says what was asked, what was found and what to do, and ends with 1."""

import json
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAMS = pathlib.Path(sys.argv.pop(1))
TOPOLOGIES = PROGRAMS.parent / "share/suture/teleoperation"

ARM = {"name": "PSM1", "class": "Psm"}
DRIVES = {"name": "PSM1Drives", "class": "PsmDrives"}
DRIVEN = ("p:PSM1/Drives", "p:PSM1Drives/Drives")
TELEOP = {"name": "Teleop", "class": "Teleop"}


def system(components, connections=(), **more):
    return {"processes": [{"name": "p", "components": components}],
            "connections": [dict(zip(("from", "to"), one)) for one in connections], **more}


class Workstation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "d.json"

    def error_of(self, deployment, *options):
        """Returns the standard error of a workstation that must refuse `deployment`."""
        text = deployment if isinstance(deployment, str) else json.dumps(deployment, indent=1)
        self.file.write_text(text)
        process = subprocess.run(
            [PROGRAMS / "suture-workstation", "--deployment", self.file, "--seconds", "1", *options],
            capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1, process.stderr)
        return process.stderr

    def test_file_that_is_not_there(self):
        process = subprocess.run([PROGRAMS / "suture-workstation", "--deployment", "/no/such.json"],
                                 capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn("/no/such.json: error: cannot be read: No such file", process.stderr)

    def test_syntax_error(self):
        self.assertIn(f"{self.file}:2:1: error: this is not JSON", self.error_of("{\n]"))

    def test_unknown_key(self):
        error = self.error_of({"processes": [], "conections": []})
        self.assertIn("error: unknown key 'conections'; did you mean 'connections'?", error)

    def test_unknown_class(self):
        error = self.error_of(system([{"name": "PSM1", "class": "Pms"}]))
        self.assertIn(f"{self.file}:8: error: no component class 'Pms' in this program", error)
        self.assertIn("did you mean 'Psm'?", error)

    def test_wrong_parameter(self):
        error = self.error_of(system([dict(DRIVES, parameters={"time_constnt": 1})]))
        self.assertIn("unknown key 'time_constnt'; did you mean 'time_constant'?", error)

    def test_unknown_interface(self):
        error = self.error_of(system([ARM, DRIVES, TELEOP], [DRIVEN, ("p:Teleop/Slave", "p:PSM1/Amr"),
                                                     ("p:Teleop/Master", "p:PSM1/Arm")]))
        self.assertIn("component 'PSM1' has provided interfaces 'Arm'", error)
        self.assertIn("Did you mean 'Arm'?", error)

    def test_required_interface_without_a_connection(self):
        error = self.error_of(system([ARM, DRIVES, TELEOP], [DRIVEN, ("p:Teleop/Slave", "p:PSM1/Arm")]))
        self.assertIn("required interface 'p:Teleop/Master' (robots::Arm) has no provider", error)

    def test_contracts_that_differ(self):
        recorder = {"name": "R", "class": "Recorder",
                    "parameters": {"file": str(self.folder / "r.jsonl")}}
        error = self.error_of(system([ARM, DRIVES, recorder], [DRIVEN, ("p:R/Teleoperation", "p:PSM1/Arm"),
                                                       ("p:R/Arm", "p:PSM1/Arm")]))
        self.assertIn("it requires robots::Teleoperation and is offered robots::Arm", error)

    def test_frames_that_differ(self):
        arm = dict(ARM, frames={"Arm": {"reference": "PSM1_base"}})
        teleop = dict(TELEOP, frames={"Slave": {"reference": "PSM2_base"}})
        error = self.error_of(system([arm, DRIVES, teleop], [DRIVEN, ("p:Teleop/Slave", "p:PSM1/Arm"),
                                                             ("p:Teleop/Master", "p:PSM1/Arm")]))
        self.assertIn("it expects reference frame 'PSM2_base' and is offered 'PSM1_base'", error)

    def test_process_that_must_be_named(self):
        deployment = system([ARM, DRIVES], [DRIVEN], manager="unix:/tmp/nobody.sock")
        deployment["processes"].append({"name": "q", "components": []})
        self.assertIn("there are several processes: 'p' and 'q'; say which one with --process",
                      self.error_of(deployment))
        self.assertIn("no process 'r' here", self.error_of(deployment, "--process", "r"))

    def test_manager_that_is_not_running(self):
        address = f"unix:{self.folder}/nobody.sock"
        began = time.monotonic()
        error = self.error_of(system([ARM, DRIVES], [DRIVEN], manager=address))
        self.assertLess(time.monotonic() - began, 30)
        self.assertIn(f"{self.file}:", error)
        self.assertIn(address, error)
        self.assertIn("suture-manager --listen", error)

    def test_port_in_use(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            address = f"tcp://127.0.0.1:{taken.getsockname()[1]}"
            process = subprocess.run([PROGRAMS / "suture-manager", "--listen", address],
                                     capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn(address, process.stderr)
        self.assertIn("another process listens there. Stop it, or choose another", process.stderr)


class Demo(unittest.TestCase):
    def test_a_picture_needs_a_guide(self):
        process = subprocess.run(
            [PROGRAMS / "suture-demo", "--topology", "fig3c", "--seconds", "1", "--picture", "knot.png"],
            capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn("nothing in this topology places a knot. Choose one with a KnotGuide", process.stderr)
        self.assertEqual(process.stdout, "", "it is refused before the run")

    def test_a_rate_at_which_a_cycle_is_too_long_to_be_judged(self):
        process = subprocess.run([PROGRAMS / "suture-demo", "--rate", "99"], capture_output=True, text=True, timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn("--rate: Value 99 not in range", process.stderr)

    def error_of(self, change, folder=None):
        """Returns why a run of fig3c, changed in a file of that folder, ends with an error."""
        topology = json.loads((TOPOLOGIES / "fig3c.json").read_text())
        change(topology)
        with tempfile.TemporaryDirectory() as elsewhere:
            file = (folder or pathlib.Path(elsewhere)) / "changed.json"
            file.write_text(json.dumps(topology))
            process = subprocess.run([PROGRAMS / "suture-demo", "--topology", file, "--seconds", "1"],
                                     capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1, process.stdout)
        return process.stderr

    def test_what_a_run_is_judged_by_has_to_be_in_the_file(self):
        def without_connections(end, name):
            def change(topology):
                topology["connections"] = [one for one in topology["connections"] if not one[end].endswith(name)]
            return change

        def without_parameters(topology):
            for process in topology["processes"]:
                for component in process["components"]:
                    if component["class"] == "Recorder":
                        del component["parameters"]["file"]

        self.assertIn("the deployment does not connect it. Connect it in the topology's file",
                      self.error_of(without_connections("from", "/Master")))
        self.assertIn("nothing in the deployment records it. Connect a Recorder to it",
                      self.error_of(without_connections("to", "/Teleoperation")))
        self.assertIn("the topology's file leaves it out, or gives it another type. State it there",
                      self.error_of(without_parameters))

    def test_a_file_that_is_not_there(self):
        process = subprocess.run([PROGRAMS / "suture-demo", "--topology", "lab.json"], capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn("finding topology 'lab.json': there is no such file. Give the path of a deployment file", process.stderr)

    def test_paths_of_a_topology_count_from_its_own_folder(self):
        def with_a_library(topology):
            topology["processes"][0]["components"][0]["library"] = "build/liblab.so"

        with tempfile.TemporaryDirectory() as folder:
            error = self.error_of(with_a_library, pathlib.Path(folder))
            self.assertIn(f"loading components from '{folder}/build/liblab.so': there is no such file", error)

    def test_without_the_command_that_makes_namespaces(self):
        process = subprocess.run([PROGRAMS / "suture-demo", "--network", "namespaces"], capture_output=True, text=True,
                                 timeout=60, env={**os.environ, "PATH": "/nonexistent"})
        self.assertEqual(process.returncode, 1)
        self.assertRegex(process.stderr, "running over --network namespaces: (the command 'ip -V' fails|network namespaces "
                                         "need root). Run it as root")

    def test_nowhere_to_record(self):
        for folder, found in (("/nonexistent", "No such file or directory"), ("/proc", "/proc/suture-demo-")):
            process = subprocess.run([PROGRAMS / "suture-demo", "--seconds", "1"], capture_output=True, text=True, timeout=60,
                                     env={**os.environ, "TMPDIR": folder})
            self.assertEqual(process.returncode, 1)
            self.assertIn(f"make a folder for what this run records: {found}", process.stderr)
            self.assertIn(". Let TMPDIR name a folder where this user may write", process.stderr)

    def test_too_little_space_for_a_long_run(self):
        with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:  # which is as large as some of the memory
            process = subprocess.run(
                [PROGRAMS / "suture-demo", "--topology", "single", "--seconds", "86400", "--rate", "10000"],
                capture_output=True, text=True, timeout=60, env={**os.environ, "TMPDIR": folder})
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])
        self.assertEqual(process.returncode, 1)
        self.assertRegex(process.stderr, rf"recording this run in {folder}/suture-demo-\w+: it takes 2\d{{3}}\.\d GB, and only "
                                         r"\d+\.\d GB are free there. Let TMPDIR name a folder on a larger disk")
        self.assertEqual(process.stdout, "", "it is refused before the run")

    def test_too_few_descriptors_for_a_process(self):
        """One is left beside that for signals, so that files can be read but nothing can be started."""
        process = subprocess.run(["sh", "-c", f"ulimit -n 5; exec {PROGRAMS}/suture-demo --topology single --seconds 1"],
                                 capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn("start process 'console': Too many open files. Raise the limits of this user (ulimit -n for descriptors", process.stderr)

    def test_a_program_that_is_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            programs = pathlib.Path(folder) / "bin"
            programs.mkdir()
            shutil.copy(PROGRAMS / "suture-demo", programs)
            (pathlib.Path(folder) / "share").symlink_to(PROGRAMS.parent / "share")
            process = subprocess.run([programs / "suture-demo", "--topology", "single", "--seconds", "1"],
                                     capture_output=True, text=True, timeout=60)
            self.assertEqual(process.returncode, 1)
            self.assertIn(f"cannot be started: {programs}/suture-workstation: No such file or directory. "
                          "Build that program; it has to be beside this one\n", process.stderr)

    def test_shared_memory_between_machines(self):
        process = subprocess.run([PROGRAMS / "suture-demo", "--lane", "shm", "--network", "tcp"],
                                 capture_output=True, text=True, timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertIn("lane shm over --network tcp: shared memory is for processes that reach each other by a Unix "
                      "socket. Leave --network out", process.stderr)


unittest.main()
