"""Workstations say what they wait for, and that they run."""

import os
import pathlib
import subprocess
import unittest

from stations import PROGRAM, Stations, component

SUTURE = pathlib.Path(PROGRAM).parent / "suture"


class Starting(Stations):
    def two(self, manager):
        """A hand that turns the platter of another process."""
        return {"manager": manager,
                "processes": [{"name": "here", "components": [component("Hand", "Hand")]},
                              {"name": "there", "components": [component("Platter", "Platter", angle=0)]}],
                "connections": [{"from": "here:Hand/Turntable", "to": "there:Platter/Turntable"}]}

    def test_a_wait_for_a_manager_is_told_with_the_remedy(self):
        address = f"unix:{self.folder}/manager.sock"
        station = self.workstation(self.two(address), "--process", "there")
        self.assertEqual(station.stderr.readline(), "there: waits for a global manager for at most 10 s. "
                                                    f"If it does not run, start it with: suture-manager --listen {address}\n")
        self.manager(address)
        self.assertEqual(station.stderr.readline(), "there: runs 'Platter'\n")

    def test_a_socket_of_a_process_is_no_manager(self):
        address = f"unix:{self.folder}/manager.sock"
        self.manager(address)
        there = self.workstation(self.two(address), "--process", "there")
        self.await_line(there, "runs 'Platter'\n")
        (socket,) = self.folder.glob("there.*.sock")
        here = self.workstation(self.two(f"unix:{socket}"), "--process", "here")
        problems = here.communicate(timeout=60)[1]
        self.assertEqual(here.returncode, 1)
        self.assertIn(f"talk to unix:{socket}: what listens there is no global manager. Correct the address.", problems)

    def test_a_wait_for_a_provider_names_its_process(self):
        address = f"unix:{self.folder}/manager.sock"
        self.manager(address)
        deployment = self.two(address)
        hand = self.workstation(deployment, "--process", "here")
        self.assertEqual(hand.stderr.readline(), "here: waits for 'there:Platter/Turntable' for at most 10 s. "
                                                 "Start process 'there' if it does not run\n")
        platter = self.workstation(deployment, "--process", "there")
        self.assertEqual(hand.stderr.readline(), "here: runs 'Hand'\n")
        self.assertEqual(platter.stderr.readline(), "there: runs 'Platter'\n")

    def test_a_process_without_components_says_so(self):
        station = self.workstation({"processes": [{"name": "one", "components": []}]}, "--seconds", "0.1")
        self.assertEqual(station.communicate(timeout=60)[1], "one: runs no component\n")

    def test_who_reads_reports_is_told_there(self):
        station = self.workstation({"processes": [{"name": "one", "components": []}]},
                                   "--report-fd", "-", "--report-form", "text", "--seconds", "0.1")
        told, problems = station.communicate(timeout=60)
        self.assertTrue(told.startswith("started\n"), told)
        self.assertEqual(problems, "")

    def test_sockets_are_found_from_any_folder(self):
        self.manager(f"unix:{self.folder}/manager.sock")
        deployment = self.two("unix:manager.sock")
        relative = pathlib.Path(os.path.relpath(self.folder, "/"))
        hand = self.workstation(deployment, "--process", "here", cwd=self.folder)
        platter = self.start(hand.args[0], "--deployment", relative / "d.json", "--process", "there", cwd="/")
        for station, name in ((hand, "Hand"), (platter, "Platter")):
            self.await_line(station, f"runs '{name}'\n")

    def test_a_misspelt_option_is_told_with_the_nearest(self):
        for words, told in (("--deployement", "there is no option '--deployement'; did you mean '--deployment'?"),
                            ("", "--deployment FILE is missing: it says what this process runs"),
                            ("--seconds", "--seconds: 1 required FLOAT")):
            station = self.start(PROGRAM, *words.split())
            problems = station.communicate(timeout=60)[1]
            self.assertTrue(problems.startswith(told), problems)
            self.assertEqual(station.returncode, 2)

    def test_a_whole_file_is_checked_without_a_start(self):
        """No global manager listens, so a process that started would wait for it."""
        address = f"unix:{self.folder}/manager.sock"
        station = self.workstation(self.two(address), "--check")
        self.assertEqual(station.communicate(timeout=60),
                         (f"{self.folder}/d.json: no mistake in 2 processes, 2 components and 1 connection\n", ""))
        self.assertEqual(station.returncode, 0)

    def test_a_check_tells_the_mistakes_of_all_processes(self):
        deployment = self.two(f"unix:{self.folder}/manager.sock")
        for process in deployment["processes"]:
            process["components"].append(component("Wrong", f"Of_{process['name']}"))
        station = self.workstation(deployment, "--check")
        told, problems = station.communicate(timeout=60)
        lines = problems.splitlines()
        self.assertEqual((station.returncode, told, len(lines)), (1, "", 3), problems)
        for line, name in zip(lines, ("here", "there")):
            self.assertIn(f"d.json:1: error: no component class 'Of_{name}' in library", line)
        alone = self.workstation(deployment, "--check", "--process", "here").communicate(timeout=60)[1]
        self.assertEqual(alone.splitlines()[0], lines[0])
        self.assertNotIn("Of_there", alone)

    def ended(self, words, output):
        """Returns the exit status and what is told on standard error."""
        file = self.folder / "d.json"
        file.write_text('{"processes": [{"name": "one", "components": []}]}')
        done = subprocess.run([PROGRAM, "--deployment", file, *words], stdout=output, stderr=subprocess.PIPE, text=True, timeout=60, check=False)
        return done.returncode, done.stderr

    def test_an_answer_that_is_lost_is_a_failure(self):
        for words in (("--check",), ("--help",)):
            with self.subTest(words=words), open("/dev/full", "w", encoding="utf-8") as full:
                self.assertEqual(self.ended(words, full),
                                 (1, "write to standard output: No space left on device. Make room, or write elsewhere\n"))

    def test_a_reader_that_has_gone_changes_no_status(self):
        for words, status in ((("--check",), 0), (("--help",), 0), (("--check", "--process", "two"), 1)):
            with self.subTest(words=words):
                reader, writer = os.pipe()
                os.close(reader)
                self.assertEqual(self.ended(words, writer)[0], status)
                os.close(writer)

    def test_the_command_that_tells_more_can_be_copied(self):
        station = self.workstation({"processes": [{"name": "one", "components": [{"name": "Hand", "class": "Hnad"}]}]})
        lines = station.communicate(timeout=60)[1].splitlines()
        self.assertRegex(lines[0], ": error: no component class 'Hnad' in ")
        self.assertRegex(lines[1], "^`suture why \"no component class 'Hnad' in .*\"` tells more$")
        command = lines[1].partition("`")[2].rpartition("`")[0].replace("suture", str(SUTURE), 1)
        explained = subprocess.run(["sh", "-c", command], capture_output=True, text=True, timeout=60, check=True).stdout
        self.assertIn("why it happens: The program or the library offers no class of that name", explained)

    def refused(self, *words, **settings):
        """Returns what a command line is refused with, before anything starts."""
        station = self.workstation({"processes": [{"name": "one", "components": []}]}, *words, **settings)
        told, problems = station.communicate(timeout=60)
        self.assertEqual((station.returncode, told), (2, ""), problems)
        self.assertIn("--help` tells what there is.\n", problems)
        return problems

    def test_reports_go_nowhere_but_to_an_open_descriptor(self):
        """A number that is free at the start would be that of a socket or a recording later."""
        for text in ("7", "99"):
            problems = self.refused("--seconds", "0.1", "--report-fd", text)
            self.assertIn(f"--report-fd: descriptor {text} is not open. Open it where this is started", problems)
        for text in ("1.5", "1e3", "nan", "-1", "99999999999", "+1", ""):
            self.assertIn("--report-fd: it is no descriptor. Give - or a number", self.refused("--seconds", "0.1", "--report-fd", text))
        with open(os.devnull, encoding="utf-8") as readable:
            self.assertIn("--report-fd: descriptor 0 is not open for writing.",
                          self.refused("--seconds", "0.1", "--report-fd", "0", stdin=readable))

    def test_a_time_that_is_none(self):
        for seconds in ("nan", "inf", "-1", "1e12", "soon"):
            self.assertIn("--seconds: Give a number from 0 to 1e+09\n", self.refused(f"--seconds={seconds}"))
        for interval in ("nan", "0", "-1", "1e12"):
            problems = self.refused("--seconds", "0.1", "--report-fd", "-", f"--report-interval={interval}")
            self.assertIn("--report-interval: Give a number from 0.01 to 1e+06\n", problems)

    def test_how_to_report_needs_where_to(self):
        for words in (("--report-form", "text"), ("--report-interval", "2")):
            self.assertIn(f"{words[0]} requires --report-fd", self.refused("--seconds", "0.1", *words))

    def test_reports_that_are_lost_are_a_failure(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            station = self.workstation({"processes": [{"name": "one", "components": []}]}, "--seconds", "0.1",
                                       "--report-fd", str(full.fileno()), pass_fds=(full.fileno(),))
            problems = station.communicate(timeout=60)[1]
        self.assertEqual((station.returncode, problems),
                         (1, "one: write reports: No space left on device. None is written any more: make room, or give another file with --report-fd\n"))


if __name__ == "__main__":
    unittest.main()
