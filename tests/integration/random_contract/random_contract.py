"""Builds and runs a contract of random types across two processes, as a foreign project would."""

import argparse
import contextlib
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile

import random_types

CMAKE = """cmake_minimum_required(VERSION 3.25)
project(Invented LANGUAGES C CXX)
find_package(Suture REQUIRED)
add_compile_options(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
add_executable(invented main.cpp)
suture_generate(TARGET invented HEADERS invented.h)
"""


def run(command, **options):
    print("+", " ".join(map(str, command)), flush=True)
    subprocess.run(list(map(str, command)), check=True, **options)


def build(project, suture, compiler="g++"):
    # __FILE__ would have the folder's name, which is another in each run, and ccache would find nothing.
    run(["cmake", "-S", project, "-B", project / "build", "-G", "Ninja", "--log-level=WARNING",
         f"-DCMAKE_CXX_FLAGS=-ffile-prefix-map={project}=.",
         f"-DSuture_DIR={suture}", f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_STANDARD=20", "-DCMAKE_UNITY_BUILD=ON"])
    run(["cmake", "--build", project / "build", "--target", "update-lock"])
    run(["cmake", "--build", project / "build", "-j2"])


def call_across_processes(project, suture, seed, server_program=None):
    """Calls `server_program`, an older one than the client, which lacks what is optional."""
    address = f"unix:{project}/manager.sock"
    program = project / "build" / "invented"
    verb = "call-older" if server_program else "call"
    started = []

    def start(*command, **options):
        process = subprocess.Popen(list(map(str, command)), **options)
        started.append(process)
        return process

    try:
        manager = start(suture / "bin" / "suture-manager", "--listen", address, stdout=subprocess.PIPE, text=True)
        assert "ready" in manager.stdout.readline()
        server = start(server_program or program, "serve", address, seed)
        run([program, verb, address, seed], timeout=60)
        assert server.poll() is None, "the server died"
        server.send_signal(signal.SIGTERM)
        assert server.wait(timeout=20) == 0, "the server did not end cleanly"
    finally:
        for process in started:
            if process.poll() is None:
                process.send_signal(signal.SIGTERM)
        for process in started:
            process.wait(timeout=20)


@contextlib.contextmanager
def project():
    """Returns the options of a test of random headers, and the folder of its project, gone at the end."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--suture", type=pathlib.Path, required=True, help="build folder of Suture")
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1 << 30))
    parser.add_argument("--keep", type=pathlib.Path, help="write the project here and leave it")
    options = parser.parse_args()
    print(f"seed {options.seed}", flush=True)
    folder = options.keep or pathlib.Path(tempfile.mkdtemp(prefix="random_", dir=options.suture))
    folder.mkdir(parents=True, exist_ok=True)
    try:
        yield options, folder
    finally:
        if options.keep is None:
            shutil.rmtree(folder, ignore_errors=True)


def main():
    with project() as (options, folder):
        suture = options.suture.resolve()
        types = random_types.Types(options.seed)
        shutil.copy(pathlib.Path(__file__).with_name("values.h"), folder)
        (folder / "CMakeLists.txt").write_text(CMAKE)
        (folder / "main.cpp").write_text(types.program())

        def write_types():
            (folder / "invented.h").write_text(types.header())
            (folder / "invented_values.h").write_text(types.values())

        write_types()
        build(folder, suture)
        call_across_processes(folder, suture, options.seed)

        # This adds a field: one header is edited, and update-lock runs.
        types.structs["Record4"].append(random_types.Field("added", "Eigen::Vector3d"))
        write_types()
        build(folder, suture)
        call_across_processes(folder, suture, options.seed)

        # Optional commands more: the new client works with the old server.
        older = shutil.copy(folder / "build" / "invented", folder / "invented-older")
        types.optional = True
        write_types()
        (folder / "main.cpp").write_text(types.program())
        build(folder, suture)
        call_across_processes(folder, suture, options.seed)
        call_across_processes(folder, suture, options.seed, older)


if __name__ == "__main__":
    os.environ.pop("CXXFLAGS", None)
    sys.exit(main())
