"""Starts two processes that talk to each other by a manager of their own."""

import argparse
import subprocess
import sys
import tempfile
import unittest

# Two builds that differ share no memory.
LANES = ("frame", "rpc")


def talk(programs, server, client, lane):
    """Returns what the server printed behind "ready", and what the client printed, line by line. They talk by `lane`, one of LANES."""
    with tempfile.TemporaryDirectory() as folder:
        address = f"unix:{folder}/manager.sock"
        with subprocess.Popen([programs["manager"], "--listen", address], stdout=subprocess.PIPE, text=True) as manager:
            try:
                first = manager.stdout.readline()
                assert "ready" in first, first
                return talk_at(address, programs[server], programs[client], lane)
            finally:
                manager.terminate()
                manager.wait(30)


def talk_at(address, server, client, lane):
    serving = subprocess.Popen([server, "serve", address], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        first = serving.stdout.readline()
        assert first == "ready\n", first
        asked = subprocess.run([client, "ask", address, lane], capture_output=True, text=True, timeout=60)
        assert asked.returncode == 0, asked.stdout + asked.stderr
    finally:
        served, _ = serving.communicate("\n", timeout=30)
    assert serving.returncode == 0, served
    return served.splitlines(), asked.stdout.splitlines()


def run_tests(programs):
    """Runs the caller's tests; the command line names the programs."""
    parser = argparse.ArgumentParser()
    for name in ("manager", "v1", "v2"):
        parser.add_argument(f"--{name}", required=True)
    arguments, rest = parser.parse_known_args()
    programs.update(vars(arguments))
    unittest.main(argv=[sys.argv[0], *rest])
