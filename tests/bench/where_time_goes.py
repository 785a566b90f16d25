#!/usr/bin/env python3
"""Says where each microsecond of a round trip goes, on each lane: where_time_goes.py [--bench PROGRAM] [LANE...]

Both ends of `suture-bench network`'s round trips run on one processor, which never rests meanwhile. So the share of a profiler's
samples that fall into a part of the code, times the median round trip, is the time that this part takes of it. Needs Debian's
linux-perf and the preset release; a quiet machine is wanted. LANE is shm, frame.unix, frame.tcp, frame.tls, rpc.unix ...
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LANES = ["shm", "frame.unix", "frame.tcp", "frame.tls", "rpc.unix"]
FREQUENCY = 2000  # samples per second

# The first line whose pattern is found in the stack names the part. In the kernel a sample belongs to its system call: where
# interrupts are off, the profiler's own comes late, so the innermost function says little.
KERNEL = [
    ("kernel: futexes, which wake and sleep", r"futex"),
    ("kernel: epoll", r"ep_|epoll|eventfd"),
    ("kernel: sockets", r"sock_|sendmsg|sendto|recvmsg|recvfrom|tcp_|unix_|writev|ksys_read|ksys_write"),
    ("kernel: the rest", r""),
]
USER = [
    ("encryption", r"libcrypto|libssl"),
    ("checksum", r"crc32|libisal"),
    ("Cap'n Proto and KJ", r"libkj|libcapnp|capnp::|kj::"),
    ("slots, rings, lanes, generated code", r"suture::|bench::"),
    ("C library, clock, entry into the kernel", r""),
]
MEASURING = ("suture-bench", "exe", "perf", "kworker", "swapper")  # threads that are no end of the round trip


def fail(asked, found, remedy):
    sys.exit(f"Error: asked for {asked}, found {found}. {remedy}.")


def part_of(stack):
    """Returns the part to which a sample belongs."""
    kernel = "[kernel" in stack[0]
    frames = [one for one in stack if "[kernel" in one] if kernel else stack[:1]
    return next(name for name, pattern in (KERNEL if kernel else USER) if any(re.search(pattern, one) for one in frames))


def stacks_of(script):
    """Yields the stacks of the threads that are at either end."""
    for block in script.split("\n\n"):
        lines = block.strip().splitlines()
        if len(lines) > 1 and not lines[0].strip().startswith(MEASURING):
            yield [line.split(maxsplit=1)[1] for line in lines[1:]]


def measure(bench, lane, cpu, folder):
    """Returns the median of a round trip in us, and the part of each sample."""
    report, record = folder / "report.json", folder / "perf.data"
    command = [bench, "network", "--part", "round trips", "--lane", lane, "--cpu", str(cpu), "--json", report]
    perf = ["perf", "record", "--quiet", "-a", "-e", "cpu-clock", "-F", str(FREQUENCY), "-g", "-o", record, "--", *command]
    done = subprocess.run(perf, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        fail(f"a profile of {lane}", f"'{done.stderr.strip()}'", "See that perf may record all processes, as root may")
    median = json.loads(report.read_text())["figures"][lane]["p50"]
    script = subprocess.run(
        ["perf", "script", "-i", record, "-C", str(cpu), "-F", "comm,ip,sym,dso"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        text=True, check=True)
    return median, [part_of(stack) for stack in stacks_of(script.stdout)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bench", type=pathlib.Path, default=ROOT / "build/release/bin/suture-bench")
    parser.add_argument("lanes", nargs="*", default=LANES)
    arguments = parser.parse_args()
    if not arguments.bench.exists():
        fail(f"the program {arguments.bench}", "none", "Build it: cmake --preset release && cmake --build --preset release --target suture-bench")
    parts = [name for name, _ in USER + KERNEL]
    if not shutil.which("perf"):
        fail("the profiler perf", "none", "Install it: apt-get install --no-install-recommends linux-perf")
    cpu = max(os.sched_getaffinity(0))
    columns = {}
    with tempfile.TemporaryDirectory() as folder:
        for lane in arguments.lanes:
            columns[lane] = measure(arguments.bench, lane, cpu, pathlib.Path(folder))
    print("| us of a round trip | " + " | ".join(columns) + " |\n|" + " --- |" * (len(columns) + 1))
    for part in parts:
        times = [f"{median * found.count(part) / len(found):.2f}" for median, found in columns.values()]
        print(f"| {part} | " + " | ".join(times) + " |")
    print("| **all** | " + " | ".join(f"**{median:.2f}**" for median, _ in columns.values()) + " |")


if __name__ == "__main__":
    main()
