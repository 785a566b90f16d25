#!/usr/bin/env python3
"""Says where each microsecond of a round trip goes, on each lane: where_time_goes.py [--bench PROGRAM] [LANE...]

Both ends of `suture-bench network`'s round trips run on one processor, which never rests meanwhile. So the share of a profiler's
samples that fall into a part of the code, times the median round trip, is the time that this part takes of it. Needs Debian's
linux-perf and the preset release; a quiet machine is wanted. LANE is shm, frame.unix, frame.tcp, frame.tls, rpc.unix ...
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LANES = ["shm", "frame.unix", "frame.tcp", "frame.tls", "rpc.unix"]
FREQUENCY = 5000  # samples per second

# The first line whose pattern is found in a frame of the stack, the innermost frame first, names the part.
KERNEL = [
    ("waking and sleeping", r"futex|eventfd|ep_poll|epoll|schedule|try_to_wake|poll_schedule"),
    ("sockets", r"sock|tcp_|unix_|inet_|ip_|skb|loopback|napi|net_rx"),
    ("rest of the kernel", r""),
]
USER = [
    ("encryption", r"libcrypto|libssl"),
    ("Cap'n Proto and KJ", r"libkj|libcapnp|capnp::|kj::"),
    ("slots, rings, lanes", r"suture::|bench::.*(store|load)|lane|Ring"),
    ("copying, locks, clocks (libc)", r"libc\.so|libstdc|vdso|libpthread"),
    ("rest of the program", r""),
]


def fail(asked, found, remedy):
    sys.exit(f"Error: asked for {asked}, found {found}. {remedy}.")


def part_of(stack):
    """Returns the part to which a sample belongs: its innermost frame says whether the kernel ran."""
    kernel = "[kernel" in stack[0]
    frames = [one for one in stack if ("[kernel" in one) == kernel]
    rules = KERNEL if kernel else USER
    for frame in frames:
        for name, pattern in rules[:-1]:
            if re.search(pattern, frame):
                return name
    return rules[-1][0]


def samples_of(script, program):
    """Yields the stacks of the measured program's two processes; the processor also ran others."""
    for block in script.split("\n\n"):
        lines = block.strip().splitlines()
        if len(lines) > 1 and program.startswith(lines[0].strip()[:15]):
            yield [line.split(maxsplit=1)[1] for line in lines[1:]]


def measure(bench, lane, folder):
    report, record = folder / "report.json", folder / "perf.data"
    command = [bench, "network", "--part", "round trips", "--lane", lane, "--json", report]
    perf = ["perf", "record", "--quiet", "-e", "cpu-clock", "-F", str(FREQUENCY), "-g", "-o", record, "--", *command]
    done = subprocess.run(perf, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        fail(f"a profile of {lane}", f"'{done.stderr.strip()}'", "See that perf may record: it needs root or kernel.perf_event_paranoid=-1")
    median = json.loads(report.read_text())["figures"][lane]["p50"]
    script = subprocess.run(["perf", "script", "-i", record, "-F", "comm,ip,sym,dso"], capture_output=True, text=True, check=True)
    return median, list(samples_of(script.stdout, bench.name))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bench", type=pathlib.Path, default=ROOT / "build/release/bin/suture-bench")
    parser.add_argument("lanes", nargs="*", default=LANES)
    arguments = parser.parse_args()
    if not arguments.bench.exists():
        fail(f"the program {arguments.bench}", "none", "Build it: cmake --preset release && cmake --build --preset release --target suture-bench")
    parts = [name for name, _ in USER + KERNEL]
    columns = {}
    with tempfile.TemporaryDirectory() as folder:
        for lane in arguments.lanes:
            median, stacks = measure(arguments.bench, lane, pathlib.Path(folder))
            columns[lane] = (median, [part_of(stack) for stack in stacks])
    print("| us of a round trip | " + " | ".join(columns) + " |\n|" + " --- |" * (len(columns) + 1))
    for part in parts:
        times = [f"{median * found.count(part) / len(found):.2f}" for median, found in columns.values()]
        print(f"| {part} | " + " | ".join(times) + " |")
    print("| **all** | " + " | ".join(f"**{median:.2f}**" for median, _ in columns.values()) + " |")


if __name__ == "__main__":
    main()
