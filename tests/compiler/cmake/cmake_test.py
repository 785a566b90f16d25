"""Builds scratch projects with suture_generate() and looks at what ran and what was rewritten."""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
CMAKE_FUNCTIONS = HERE.parents[2] / "compiler" / "cmake"

# A faulty call, and the words that tell what to do.
REFUSALS = [
    ("suture_generate(TARGET code HEADER a.h)", r"unknown argument 'HEADER.*it takes TARGET, HEADERS"),
    ("suture_generate(TARGET code HEADERS)", r"no HEADERS|'HEADERS' has no value"),
    ("suture_generate(HEADERS a.h)", r"no TARGET; name the library"),
    ("suture_generate(TARGET missing HEADERS a.h)", r"no target 'missing'; call it after add_library"),
    ("suture_generate(TARGET code::alias HEADERS a.h)", r"an alias; use the target itself, 'code'"),
    ("suture_generate(TARGET imported HEADERS a.h)", r"imported; its own project generates"),
    ("suture_generate(TARGET interface HEADERS a.h)", r"compiles nothing"),
    ("suture_generate(TARGET elsewhere HEADERS a.h)", r"belongs to .*below; call it there"),
    ("suture_generate(TARGET code HEADERS missing.h)", r"there is no header .*missing\.h"),
    ("suture_generate(TARGET code HEADERS b.hpp)", r"b\.hpp does not end with \.h"),
    ("suture_generate(TARGET code HEADERS a.h BASE_DIR below)", r"not below BASE_DIR"),
    ("set(SUTUREC_EXECUTABLE /nowhere/suturec)\nsuture_generate(TARGET code HEADERS a.h)",
     r"SUTUREC_EXECUTABLE '/nowhere/suturec' does not exist; give the path"),
    ("suture_generate(TARGET code HEADERS a.h)\nsuture_generate(TARGET code HEADERS a.h)",
     r"called twice for 'code'; give all HEADERS"),
    ("suture_generate(TARGET code HEADERS a.h)\nsuture_generate(TARGET other HEADERS a.h)",
     r"belongs to target 'code' already; link to that"),
]


def run(command, **options):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, **options)
    return done.returncode, done.stdout + done.stderr


def expect(condition, what, text=""):
    if not condition:
        sys.exit(f"FAILED: {what}\n{text}")
    print(f"ok: {what}")


class Project:
    """A copy of project/ with its build folder."""

    def __init__(self, arguments, name="a project", generator="Ninja"):
        self.root = pathlib.Path(arguments.scratch) / name
        self.generator = generator
        shutil.rmtree(self.root, ignore_errors=True)
        shutil.copytree(HERE / "project", self.root)
        self.build_folder = self.root / "build"
        self.settings = [f"-DSUTURE_CMAKE={CMAKE_FUNCTIONS}", "-DSUTURE_INCLUDES=" + ";".join(arguments.includes)]
        self.suturec = f"-DSUTUREC={arguments.suturec}"

    def configure(self, folder, *settings):
        status, text = run(["cmake", "-S", self.root, "-B", folder, "-G", self.generator, *self.settings, *settings])
        expect(status == 0, f"configures {folder.name}", text)

    def build(self, *targets):
        wanted = ["--target", *targets] if targets else []
        return run(["cmake", "--build", self.build_folder, "-j", "2", *wanted])

    def edit(self, file, old, new):
        path = self.root / file
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")

    def times(self):
        """When each generated file was written."""
        folders = [self.build_folder / "generated", self.build_folder / "generated-wire"]
        return {p: p.stat().st_mtime_ns for folder in folders for p in folder.rglob("*") if p.is_file()}


def is_idle(text):
    return not re.search(r"suturec (count|watch|one)|Building|Linking|capnp \w+/", text)


def runs_of_suturec(text):
    """Of the two targets, which both read the edited header."""
    return len(re.findall(r"\] suturec (count|watch)", text))


def check_first_build(project):
    status, text = project.build()
    expect(status != 0 and "[suture-lock-missing]" in text and "--target update-lock" in text,
           "without a lock the build stops and says what to run", text)
    expect(not any("count" in p.parts for p in project.times()), "a failed run writes nothing", str(project.times()))
    status, text = project.build("update-lock")
    expect(status == 0 and (project.root / "schemas/count/counter.capnp").exists(), "update-lock writes the lock", text)
    status, text = project.build()
    expect(status == 0, "builds", text)


def check_reruns(project):
    _, text = project.build()
    expect(is_idle(text), f"{project.generator}, no change: nothing runs", text)

    before = project.times()
    project.edit("count/sample.h", "namespace scratch {\n\n", "namespace scratch {\n\n// A plain comment.\n\n")
    _, text = project.build()
    expect(runs_of_suturec(text) == 2 and not re.search(r"capnp \w+/", text), "a comment edited: one run of suturec a target", text)
    expect(project.times() == before, "a comment edited: no generated file is rewritten")
    _, text = project.build()
    expect(is_idle(text), "and nothing runs after it", text)


def check_stale(project):
    """No generated file is ever read back, whatever it holds."""
    generated = project.build_folder / "generated/count/counter.suture.h"
    good = generated.read_text(encoding="utf-8")
    generated.write_text("#error stale\n", encoding="utf-8")
    (project.root / "watch/watch.h").touch()
    (project.root / "count/sample.h").touch()
    status, text = project.build()
    expect(status == 0 and generated.read_text(encoding="utf-8") == good, "a broken generated file is replaced", text)


def check_real_change(project):
    before = project.times()
    project.edit("count/sample.h", "double value = 0;", "double value = 0;\n  double weight = 1;")
    status, text = project.build()
    expect(status != 0 and "[suture-lock-new]" in text, "a new field: the build stops until the lock has it", text)
    expect(project.times() == before, "and writes nothing")
    status, text = project.build("update-lock")
    expect(status == 0, "update-lock takes the field", text)
    status, text = project.build()
    rewritten = {p.name for p, time in project.times().items() if before.get(p) != time}
    expect(status == 0 and "sample.suture.h" in rewritten and "sample.capnp.h" in rewritten,
           "the field is generated", text + str(rewritten))


def check_define(project):
    """A header sees the target's definitions: with another one, it is read again."""
    before = project.times()
    project.edit("count/sample.h", "double weight = 1;",
                 "double weight = 1;\n#ifdef SCRATCH_HEAVY\n  double extra = 0;\n#endif")
    status, text = project.build()
    expect(status == 0 and project.times() == before, "a field behind an undefined macro changes nothing", text)
    project.edit("CMakeLists.txt", "suture_generate(TARGET count",
                 "target_compile_definitions(count PRIVATE SCRATCH_HEAVY)\nsuture_generate(TARGET count")
    status, text = project.build()
    expect(status != 0 and "Sample::extra' is not in the lock" in text, "a changed define: suturec runs anew", text)
    project.edit("CMakeLists.txt", "target_compile_definitions(count PRIVATE SCRATCH_HEAVY)\n", "")
    status, text = project.build()
    expect(status == 0, "and again when it is taken back", text)


def check_added_header(project):
    (project.root / "count/more.h").write_text(
        "#pragma once\n#include <suture/annotate.h>\nnamespace scratch {\n"
        "struct SUTURE_TYPE() More { double value = 0; };\n}\n", encoding="utf-8")
    project.edit("CMakeLists.txt", "HEADERS count/sample.h", "HEADERS count/more.h count/sample.h")
    status, text = project.build("update-lock")
    expect(status == 0, "update-lock takes an added header", text)
    status, text = project.build()
    expect(status == 0 and any(p.name == "more.suture.h" for p in project.times()), "an added header is generated", text)


def check_failure(project):
    """One bad header of a target: nothing of the others is written, and nothing is half-written."""
    before = project.times()
    project.edit("count/sample.h", "namespace scratch {", "namespace scratch {\nint broken(")
    status, text = project.build()
    expect(status != 0 and project.times() == before, "suturec fails: all generated files stay", text)
    expect(not list(project.build_folder.rglob("*.tmp*")), "and no temporary file is left")
    project.edit("count/sample.h", "\nint broken(", "")
    status, text = project.build()
    expect(status == 0, "a repaired header builds", text)


def check_makefiles(arguments):
    project = Project(arguments, "with make", "Unix Makefiles")
    project.configure(project.build_folder, f"-DSUTUREC_EXECUTABLE={arguments.suturec}")
    status, text = project.build("update-lock")
    expect(status == 0, "Make, with SUTUREC_EXECUTABLE: update-lock", text)
    status, text = project.build()
    expect(status == 0, "Make: builds", text)
    check_reruns(project)
    check_failure(project)


def check_committed(project):
    def compare():
        return run(["ctest", "--test-dir", project.build_folder, "--output-on-failure", "-R", "check-generated"])

    status, text = compare()
    expect(status != 0 and "update-generated" in text, "check-generated fails before anything is committed", text)
    status, text = project.build("update-generated")
    expect(status == 0, "update-generated copies", text)
    status, text = compare()
    expect(status == 0, "check-generated passes on equal files", text)
    (project.root / "generated/count/old.suture.h").write_text("", encoding="utf-8")
    status, text = compare()
    expect(status != 0 and "count/old.suture.h is generated from no header" in text, "and names a left-over", text)
    (project.root / "generated/count/old.suture.h").unlink()


def check_without_suturec(project):
    folder = project.root / "without"
    project.configure(folder, "-DSUTUREC=")
    status, text = run(["ninja", "-C", folder])
    expect(status == 0 and "suturec" not in text, "without suturec it builds what is committed", text)
    (project.root / "generated/count/sample.suture.h").unlink()
    status, text = run(["cmake", folder])
    expect(status != 0 and "sample.suture.h must exist" in re.sub(r"\s+", " ", text), "and says what is missing", text)


def check_refusals(arguments):
    folder = pathlib.Path(arguments.scratch) / "refusals"
    folder.mkdir(exist_ok=True)
    case = folder / "case.cmake"
    for call, words in REFUSALS:
        case.write_text(call + "\n", encoding="utf-8")
        status, text = run(["cmake", "-S", HERE / "refusals", "-B", folder / "build", "-G", "Ninja",
                            f"-DSUTURE_CMAKE={CMAKE_FUNCTIONS}", f"-DCASE={case}"])
        found = re.search(words, re.sub(r"\s+", " ", text))
        expect(status != 0 and found, "refuses " + call.replace("\n", " and "), text)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--suturec", required=True)
    parser.add_argument("--includes", nargs="+", required=True)
    parser.add_argument("--scratch", required=True)
    arguments = parser.parse_args()
    check_refusals(arguments)
    project = Project(arguments)
    project.configure(project.build_folder, project.suturec)
    check_first_build(project)
    check_reruns(project)
    check_stale(project)
    check_real_change(project)
    check_define(project)
    check_added_header(project)
    check_failure(project)
    check_committed(project)
    check_without_suturec(project)
    check_makefiles(arguments)


if __name__ == "__main__":
    main()
