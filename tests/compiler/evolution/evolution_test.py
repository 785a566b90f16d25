"""What the lock allows works between versions; what it forbids is refused, or counted as a new major.

  evolution_test.py --suturec S --v1 PROGRAM --v2 PROGRAM --flags FLAGS
"""

import argparse
import concurrent.futures
import filecmp
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
HEADER = "evolution/sample.h"
LOCK = "schemas/evolution/sample.capnp"
CHOICE = "schemas/evolution/choice.capnp"

# Each row has a reader, a file, and what the reader makes of it.
READS = [
    ("v1", "v1", "count=-3 label='first' values=1,2, period=20 seen=99 pair=0.5,-1 point=4 5 6 x=1.5 gone=8 mode=On"),
    ("v2", "v1", "count=-3 label='first' values=1,2, period=20 seen=99 pair=0.5,-1 point=4 5 6 east=1.5 weight=2.5 "
                 "note='' mode=On"),
    ("v1", "v2", "count=11 label='second' values=7, period=30 seen=11 pair=2,3 point=7 8 9 x=-2.5 gone=0 mode=Off"),
    ("v2", "v2", "count=11 label='second' values=7, period=30 seen=11 pair=2,3 point=7 8 9 east=-2.5 weight=3 "
                 "note='new' mode=Off"),
    ("v2", "v2fast", "count=11 label='second' values=7, period=30 seen=11 pair=2,3 point=7 8 9 east=-2.5 weight=3 "
                     "note='new' mode=Fast"),
    ("v1", "v2fast", "refused"),
]

# These are the same for a Choice: an alternative that a reader does not know is refused, whatever else it is.
CHOICES = [
    ("v1", "v1choice", "value=1.500000 second=2.5 x=3 pace=fast"),
    ("v2", "v1choice", "value=1.500000 second=2.5 x=3 pace=fast"),
    ("v1", "v2choice", "value=1 second=none x=4 pace=fast"),
    ("v2", "v2choice", "value=1 second=none x=4 pace=fast"),
    ("v2", "v2newest", "value=7 second=none x=4 pace=fast"),
    ("v1", "v2newest", "refused"),
]

WRITES = [("v1", "write", "v1"), ("v2", "write", "v2"), ("v2", "write-fast", "v2fast"), ("v1", "write-choice", "v1choice"),
          ("v2", "write-choice", "v2choice"), ("v2", "write-newest", "v2newest")]

# Each row has an edit of the first header, and the words of the refusal.
BREAKS = [
    ("double x = 0;", "float x = 0;", "type Float32 instead of Float64"),
    ("std::int32_t count", "std::int64_t count", "type Int64 instead of Int32"),
    ('unit("m")', 'unit("mm")', 'unit "mm" instead of "m"'),
    ('SUTURE_FIELD(unit("m")) double x', "double x", 'unit none instead of "m"'),
    ("milliseconds", "microseconds", 'period "1/1000000" instead of "1/1000"'),
    ("steady_clock::time_point seen", "system_clock::time_point seen", 'clock "system" instead of "steady"'),
    ("std::array<float, 2> pair", "std::array<float, 3> pair", 'shape "3" instead of "2"'),
    ("Eigen::Vector3d point = Eigen::Vector3d::Zero()", "Eigen::Vector4d point = Eigen::Vector4d::Zero()",
     "type /suture/types.capnp:Vec4 instead of /suture/types.capnp:Vec3"),
    ("std::vector<double> values", "std::vector<float> values", "type List(Float32) instead of List(Float64)"),
    ("std::string label", "std::vector<std::uint8_t> label", "type Data instead of Text"),
    ("double speed) = 0", "float speed) = 0", "'speed': type Float32 instead of Float64"),
    (", double speed) = 0", ") = 0", "'speed' is gone"),
    ("Mode mode() const = 0", "Mode mode(double when) const = 0", 'kind "qualifiedRead" instead of "read"'),
    ("virtual void put(", "virtual Mode put(", None),  # refused before the lock is asked, or a kind of its own
    ("EventOf<Sample> moved_event", "EventOf<double> moved_event", "'value': type Float64 instead of Sample"),
]


class Failures(list):
    def expect(self, condition, what, text=""):
        if not condition:
            self.append(f"FAILED: {what}\n{text}")


def run(command, **options):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, **options)
    return done.returncode, done.stdout + done.stderr


def check_bytes(programs, failures):
    with tempfile.TemporaryDirectory() as folder:
        for version, what, stored in WRITES:
            written = pathlib.Path(folder) / stored
            run([programs[version], what, written])
            same = filecmp.cmp(written, HERE / "bytes" / f"{stored}.bin", shallow=False)
            failures.expect(same, f"{version} writes what it wrote when {stored}.bin was stored")
    for what, (reader, stored, words) in [("read", r) for r in READS] + [("read-choice", r) for r in CHOICES]:
        _, text = run([programs[reader], what, HERE / "bytes" / f"{stored}.bin"])
        failures.expect(text.strip() == words, f"{reader} reads {stored}.bin", f"expected {words}\ngot      {text}")


class Copy:
    """This is the first version in a folder of its own, to edit."""

    def __init__(self, folder, suturec, flags):
        self.root = pathlib.Path(folder) / "copy"
        self.suturec, self.flags = suturec, flags
        shutil.copytree(HERE / "v1", self.root)

    def edit(self, old, new):
        path = self.root / HEADER
        text = path.read_text(encoding="utf-8")
        assert old in text, old
        path.write_text(text.replace(old, new, 1), encoding="utf-8")

    def start(self, *options):
        return run([self.suturec, "--base-dir", ".", "--lock-dir", "schemas", *options, HEADER, "--", *self.flags],
                   cwd=self.root)

    def lock(self):
        return (self.root / LOCK).read_text(encoding="utf-8")


def check_break(suturec, flags, old, new, words, failures):
    what = f"'{old}' becomes '{new}'"
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(folder, suturec, flags)
        copy.edit(old, new)
        status, text = copy.start("--out", "out")
        failures.expect(status == 1 and not (copy.root / "out").exists(), f"{what}: the build stops", text)
        if words is None:
            return
        failures.expect("[suture-lock-break]" in text and words in text, f"{what}: is called a break", text)
        failures.expect(re.search(rf"^{HEADER}:\d+:\d+: error", text, re.M), f"{what}: names the header's line", text)
        failures.expect(re.search(rf"^{LOCK}:\d+:\d+: note: the lock has", text, re.M), f"{what}: and the lock's", text)
        status, text = copy.start("--update-lock", "--accept-break")
        lock = copy.lock()
        failures.expect(status == 0 and re.search(r'interface Feed .*\$Meta\.major\(2\)', lock),
                        f"{what}: accepted, it raises the major", text + lock)
        failures.expect(lock.count("$Meta.major(2)") == 1, f"{what}: of no other contract", lock)
        status, text = run([suturec, "diff", HERE / "v1" / LOCK, copy.root / LOCK])
        failures.expect(status == 1 and "breaks: " in text, f"{what}: diff knows it too", text)


def check_accepted(suturec, flags, failures):
    """A plain update refuses a break; an accepted one is in the self-description, which peers compare."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(folder, suturec, flags)
        before = copy.lock()
        copy.edit("double x = 0;", "float x = 0;")
        status, text = copy.start("--update-lock")
        failures.expect(status == 1 and copy.lock() == before, "an update refuses a break", text)
        copy.start("--update-lock", "--accept-break")
        status, text = copy.start("--out", "out")
        described = (copy.root / "out/evolution/sample.suture.json").read_text() if status == 0 else ""
        failures.expect('"major": 2' in described, "a build after an accepted break goes on, and says so", text)


def check_range(suturec, flags, failures):
    """Bytes mean what they meant, but it is not silent: the lock has to be written, without accepting a break."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(folder, suturec, flags)
        copy.edit("std::int32_t count", "SUTURE_FIELD(range(0, 10)) std::int32_t count")
        status, text = copy.start("--out", "out")
        failures.expect(status == 1 and "[suture-lock-range]" in text and not (copy.root / "out").exists(),
                        "a new range stops the build until the lock has it", text)
        failures.expect(re.search(rf"^{LOCK}:\d+:\d+: note: the lock has: count", text, re.M), "and names the lock's line", text)
        status, text = copy.start("--update-lock")
        failures.expect(status == 0 and "major" not in copy.lock(), "an update takes a new range, and it is no break", text)
        status, text = copy.start("--out", "out")
        failures.expect(status == 0, "then the build goes on", text)


def check_diff(suturec, failures):
    for lock in (LOCK, CHOICE):
        status, text = run([suturec, "diff", HERE / "v1" / lock, HERE / "v2" / lock])
        failures.expect(status == 0 and "breaks:" not in text, f"diff finds the second {lock} compatible", text)


def main():
    parser = argparse.ArgumentParser()
    for name in ("suturec", "v1", "v2", "flags"):
        parser.add_argument(f"--{name}", required=True)
    arguments = parser.parse_args()
    failures = Failures()
    check_bytes({"v1": arguments.v1, "v2": arguments.v2}, failures)
    check_diff(arguments.suturec, failures)
    flags = arguments.flags.split(";")
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(check, arguments.suturec, flags, failures) for check in (check_accepted, check_range)]
        jobs += [pool.submit(check_break, arguments.suturec, flags, *edit, failures) for edit in BREAKS]
        for job in jobs:
            job.result()
    print("\n".join(failures) or f"{len(READS) + len(CHOICES)} reads and {len(BREAKS)} breaks as expected")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
