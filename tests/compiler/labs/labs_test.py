"""Headers as robot labs have them, unedited, in a project of its own: built by two compilers, and values taken through.

  labs_test.py --suture BUILD [--seed N] [--keep DIR]
"""

import os
import pathlib
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
SHARED = HERE.parents[1] / "integration" / "random_contract"
sys.path.insert(0, str(SHARED))

import random_contract


def configure(folder, suture, compiler):
    """Configures as random_contract.build() does, in a build folder of the compiler's name."""
    random_contract.run(
        ["cmake", "-S", folder, "-B", folder / compiler, "-G", "Ninja", "--log-level=WARNING", f"-DSuture_DIR={suture}",
         f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS=-ffile-prefix-map={folder}=.", "-DCMAKE_CXX_STANDARD=20",
         "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=9"])
    return folder / compiler


def main():
    with random_contract.project() as (options, folder):
        suture = options.suture.resolve()
        shutil.copytree(HERE / "project", folder, dirs_exist_ok=True)
        for name in ("values.h", "round_trip.h"):
            shutil.copy(SHARED / name, folder / "values")
        # The second compiler finds the lock as the first has left it.
        first, second = (configure(folder, suture, compiler) for compiler in ("g++", "clang++-19"))
        random_contract.run(["cmake", "--build", first, "--target", "update-lock"])
        for build in (first, second):
            random_contract.run(["cmake", "--build", build, "-j2"])
            random_contract.run([build / "labs", options.seed], timeout=120)


if __name__ == "__main__":
    os.environ.pop("CXXFLAGS", None)
    sys.exit(main())
