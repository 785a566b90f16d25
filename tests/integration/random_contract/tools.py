"""Takes random headers through the tools: suturec, Cap'n Proto, two compilers, and values through slots and messages."""

import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
TIME_LIMIT = 600  # s; a hang is a failure, and the machine may be slow
COMPILERS = ("g++", "clang++")
LAUNCHER = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER")


class Failure(Exception):
    """Says which tool failed, and how it failed: what is reduced has to fail in the same way."""

    def __init__(self, stage, way, text):
        super().__init__(f"{stage} {way}")
        self.stage, self.way, self.text = stage, way, text

    def is_like(self, other):
        return other is not None and (self.stage, self.way) == (other.stage, other.way)


class Tools:
    """Runs them for the headers of one batch, all together, in a folder of its own."""

    def __init__(self, suture):
        found = json.loads((suture / "tests/integration/random_contract/tools.json").read_text(encoding="utf-8"))
        self.found = found
        folders = [folder for folder in dict.fromkeys(found["includes"]) if folder != "/usr/include"]  # that is there anyway
        self.includes = [f"-isystem{folder}" for folder in folders]
        self.imports = [f"-I{folder}" for folder in folders]

    def failure_of(self, headers, folder, until="round trip"):
        """Returns how these headers fail, None if they do not. No tool runs behind the stage `until`, and no compiler beside it."""
        try:
            self.try_headers(headers, folder, until)
        except Failure as failure:
            return failure
        return None

    def try_headers(self, headers, folder, until):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for header in headers:
            (folder / f"{header.name}.h").write_text(header.header(), encoding="utf-8")
        self.generate(headers, folder)
        if until == "suturec":
            return
        (folder / "wire").mkdir()
        self.run("capnp", folder, [self.found["capnp"], "compile", f"-o{self.found['capnpc-c++']}:wire", "--src-prefix", "out",
                                   "-Iout", *self.imports, *(f"out/{header.name}.capnp" for header in headers)])
        if until == "capnp":
            return
        for name in ("values.h", "round_trip.h"):
            shutil.copy(HERE / name, folder)
        (folder / "main.cpp").write_text(program(headers), encoding="utf-8")
        (folder / "wire.cpp").write_text("".join(f'#include "{header.name}.capnp.c++"\n' for header in headers), encoding="utf-8")
        jobs = [(compiler, "main") for compiler in COMPILERS if until in (compiler, "round trip")]
        if until == "round trip":
            jobs.append(("g++", "wire"))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for done in [pool.submit(self.compile, folder, *job) for job in jobs]:
                done.result()
            if until == "round trip":
                for done in [pool.submit(self.take_values_through, folder, compiler) for compiler in COMPILERS]:
                    done.result()

    def generate(self, headers, folder):
        """The lock is written first, as `update-lock` does."""
        common = [self.found["suturec"], "--target-name", "random", "--base-dir", ".", "--lock-dir", "schemas",
                  *(f"{header.name}.h" for header in headers)]
        clang = ["--", "-std=c++20", *self.found["parse"], *self.includes]
        for mode in (["--update-lock"], ["--out", "out"]):
            self.run("suturec", folder, [*common, *mode, *clang])

    def compile(self, folder, compiler, unit):
        program = self.found["clang++"] if compiler == "clang++" else compiler
        own = ["-w"] if unit == "wire" else WARNINGS
        self.run(compiler, folder, [*filter(None, [LAUNCHER]), program, "-std=c++20", *own, "-I.", "-Iout", "-isystemwire", *self.includes,
                                    "-c", f"{unit}.cpp", "-o", f"{unit}.{compiler}.o"])

    def take_values_through(self, folder, compiler):
        program = f"trip.{compiler}"
        self.run("linker", folder, ["g++", "-fuse-ld=mold", "-o", program, f"main.{compiler}.o", "wire.g++.o", "-Wl,--start-group",
                                    *self.found["libraries"], "-Wl,--end-group", "-lcapnp-rpc", "-lcapnp", "-lkj-async", "-lkj",
                                    "-lssl", "-lcrypto", "-lpthread", "-ldl"])
        self.run("round trip", folder, [f"./{program}"])

    def run(self, stage, folder, command):
        try:
            done = subprocess.run([str(part) for part in command], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  encoding="utf-8", errors="replace", timeout=TIME_LIMIT, check=False,
                                  env={**os.environ, "PWD": str(folder)})
        except subprocess.TimeoutExpired:
            raise Failure(stage, "does not end", "") from None
        if done.returncode != 0:
            raise Failure(stage, way_of(stage, done.returncode, done.stdout), done.stdout)


def way_of(stage, status, text):
    """Returns how a tool failed: suturec's diagnostics have slugs, a compiler's first
    error counts without the names in it, and a check of values says what was not as it should be."""
    if status < 0 or "internal compiler error" in text or "PLEASE submit a bug report" in text:
        return "crashes"
    if stage == "round trip":
        return f"differs: {text.strip().rpartition(': ')[2]}"
    slugs = sorted(set(re.findall(r"error: .*\[(suture-[a-z-]+)\]", text)))
    if slugs:
        return f"refuses it: {', '.join(slugs)}"
    first = re.search(r"error: (.*)", text)
    return "says: " + re.sub(r"['‘][^'’]*['’]|\d+", "_", first[1] if first else text[:100])


def program(headers):
    """Returns one unit of all: what suturec wrote, and the checks."""
    lines = [f'#include "{header.name}.suture.h"' for header in headers]
    # round_trip.h finds what compares a struct where it is called, what converts it by the namespace of its slot.
    lines += ['#include "values.h"', *(header.values() for header in headers), '#include "round_trip.h"']
    lines += [f'#include "{header.name}.capnp.h"' for header in headers]
    lines += [header.conversions() for header in headers]
    lines += ["namespace invented {", *(header.checks() for header in headers), "}  // namespace invented"]
    lines += [f'#include "{header.name}.{kind}.cpp"' for header in headers for kind in ("suture", "wire")]
    lines += ["int main() {", *(f"  {{ invented::Random random({header.name[1:]}); invented::check_{header.name}(random); }}" for header in headers),
              "  return 0;", "}", ""]
    return "\n".join(lines)
