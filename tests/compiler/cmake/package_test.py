"""Tests Suture as a package: what is installed, and projects that use it: package_test.py SCENARIO --package P ..."""

import argparse
import os
import pathlib
import re
import shutil

from scratch import HERE, TREE, Project, empty, expect, install, run, succeed

CONTRACT = ("counter.h", "counter.capnp")
PARTS = ("tally.h", "clicker.h", "main.cpp")


def consumer(arguments, kind, *files):
    """Returns a project of consumers/ with files of the counter example."""
    root = empty(arguments.scratch / f"{arguments.scenario} {kind}")
    shutil.copytree(HERE / "consumers" / kind, root, dirs_exist_ok=True)
    for file in files:
        source, folder = ("schemas", "schemas/01_counter") if file.endswith(".capnp") else ("examples", "01_counter")
        (root / folder).mkdir(parents=True, exist_ok=True)
        shutil.copy(TREE / source / "01_counter" / file, root / folder)
    return Project(root, arguments.package)


def counts(folder):
    text = succeed("the counter runs", [folder / "01_counter"])
    expect(re.search(r"^passed \d+$", text, re.M), "provider and client talk", text)


def sees_no_capnp(project):
    """Expects that main.cpp includes no header of capnp, as ninja has recorded its headers."""
    text = succeed("ninja tells the headers", ["ninja", "-C", project.build_folder, "-t", "deps"])
    headers = next(block for block in text.split("\n\n") if "main.cpp.o:" in block)
    expect("counter.suture.h" in headers, "main.cpp includes generated code", headers)
    expect(not re.search(r"/(capnp|kj)/|\.capnp\.h", headers), "and no header of capnp or kj", headers)
    expect(f"{TREE}/runtime/" not in headers, "and none of Suture's tree", headers)


def one_target(arguments):
    project = consumer(arguments, "one", *CONTRACT, *PARTS)
    project.configure()
    project.must_build("builds contract, provider and client in one target")
    counts(project.build_folder)
    sees_no_capnp(project)


def two_targets(arguments):
    project = consumer(arguments, "two", *CONTRACT, *PARTS)
    project.configure()
    project.must_build("builds a contract and its users in two targets")
    counts(project.build_folder)


def shared_library(arguments):
    project = consumer(arguments, "two", *CONTRACT, *PARTS)
    project.configure("-DBUILD_SHARED_LIBS=ON")
    project.must_build("builds the contract as a shared library")
    expect((project.build_folder / "libcontract.so").exists(), "which is there")
    counts(project.build_folder)


def installed_contract(arguments):
    contract = consumer(arguments, "contract", *CONTRACT)
    contract.configure()
    contract.must_build("builds a contract alone")
    prefix = arguments.scratch / "contract_prefix"
    install(contract.build_folder, prefix)
    shutil.rmtree(contract.root)
    project = consumer(arguments, "client", *PARTS)
    project.configure(f"-DContract_DIR={prefix}/lib/cmake/Contract")
    project.must_build("builds provider and client of an installed contract")
    counts(project.build_folder)


def folders(arguments):
    """Builds targets whose include roots are one below the other, so one root alone does not tell the path of a header."""
    project = consumer(arguments, "folders")
    project.configure()
    project.must_build("update-lock", "update-lock")
    lock = (project.root / "schemas/grasp.capnp").read_text(encoding="utf-8")
    expect('import "/robot/force.capnp"' in lock, "a header below imports one above by the include root of that one", lock)
    lock = (project.root / "schemas/cell/cell.capnp").read_text(encoding="utf-8")
    expect('import "/grasp.capnp"' in lock, "and a header above one below", lock)
    project.must_build("builds with the include root that each target has by default")


def robots(arguments):
    """Builds a project with a package in a folder whose name has a space."""
    spaced = arguments.scratch / "a prefix"
    shutil.rmtree(spaced, ignore_errors=True)
    arguments.package = shutil.copytree(arguments.package, spaced, symlinks=True)
    project = consumer(arguments, "robots")
    project.configure()
    project.must_build("update-lock", "update-lock")
    lock = (project.root / "schemas/grasp/grasp.capnp").read_text(encoding="utf-8")
    expect('import "/robot_types/pose.capnp"' in lock, "the user's schema imports an installed one", lock)
    project.must_build("builds a type on top of suture::robots")
    expect(succeed("it runs", [project.build_folder / "grasp"]) == "2 N\n", "with the installed kinematics")


def missing_headers(include):
    """Returns what headers of the package include of it and do not find, as it is written there."""
    roots = [include, include / "suture-robots"]
    missing = set()
    for header in include.rglob("*.h"):
        for name in re.findall(r'^#include ["<](suture/[^">]+\.h|[^">]+\.suture\.h)[">]', header.read_text(encoding="utf-8"), re.M):
            if not any((root / name).exists() for root in roots):
                missing.add(name)
    return sorted(missing)


def dead_links(prefix):
    """Returns the relative links of installed documents that lead to nothing there; a folder is something to read by its README."""
    dead = []
    for page in prefix.rglob("*.md"):
        text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
        for link in re.findall(r"\]\(([^)\s#]+)", text):
            to = page.parent / link
            if not re.match(r"[a-z]+:", link) and not (to / "README.md" if to.is_dir() else to).exists():
                dead.append(f"{page.relative_to(prefix)} leads to {link}")
    return sorted(dead)


def is_script(file):
    with file.open("rb") as begin:
        return begin.read(2) == b"#!"


def installed_tree(arguments):
    prefix = arguments.package
    for program in ("suturec", "suture", "suture-manager", "suture-workstation", "suture-demo"):
        text = succeed(f"{program} starts", [prefix / "bin" / program, "--help"])
    expect("  fig3c " in text, "the demo finds its topologies", text)
    ours = [file for ending in ("cmake", "h", "capnp", "md") for file in prefix.rglob(f"*.{ending}")
            if "clang" not in file.parts]
    build_folders = (f"{TREE}/", f"{arguments.build}", f"{prefix} at first")
    strangers = [file for file in ours if any(folder in file.read_text(encoding="utf-8") for folder in build_folders)]
    expect(ours and not strangers, "no file of the package names a folder of the build", str(strangers))

    expect(not dead_links(prefix), "installed documents lead to what is installed", "\n".join(dead_links(prefix)))
    scripts = [file for file in (prefix / "share").rglob("*") if file.is_file() and is_script(file)]
    unready = [str(file) for file in scripts if not os.access(file, os.X_OK)]
    expect(scripts and not unready, "installed scripts can be run", str(unready))
    text = succeed("the demo's script starts", [prefix / "share/doc/suture/examples/demo.sh", "--compare", "fig3a", "fig3b"])
    expect("fig3b" in text, "and runs the installed demo", text)

    missing = missing_headers(prefix / "include")
    expect(not missing, "each header that an installed one includes is installed", str(missing))

    root = empty(arguments.scratch / "without C")
    (root / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(x LANGUAGES CXX)\n"
                                         "find_package(Suture REQUIRED)\n", encoding="utf-8")
    status, text = run(["cmake", "-S", root, "-B", root / "build", f"-DCMAKE_PREFIX_PATH={prefix}"])
    expect(status != 0 and "LANGUAGES C CXX" in text, "find_package tells a project without C what to do", text)


def capnproto(arguments):
    """Finds Cap'n Proto once more behind Suture, and in a folder below; its own package fails where it is found twice."""
    root = empty(arguments.scratch / "capnproto behind")
    find = "find_package(Suture REQUIRED)\nfind_package(CapnProto 0.9 REQUIRED)\nfind_package(CapnProto REQUIRED)\n"
    (root / "below").mkdir()
    (root / "below/CMakeLists.txt").write_text(find, encoding="utf-8")
    (root / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(behind LANGUAGES C CXX)\n"
                                         f"add_subdirectory(below)\n{find}", encoding="utf-8")
    project = Project(root, arguments.package)

    def found_in():
        cache = (project.build_folder / "CMakeCache.txt").read_text(encoding="utf-8")
        return pathlib.Path(re.search(r"^CapnProto_DIR:PATH=(.*)$", cache, re.M).group(1))
    project.configure()
    own = shutil.copytree(found_in(), root / "own")
    project.configure(f"-DCapnProto_DIR={own}")
    project.configure()
    expect(found_in() == own, "the package of Cap'n Proto that a user names stays the one", str(found_in()))


def default_build(arguments):
    """Asks what a build for use makes of Suture without being told a target: nothing that is only for its development."""
    build = empty(arguments.scratch / "default build")
    succeed("configures Suture without tests", ["cmake", "-S", TREE, "-B", build, "-G", "Ninja", "-DSUTURE_BUILD_TESTS=OFF"])

    def makes(target):
        return succeed(f"ninja tells what {target} needs", ["ninja", "-C", build, "-t", "inputs", target])
    made = makes("all")
    expect("/suture-demo.dir/demo.cpp.o" in made, "a build makes what is installed", made)
    bench = [file for file in made.splitlines() if file.startswith("tests/bench/")]
    expect(not bench, "and no benchmark", "\n".join(bench[:5]))
    measured = makes("suture-bench")
    expect("components/robots.suture.stamp" in measured and "bin/empty-consumer" in measured,
           "the target suture-bench makes all that it measures", measured)


def shared_cross_build(arguments):
    """Builds Suture itself, shared and without LLVM, as for another machine: by the suturec of this one."""
    build = empty(arguments.scratch / "shared cross build")
    succeed("configures Suture, shared, with SUTUREC_EXECUTABLE",
            ["cmake", "-S", TREE, "-B", build, "-G", "Ninja", "-DBUILD_SHARED_LIBS=ON", "-DCMAKE_BUILD_TYPE=Debug",
             "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DSUTURE_BUILD_COMPILER=OFF", "-DSUTURE_BUILD_TESTS=OFF",
             f"-DSUTUREC_EXECUTABLE={arguments.package}/bin/suturec",
             "-DCMAKE_SYSTEM_NAME=Linux", f"-DCMAKE_SYSTEM_PROCESSOR={os.uname().machine}"])
    text = succeed("builds it", ["cmake", "--build", build, "-j", "2", "--target", "suture-manager", "suture_cli",
                                 "suture_testing", "01_counter"])
    expect("suturec 01_counter" in text and not (build / "bin/suturec").exists(), "with the given suturec", text[-2000:])
    libraries = succeed("readelf", ["readelf", "-d", build / "bin/01_counter"])
    expect("libsuture_manager.so" in libraries, "as shared libraries", libraries)
    counts(build / "bin")
    install(build, arguments.scratch / "a shared prefix", "--component", "suture")
    shutil.rmtree(build)  # none of its libraries can be found any more


def shared_package(arguments):
    given = arguments.package / "bin/suturec"
    arguments.package = arguments.scratch / "a shared prefix"
    expect(not (arguments.package / "bin/suturec").exists(), "the package has no suturec")
    succeed("suture-manager finds its libraries", [arguments.package / "bin/suture-manager", "--help"])
    project = consumer(arguments, "one", *CONTRACT, *PARTS)
    project.configure(f"-DSUTUREC_EXECUTABLE={given}")
    project.must_build("builds with the suturec of another package")
    counts(project.build_folder)


def without_suturec(arguments):
    """Without LLVM a build compiles what is committed."""
    project = consumer(arguments, "one", *CONTRACT, *PARTS)
    project.configure()
    project.must_build("update-generated", "update-generated")
    folder = project.root / "without"
    project.package = arguments.scratch / "a shared prefix"
    project.configure(folder=folder)
    status, text = project.build(folder=folder)
    expect(status == 0 and "suturec" not in text, "without suturec it builds what is committed", text)
    counts(folder)
    (project.root / "generated/01_counter/tally.suture.h").unlink()
    status, text = run(["cmake", folder])
    expect(status != 0 and "tally.suture.h must exist" in re.sub(r"\s+", " ", text), "and says what is missing", text)


SCENARIOS = {scenario.__name__: scenario for scenario in (
    installed_tree, one_target, two_targets, shared_library, installed_contract, folders, robots, capnproto,
    default_build, shared_cross_build, shared_package, without_suturec)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scenario", choices=["install", *SCENARIOS])
    parser.add_argument("--build", type=pathlib.Path, help="build folder of Suture")
    parser.add_argument("--package", type=pathlib.Path, required=True, help="where it is installed")
    parser.add_argument("--scratch", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    if arguments.scenario == "install":
        install(arguments.build, arguments.package)
    else:
        SCENARIOS[arguments.scenario](arguments)


if __name__ == "__main__":
    main()
