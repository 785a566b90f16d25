"""Scratch projects: what every test here starts, says and looks at."""

import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TREE = HERE.parents[2]


def run(command, **options):
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False, **options)
    return done.returncode, done.stdout


def expect(condition, what, text=""):
    if not condition:
        sys.exit(f"FAILED: {what}\n{text}")
    print(f"ok: {what}", flush=True)


def succeed(what, command, **options):
    status, text = run(command, **options)
    expect(status == 0, what, text)
    return text


def empty(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def install(build, prefix, *options):
    """Installs into a folder that is then renamed, since nothing may remember where it was put."""
    first = prefix.with_name(prefix.name + " at first")
    for folder in (first, prefix):
        shutil.rmtree(folder, ignore_errors=True)
    succeed(f"installs {build.name}", ["cmake", "--install", build, "--prefix", first, *options])
    first.rename(prefix)


class Project:
    """This is a project in a folder of its own, whose path has a space, with its build folder."""

    def __init__(self, root, package, generator="Ninja"):
        self.root = root
        self.generator = generator
        self.build_folder = root / "build"
        self.package = package

    def configure(self, *settings, folder=None):
        folder = folder or self.build_folder
        succeed(f"configures {folder.name}",
                ["cmake", "-S", self.root, "-B", folder, "-G", self.generator,
                 f"-DCMAKE_PREFIX_PATH={self.package}", *settings])

    def build(self, *targets, folder=None):
        wanted = ["--target", *targets] if targets else []
        return run(["cmake", "--build", folder or self.build_folder, "-j", "2", *wanted])

    def must_build(self, what, *targets):
        status, text = self.build(*targets)
        expect(status == 0, what, text)
        return text

    def edit(self, file, old, new):
        path = self.root / file
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")

    def times(self):
        """Returns when each generated file was written."""
        folders = [self.build_folder / "generated", self.build_folder / "generated-wire"]
        return {p: p.stat().st_mtime_ns for folder in folders for p in folder.rglob("*") if p.is_file()}


def is_idle(text):
    return not re.search(r"suturec \w+|Building|Linking|capnp \w+/", text)


def runs_of_suturec(text):
    return re.findall(r"\] suturec (\w+)", text)
