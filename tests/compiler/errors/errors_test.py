"""Runs suturec on each questionable header of cases/ and compares everything that it prints.

  errors_test.py SUTUREC --flags FLAGS               the test; FLAGS, separated by semicolons, are for parsing
  errors_test.py SUTUREC --flags FLAGS --part P      one part of it: cases, fixes, usage or mutants
  errors_test.py SUTUREC --flags FLAGS --mutants N   the same with N mutated headers instead of 200
  errors_test.py SUTUREC --flags FLAGS --record      writes the .err files anew; read the difference before committing
"""

import argparse
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
CASES = HERE / "cases"
FIXES = HERE / "fixes"
PAGES = HERE.parents[2] / "docs" / "diagnostics"
COMPILER = HERE.parents[2] / "compiler"
SCHEMAS = HERE.parents[2] / "schemas"
TIME_LIMIT = 120  # seconds; a hang must end the test, the machine may be slow

# A slug stands in these forms in the compiler's sources.
SLUG_FORMS = [
    r'\b(?:error|errorAt|warn)\(\s*[\w.>-]+,\s*"([a-z-]+)"',
    r'addError\(\s*\w+,\s*[\w.>-]+,\s*"([a-z-]+)"',
    r'[\w.]*source, "([a-z-]+)",',
    r'TypeProblem\{\s*"([a-z-]+)"',
    r'\b(?:problem|reject)\(\s*"([a-z-]+)"',
    r'return \{\s*"([a-z-]+)"',
    r'\] = \{\s*"([a-z-]+)"',
    r"\[suture-([a-z-]+)\]",
    r'slug = "([a-z-]+)"',
    r'"(lock-[a-z-]+)"',
]


def run(suturec, flags, header, directory, out, include="../include"):
    """Returns exit status and messages. The lock folder of a case has its name."""
    command = [suturec, "--target-name", "cases", "--base-dir", ".", "--out", str(out),
               "--lock-dir", f"schemas/{header.stem}", header.name, "--", f"-I{include}", *flags]
    done = subprocess.run(command, cwd=directory, capture_output=True, encoding="utf-8", errors="replace",
                          timeout=TIME_LIMIT)
    return done.returncode, done.stdout + done.stderr


def check_case(suturec, flags, header, record):
    with tempfile.TemporaryDirectory() as out:
        status, text = run(suturec, flags, header, CASES, out)
        written = [str(p) for p in pathlib.Path(out).rglob("*")]
    expected = header.with_suffix(".err")
    if record:
        expected.write_text(text, encoding="utf-8")
    problems = []
    fails = "error:" in text
    if status != (1 if fails else 0):
        problems.append(f"exit status {status}")
    if fails and written:
        problems.append(f"wrote {written}")
    if not expected.exists() or text != expected.read_text(encoding="utf-8"):
        problems.append(f"printed this, which is not {expected.name}:\n{text}")
    return [f"{header.name}: {p}" for p in problems]


# These are in OUT before each command line of USAGE.
FILES = {"arm.suture.h": "", "first.rsp": "@second.rsp\n"}

# Each row has a faulty command line, run in cases/, and the words that must come.
USAGE = [
    ("--out OUT --lock-dir schemas", "headers is required"),
    ("--lock-dir schemas pointer.h", r"--out \(or --update-lock\) is required"),
    ("--out OUT pointer.h", "--lock-dir is required"),
    ("--out OUT --lock-dir schemas missing.h", "there is no header 'missing.h'; correct the path among the target's HEADERS"),
    ("--out OUT --lock-dir schemas ../include/suture/base/time.h", "is not below the base directory '.'"),
    ("--out OUT --lock-dir schemas pointer.err", "does not end with .h; rename it"),
    ("--out OUT --base-dir OUT --lock-dir schemas OUT/arm.suture.h", "is what suturec writes; name the header that it was written from"),
    ("--out OUT --base-dir ../include --lock-dir schemas ../include/suture/base/time.h", "declares nothing annotated; annotate it or take it off"),
    ("--out OUT --lock-dir schemas --resource-dir /nowhere pointer.h", 
     r"clang's own headers \(include/stddef.h\) are in none of these folders:\n  /nowhere\ninstall libclang-common-19-dev"),
    ("@missing.rsp", "cannot read the response file 'missing.rsp'; correct its path"),
    ("@OUT/first.rsp", "names another; write the arguments of that one into it"),
    ("--out OUT --lock-dir schemas --sources pointer.h=0 pointer.h", "'pointer.h=0' is not HEADER=N, where N is from 1 to 999"),
    ("--out OUT --lock-dir schemas --colour pointer.h", "was not expected: --colour"),
    ("--out OUT --lock-dir schemas --accept-break pointer.h", "--accept-break requires --update-lock"),
    ("--update-lock --lock-dir schemas/lock_new --new-id Nothing lock_new.h -- -I../include",
     "--new-id Nothing: no lock has anything of that name"),
    ("--explain pionter", "no diagnostic 'pionter'; did you mean 'pointer'?"),
    ("--explain suture-lock-brk", "no diagnostic 'lock-brk'; did you mean 'lock-break'?"),
    ("--explain foo", "no diagnostic 'foo'; a message of suturec ends with the name of its own"),
    ("--out OUT --lock-dir schemas/warnings --fatal platform-integer warnings.h -- -I../include",
     r"error: field 'size' .*\[suture-platform-integer\]"),
    ("--out OUT --lock-dir schemas/warnings --fatal all warnings.h -- -I../include", r"error: field 'whole'"),
    ("--out OUT --lock-dir schemas pointer.h -- -std=c++99", "invalid value 'c\\+\\+99'"),
]


# These are calls of suturec diff OLD NEW, each with the exit status and the words that must come. make_folders() makes OUT.
DIFFS = [
    ("schemas/lock_new/lock_new.capnp", 2, "new is required"),
    ("schemas/lock_new/lock_new.capnp missing.capnp", 2, "cannot read 'missing.capnp'"),
    ("schemas/lock_new/lock_new.capnp schemas/lock_syntax/lock_syntax.capnp", 2,
     r"lock_syntax.capnp:10: error: .*\[suture-lock-syntax\]"),
    ("schemas/lock_new schemas/lock_new/lock_new.capnp", 2, "one is a folder; name two files or two folders"),
    ("schemas/lock_syntax schemas/lock_new", 2, r"schemas/lock_syntax/lock_syntax.capnp:10: error: .*\[suture-lock-syntax\]"),
    ("schemas/lock_new schemas/lock_new", 0, "Nothing changed on the wire"),
    ("schemas/lock_new schemas/warnings", 1, "lock_new.capnp\n  breaks:  struct Sample is gone without a trace"),
    ("schemas/lock_new/lock_new.capnp schemas/lock_new/lock_new.capnp", 0, "Nothing changed on the wire"),
    ("schemas/lock_new/lock_new.capnp schemas/warnings/warnings.capnp", 1,
     "breaks:  struct Sample is gone without a trace\n(?s:.*)recordings of the old version do not work"),
    ("OUT/closed schemas/lock_new", 2, "error: cannot read the folder '.*/closed/inner': Permission denied"),
    ("OUT/loop schemas/lock_new", 2, "error: .*Too many levels of symbolic links .*/loop"),
    ("OUT/empty schemas/lock_new", 2, "of 0 files \\*.capnp below '.*/empty' none is a schema that suturec wrote; name the folder into"),
    ("schemas/lock_new OUT/others", 2, "of 1 files \\*.capnp below '.*/others' none is a schema that suturec wrote; name the folder into"),
    (f"{SCHEMAS} {SCHEMAS}", 0, "Nothing changed on the wire"),
]


def make_folders(out):
    for folder in ("closed/inner", "empty/inner", "others/suture"):
        (out / folder).mkdir(parents=True)
    (out / "closed/inner").chmod(0)
    (out / "loop").symlink_to("loop")
    shutil.copy(SCHEMAS / "suture/meta.capnp", out / "others/suture")


def check_diff(suturec, arguments, status, words):
    unable = ["setpriv", "--bounding-set=-dac_override,-dac_read_search"] if os.geteuid() == 0 else []  # as others are
    with tempfile.TemporaryDirectory() as out:
        make_folders(pathlib.Path(out))
        done = subprocess.run([*unable, suturec, "diff", *arguments.replace("OUT", out).split()], cwd=CASES,
                              capture_output=True, text=True, timeout=TIME_LIMIT)
        (pathlib.Path(out) / "closed/inner").chmod(0o700)
    text = done.stdout + done.stderr
    good = done.returncode == status and re.search(words, text)
    return [] if good else [f"suturec diff {arguments}: status {done.returncode}, no '{words}' in\n{text}"]


def check_version(suturec):
    """--version prints one line, with the version that CMake has."""
    project = (COMPILER.parent / "CMakeLists.txt").read_text(encoding="utf-8")
    expected = "suturec " + re.search(r"project\(Suture VERSION ([\d.]+)", project)[1] + "\n"
    done = subprocess.run([suturec, "--version"], capture_output=True, text=True, timeout=TIME_LIMIT)
    good = done.returncode == 0 and done.stdout == expected
    return [] if good else [f"suturec --version: status {done.returncode}, not {expected!r}:\n{done.stdout}{done.stderr}"]


def check_usage(suturec, arguments, words):
    with tempfile.TemporaryDirectory() as out:
        for name, text in FILES.items():
            (pathlib.Path(out) / name).write_text(text, encoding="utf-8")
        command = [suturec, *arguments.replace("OUT", out).split()]
        done = subprocess.run(command, cwd=CASES, capture_output=True, text=True, timeout=TIME_LIMIT)
        text = done.stdout + done.stderr
    good = done.returncode == 1 and re.search(words, text)
    return [] if good else [f"suturec {arguments}: status {done.returncode}, no '{words}' in\n{text}"]


# These are headers that no file of this tree can be. Each has its name, its bytes, and what is written for it: the
# ending of a file, and the words in it. Each is read twice, so that the lock of the first time is, too.
ODD_FILES = [
    ("my-arm.v2.h", b"struct SUTURE_TYPE() Goal { std::optional<double> x; };", "capnp", "struct MyArmV2OptionalFloat64 "),
    ("lines.h", b'struct SUTURE_TYPE(deprecated("use Aim\\ninstead")) Goal { double x = 0; };', "capnp",
     '$Meta.deprecated("use Aim\\ninstead")'),
    ("latin.h", b"struct SUTURE_TYPE() Goal {\n  double x = 0;  ///< 20\xb0 at most\n};", "suture.json", "20\u00b0 at most"),
]


def check_odd_file(suturec, flags, name, text, ending, words):
    with tempfile.TemporaryDirectory() as folder:
        header = pathlib.Path(folder) / name
        header.write_bytes(b"#pragma once\n#include <suture/annotate.h>\n#include <optional>\nnamespace demo {\n" + text + b"\n}\n")
        for action in ("--update-lock", "--out"):
            command = [suturec, action, *(["."] if action == "--out" else []), "--base-dir", ".", "--lock-dir", ".", name, "--",
                       f"-I{HERE}/include", *flags]
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=TIME_LIMIT)
            if done.returncode != 0:
                return [f"{name}: {action} gives status {done.returncode}\n{done.stdout}{done.stderr}"]
        written = header.with_suffix("." + ending).read_text(encoding="utf-8")
    return [] if words in written else [f"{name}: no '{words}' in\n{written}"]


def check_fix(suturec, flags, original, record):
    """Runs --fix until nothing is left to fix: that gives the .fixed file, which suturec then takes."""
    with tempfile.TemporaryDirectory() as folder:
        header = pathlib.Path(folder) / original.name
        header.write_bytes(original.read_bytes())

        def start(*options):
            command = [suturec, *options, "--base-dir", ".", "--lock-dir", "schemas", header.name, "--",
                       f"-I{HERE}/include", *flags]
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=TIME_LIMIT)
            return done.returncode, done.stdout + done.stderr

        rounds = [start("--fix"), start("--fix")]
        fixed = header.read_text(encoding="utf-8")
        status, text = start("--update-lock")
        if status == 0:
            status, text = start("--out", "out")
    expected = original.with_suffix(".fixed")
    if record:
        expected.write_text(fixed, encoding="utf-8")
    problems = []
    if "fixed " not in rounds[0][1]:
        problems.append(f"nothing was fixed:\n{rounds[0][1]}")
    if not expected.exists() or fixed != expected.read_text(encoding="utf-8"):
        problems.append(f"became this, which is not {expected.name}:\n{fixed}")
    if status != 0:
        problems.append(f"is still refused:\n{text}")
    return [f"fixes/{original.name}: {p}" for p in problems]


def check_page(suturec, page):
    """--explain prints the page; a test of the driver, not of the text."""
    done = subprocess.run([suturec, "--explain", page.stem], capture_output=True, text=True, timeout=TIME_LIMIT)
    text = page.read_text(encoding="utf-8")
    problems = [] if done.returncode == 0 and done.stdout == text else [f"--explain {page.stem} does not print its page"]
    if not text.startswith(f"# {page.stem}\n") or len(text.splitlines()) > 30:
        problems.append(f"{page.name} does not begin with its slug, or is too long")
    return problems


def check_slugs():
    """Every slug in the sources is shown by a case and explained by a page."""
    used = set()
    for source in COMPILER.rglob("*.cpp"):
        text = source.read_text(encoding="utf-8")
        for form in SLUG_FORMS:
            used.update(re.findall(form, text))
    shown = set()
    for case in CASES.glob("*.err"):
        shown.update(re.findall(r"\[suture-([a-z-]+)\]", case.read_text(encoding="utf-8")))
    yield from (f"no case shows [suture-{slug}]" for slug in sorted(used - shown))
    pages = {page.stem for page in PAGES.glob("*.md")} - {"README"}
    yield from (f"no page explains [suture-{slug}]" for slug in sorted(used - pages))
    yield from (f"docs/diagnostics/{slug}.md explains what no source has" for slug in sorted(pages - used))
    yield from (f"[suture-{slug}] is shown but no source has it" for slug in sorted(shown - used))


def mutated(text, random_source):
    """Returns a header after an accident: bytes dropped, doubled or replaced."""
    text = bytearray(text)
    for _ in range(random_source.randint(1, 6)):
        place = random_source.randrange(len(text))
        length = random_source.randint(1, 12)
        action = random_source.randrange(3)
        if action == 0:
            del text[place:place + length]
        elif action == 1:
            text[place:place] = text[place:place + length]
        else:
            text[place] = random_source.randrange(256)
    return bytes(text)


def check_mutation(suturec, flags, seed):
    """Whatever the header, suturec ends by itself with 0 or 1."""
    random_source = random.Random(seed)
    original = random_source.choice(sorted(CASES.glob("*.h")))
    with tempfile.TemporaryDirectory() as folder:
        header = pathlib.Path(folder) / original.name
        header.write_bytes(mutated(original.read_bytes(), random_source))
        try:
            status, text = run(suturec, flags, header, folder, pathlib.Path(folder) / "out", HERE / "include")
        except subprocess.TimeoutExpired:
            return [f"seed {seed} ({original.name}): no end within {TIME_LIMIT} s"]
    return [] if status in (0, 1) else [f"seed {seed} ({original.name}): exit status {status}\n{text}"]


def runs(part, suturec, flags, record, mutants):
    """Returns the runs, each a function and its arguments."""
    if part == "cases":
        return [(check_case, suturec, flags, h, record) for h in sorted(CASES.glob("*.h"))] + [(check_slugs,)]
    if part == "fixes":
        return [(check_fix, suturec, flags, h, record) for h in sorted(FIXES.glob("*.h"))]
    if part == "usage":
        pages = sorted(p for p in PAGES.glob("*.md") if p.stem != "README")
        return ([(check_version, suturec)] + [(check_page, suturec, p) for p in pages]
                + [(check_usage, suturec, *usage) for usage in USAGE]
                + [(check_diff, suturec, *diff) for diff in DIFFS]
                + [(check_odd_file, suturec, flags, *file) for file in ODD_FILES])
    return [(check_mutation, suturec, flags, seed) for seed in range(mutants)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("suturec")
    parser.add_argument("--flags", required=True, type=lambda flags: flags.split(";"))
    parser.add_argument("--part", action="append", choices=["cases", "fixes", "usage", "mutants"])
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--mutants", type=int, default=200)
    options = parser.parse_args()
    parts = ["cases", "fixes"] if options.record else options.part or ["cases", "fixes", "usage", "mutants"]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(*run) for part in parts
                for run in runs(part, options.suturec, options.flags, options.record, options.mutants)]
        problems = [p for job in jobs for p in job.result()]
    print("\n".join(problems) or f"{len(jobs)} runs as expected")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
