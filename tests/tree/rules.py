"""Checks what the tree promises. Prints each violation; exit status 1 if there is any."""

import pathlib
import re
import shutil
import subprocess
import sys

# Each layer may include itself and what stands before it.
LAYERS = ["base", "rt", "component", "wiring", "transport", "standard", "manager", "deploy", "observe", "record", "testing", "cli"]
PARALLEL = {"deploy", "observe", "record", "testing"}
# Standard contracts that the layers below speak of count as the lowest, and see no more than that.
BASIC_CONTRACTS = {"lifecycle.h"}
SOURCES = {".h", ".cpp"}
INCLUDE = re.compile(r'^\s*#include\s+[<"]([^>"]+)[>"]', re.M)
MAX_LINES = 700
MAX_README_LINES = 40


def sources(root, folder):
    base = root / folder
    return sorted(p for p in base.rglob("*") if p.suffix in SOURCES) if base.exists() else []


def includes(path):
    return INCLUDE.findall(path.read_text(encoding="utf-8"))


def layer_of(folder, name):
    """Of a header <suture/folder/name>."""
    return LAYERS[0] if folder == "standard" and name in BASIC_CONTRACTS else folder


def layer_of_file(path):
    """runtime/contracts/ is an include root of its own, that of <suture/standard/...>."""
    folder = path.parts[0]
    return layer_of("standard" if folder == "contracts" else folder, path.name)


def layer_of_include(include):
    parts = include.split("/")
    return layer_of(parts[1], parts[-1]) if parts[0] == "suture" and len(parts) > 2 and parts[1] in LAYERS else None


def may_include(layer, other):
    if layer == other:
        return True
    if layer in PARALLEL and other in PARALLEL:
        return layer == "deploy"  # runs what the other two offer
    return LAYERS.index(other) < LAYERS.index(layer)


def check_layers(root):
    for path in sources(root, "runtime"):
        layer = layer_of_file(path.relative_to(root / "runtime"))
        if layer not in LAYERS:
            continue
        for include in includes(path):
            other = layer_of_include(include)
            if other and not may_include(layer, other):
                yield f"{path.relative_to(root)}: {layer} includes {include}; dependencies point the other way"


def check_compiler_is_alone(root):
    for path in sources(root, "compiler"):
        for include in includes(path):
            if include.startswith("suture/"):
                yield f"{path.relative_to(root)}: the compiler includes {include} of the runtime"
        part = path.relative_to(root / "compiler").parts[0]
        if part in {"model", "check", "lock", "emit"}:
            for include in includes(path):
                if include.startswith(("clang/", "llvm/", "compiler/frontend/", "compiler/driver/")):
                    yield f"{path.relative_to(root)}: {part} includes {include}; only the frontend sees clang"


def check_components_see_public_headers(root):
    for path in sources(root, "components"):
        for include in includes(path):
            if include.startswith(("suture/transport/", "suture/manager/", "suture/rt/", "capnp/", "kj/")):
                yield f"{path.relative_to(root)}: a component includes {include}, which is not public"


# A wait that a stepped clock does not know stops it for ever. These are the places that wait for the kernel, and why.
WAITS = re.compile(r"condition_variable|std::(future|promise|async|jthread|thread)\b|sleep_(for|until)|\b(u|nano)sleep\(|"
                   r"this_thread::yield|\bpoll\(&?\w+, |epoll_wait\(|sigtimedwait\(|SYS_futex")
MAY_WAIT = {
    "runtime/rt/doorbell.cpp": "the one place where threads sleep",
    "runtime/rt/thread.h": "threads that a stepped clock knows",
    "runtime/rt/thread.cpp": "threads that a stepped clock knows",
    "runtime/testing/scheduler.h": "is the stepped clock",
    "runtime/testing/scheduler.cpp": "is the stepped clock",
    "runtime/transport/frame/lane_thread.cpp": "sleeps at sockets, and asks the stepped clock first",
    "runtime/transport/rpc/event_port.cpp": "asks for another thread whether anything has come, without waiting",
    "runtime/transport/rpc/host_lookup.cpp": "asks the system's name service, which knows no other clock",
    "runtime/deploy/signal_wait.h": "waits for signals, which come from outside",
    "runtime/deploy/signal_wait.cpp": "waits for signals, which come from outside",
    "runtime/deploy/report_writer.cpp": "waits for a pipe, which another process empties",
}


def check_waits(root):
    for path in sources(root, "runtime"):
        name = path.relative_to(root)
        if str(name) in MAY_WAIT or name.parts[1] == "cli":  # that is a program of one thread, and part of no system
            continue
        for line in path.read_text(encoding="utf-8").splitlines():
            found = WAITS.search(line)
            if found and not line.lstrip().startswith("//"):
                yield f"{name}: waits by {found[0]}; only a doorbell may (rt/doorbell.h), so that a stepped clock knows of it"


# What KJ alone observes, the stepped clock does not find: its time goes on past what has arrived.
def check_observers(root):
    for path in sources(root, "runtime"):
        name = path.relative_to(root)
        if name.stem != "event_port" and "kj::UnixEventPort::FdObserver" in path.read_text(encoding="utf-8"):
            yield f"{name}: kj::UnixEventPort::FdObserver; use EventPort::FdObserver, of which a stepped clock knows"


def check_lengths(root):
    for folder in ("compiler", "runtime", "components", "examples", "tests"):
        for path in sources(root, folder):
            lines = path.read_text(encoding="utf-8").count("\n")
            if lines > MAX_LINES and "expected" not in path.parts:  # what suturec writes
                yield f"{path.relative_to(root)}: {lines} lines, at most {MAX_LINES}"


def check_readmes(root):
    for top in ("compiler", "runtime", "components", "examples", "tests", "schemas"):
        base = root / top
        for folder in sorted(p for p in base.iterdir() if p.is_dir()) if base.exists() else []:
            if folder.name.startswith((".", "__")) or not any(folder.rglob("*.*")):
                continue
            readme = folder / "README.md"
            if not readme.exists():
                yield f"{folder.relative_to(root)}: no README.md"
            elif readme.read_text(encoding="utf-8").count("\n") > MAX_README_LINES:
                yield f"{readme.relative_to(root)}: more than {MAX_README_LINES} lines"


def check_format(root):
    tool = shutil.which("clang-format-14")
    if tool is None:
        yield "clang-format-14 is missing: run .ci/install tests"
        return
    files = [p for folder in ("compiler", "runtime", "components", "examples", "tests") for p in sources(root, folder)]
    # Not ours to lay out: expected outputs, deliberately broken inputs, the model of generated code.
    files = [p for p in files if not {"golden", "errors"} & set(p.parts) and ".suture." not in p.name]
    for i in range(0, len(files), 100):
        result = subprocess.run([tool, "--dry-run", "--style=file", *map(str, files[i : i + 100])],
                                capture_output=True, text=True, cwd=root)
        for path in sorted({line.split(":")[0] for line in result.stderr.splitlines() if ": warning: " in line}):
            yield f"{pathlib.Path(path).relative_to(root)}: not formatted; run clang-format-14 -i on it"


CHECKS = [check_layers, check_compiler_is_alone, check_components_see_public_headers, check_waits, check_observers, check_lengths,
          check_readmes, check_format]


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    violations = [line for check in CHECKS for line in check(root)]
    print("\n".join(violations) or "The tree keeps its rules.")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
