"""Runs a gtest program and prints the cases that do not simply pass: run_gtest.py RECORD PROGRAM [FLAG...]

A program of hundreds of cases runs in few processes, and a reader of a failure wants that case alone: its output is held back
until the case has ended, and dropped if it passed. A case that ends the process, or that runs for long, is named. RECORD is where
gtest writes how long each case took, for tests/timing.sh.
"""

import ctypes
import os
import pathlib
import re
import select
import signal
import subprocess
import sys
import time

BEGIN = re.compile(r"^\[ RUN      \] (\S+)")
PASSED = re.compile(r"\[       OK \] \S+ \(\d+ ms\)$")
ENDED = re.compile(r"\[  (?:FAILED |SKIPPED) \] \S+.*\(\d+ ms\)$")
# ctest kills what takes too long without a word, so a case is named before.
LONG = 20


class Filter:
    """Prints what belongs to no case at once, and what belongs to one when the case has not passed."""

    def __init__(self):
        self.case, self.held, self.since, self.told = None, [], 0, False

    def line(self, text):
        begun = BEGIN.match(text)
        if begun:
            self.case, self.held, self.since, self.told = begun[1], [text], time.monotonic(), False
        elif self.case is None:
            print(text)
        elif PASSED.search(text):
            self.case = None
        else:
            self.held.append(text)
            if ENDED.search(text):
                self.give_up()

    def give_up(self):
        if self.case is not None:
            print("\n".join(self.held))
        self.case = None

    def wait(self):
        if self.case is not None and not self.told and time.monotonic() - self.since > LONG:
            self.told = True
            print(f"{self.case} has been running for {LONG} s.", flush=True)


def die_with_parent():
    """ctest kills this process alone: the program must not outlive it."""
    death_signal = 1
    ctypes.CDLL(None).prctl(death_signal, signal.SIGKILL)


def run(command):
    program = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, preexec_fn=die_with_parent)
    cases, rest = Filter(), b""
    while True:
        # Another process that a case has left behind may keep the pipe open for ever.
        if not select.select([program.stdout], [], [], 1)[0]:
            cases.wait()
            if program.poll() is not None:
                break
            continue
        data = os.read(program.stdout.fileno(), 1 << 16)
        if not data:
            break
        *lines, rest = (rest + data).split(b"\n")
        for text in lines:
            cases.line(text.decode(errors="replace"))
    if rest:
        cases.line(rest.decode(errors="replace"))
    status = program.wait()
    ended_within = cases.case
    cases.give_up()
    if ended_within:
        how = f"by signal {signal.Signals(-status).name}" if status < 0 else f"with status {status}"
        print(f"The process ended {how} within {ended_within}.")
        return status or 1
    return status


def main():
    record = pathlib.Path(sys.argv[1])
    record.parent.mkdir(parents=True, exist_ok=True)
    record.unlink(missing_ok=True)
    sys.exit(1 if run([*sys.argv[2:], f"--gtest_output=json:{record}"]) else 0)


if __name__ == "__main__":
    main()
