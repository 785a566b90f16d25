"""Checks what the tree promises. Prints each violation; exit status 1 if there is any."""

import pathlib
import re
import shutil
import subprocess
import sys

# These are the folders of runtime/suture/, lowest first. Each may include itself and what stands before it. Within one layer, which is one
# library, a source may include any of its parts: the order holds for headers there.
RUNTIME = ["base", "base/slots", "rt", "rt/queue", "rt/state", "component/contract", "component/channel/counts",
           "component/channel", "component/provided", "component/required",
           "component", "component/factory", "component/task", "wiring", "loop", "net/tls", "net", "framing", "codec", "codec/json", "lane",
           "lane/carrier", "lane/fault", "lane/delay", "lane/rpc", "lane/shm", "lane/frame/bytes", "lane/frame/payloads", "lane/frame", "names", "session", "session/client",
           "session/provider/limits", "session/provider/shared", "session/provider/connections", "session/provider", "standard", "manager", "observe", "record", "testing", "deploy/document", "deploy/process", "deploy"]
CLI = ["values", "command_line", "contract", "peer", "text", "."]
COMPILER = {"frontend": ["ast", "report", "types", "data", "."], "lock": ["schema", "moves", "."], "emit": ["text", "wire", "cpp", "docs", "."]}
# A folder of runtime/suture/ that has a namespace of its own shares it with the folders below; what lies in no such folder is in suture itself.
NAMESPACES = {"rt": "rt", "loop": "loop", "net": "net", "net/tls": "tls", "framing": "framing", "codec": "codec", "lane/rpc": "rpc",
              "lane/shm": "shm", "lane/frame": "frame"}
PARALLEL = {"observe", "record", "testing"}  # none of them knows another
# Standard contracts that the layers below speak of count as the lowest, and see no more than that.
BASIC_CONTRACTS = {"standard/lifecycle.h"}
MAX_SOURCES = 25
SOURCES = {".h", ".cpp"}
NAMESPACE = re.compile(r"^namespace suture((?:::\w+)*) \{", re.M)
INCLUDE = re.compile(r'^\s*#include\s+[<"]([^>"]+)[>"]', re.M)
MAX_LINES = 700
MAX_README_LINES = 40
MIN_WORDS, MAX_WORDS = 3, 7


def sources(root, folder):
    base = root / folder
    return sorted(p for p in base.rglob("*") if p.suffix in SOURCES) if base.exists() else []


def includes(path):
    return INCLUDE.findall(path.read_text(encoding="utf-8"))


def folder_of(path):
    """Returns the folder of a path below runtime/suture/; None if no such folder is known."""
    folder = path.rpartition("/")[0]
    return RUNTIME[0] if path in BASIC_CONTRACTS else folder if folder in RUNTIME else None


def may_include(path, include):
    here, there = folder_of(path), folder_of(include)
    if here is None or there is None or here == there:
        return True
    if {here, there} <= PARALLEL:
        return False
    if path.endswith(".cpp") and here.split("/")[0] == there.split("/")[0]:
        return True
    return RUNTIME.index(there) < RUNTIME.index(here)


def check_layers(root):
    for path in sources(root, "runtime/suture"):
        name = str(path.relative_to(root / "runtime/suture"))
        if "/" in name and folder_of(name) is None:
            yield f"{path.relative_to(root)}: tests/tree/rules.py does not say which folders this one may include"
        for include in includes(path):
            if include.startswith("suture/") and not may_include(name, include[len("suture/"):]):
                yield f"{path.relative_to(root)}: {folder_of(name)} includes {include}; dependencies point the other way"


# Code above the lanes names no lane, so that a new lane is a folder and a line in lane/lanes.cpp.
LANE = re.compile(r"suture/lane/(shm|frame|rpc|delay|fault)/|\bLane::(Shm|Frame|Rpc)\b|\\?\"(shm|frame|rpc)\\?\"")
DELAYS = ("suture/lane/delay/", "a delay is no lane, but is put on a connection of any")
MAY_NAME_LANES = {
    "runtime/suture/session/provider/plain_client.cpp":
        ("suture/lane/rpc/", "serves a plain Cap'n Proto client as that of a connection by calls, without a connection"),
    "runtime/suture/session/connect_options.h": DELAYS,
    "runtime/suture/session/client/remote_connection.cpp": DELAYS,
    "runtime/suture/session/service_threads.cpp": DELAYS,
    "runtime/suture/manager/connections.cpp": DELAYS,
    "runtime/suture/deploy/check.cpp": DELAYS,
}


def namespace_of(folder):
    """Returns the namespace below suture for a folder of runtime/suture/, "" if it has none."""
    while folder not in NAMESPACES and "/" in folder:
        folder = folder.rpartition("/")[0]
    return NAMESPACES.get(folder, "")


def check_namespaces(root):
    """A source declares what other folders have before its own, so its last namespace is the one that counts."""
    for path in sources(root, "runtime/suture"):
        opened = NAMESPACE.findall(path.read_text(encoding="utf-8"))
        if not opened:
            continue
        wanted, found = namespace_of(str(path.parent.relative_to(root / "runtime/suture"))), opened[-1].split("::")[1:]
        inner = found[1:] if wanted and found[:1] == [wanted] else found if not wanted else None
        if inner is None or set(inner) & set(NAMESPACES.values()):
            yield f"{path.relative_to(root)}: its namespace is suture{opened[-1]}, but its folder has suture{wanted and '::' + wanted}"


def check_lanes(root):
    schemas = [path for path in sorted(root.glob("schemas/**/*")) if path.suffix in {".json", ".capnp"}]
    for path in [*sources(root, "runtime"), *schemas]:
        name = str(path.relative_to(root))
        if name.startswith("runtime/suture/lane/"):
            continue
        allowed = MAY_NAME_LANES.get(name, ("",))[0]
        named = [found[0] for found in LANE.finditer(path.read_text(encoding="utf-8"))]
        if allowed and allowed not in named:
            yield f"{name}: names {allowed} no more; take it out of MAY_NAME_LANES in tests/tree/rules.py"
        for one in named:
            if one != allowed:
                yield f"{name}: names a lane, {one}; what depends on one belongs into its folder in lane/"


def check_parts(root):
    for base, order in {"runtime/cli": CLI, **{f"compiler/{name}": parts for name, parts in COMPILER.items()}}.items():
        prefix = base.removeprefix("runtime/") + "/"
        for path in sources(root, base):
            here = str(path.relative_to(root / base).parent)
            for include in includes(path):
                there = include[len(prefix):].rpartition("/")[0] or "."
                if include.startswith(prefix) and there in order and order.index(there) > order.index(here):
                    yield f"{path.relative_to(root)}: includes {include}; dependencies point the other way"


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


NOT_PUBLIC = ("capnp/", "kj/", *(f"suture/{layer}/" for layer in ("rt", "loop", "net", "framing", "wire", "lane", "names", "session",
                                                               "manager")))


def check_components_see_public_headers(root):
    for path in sources(root, "components"):
        for include in includes(path):
            if include.startswith(NOT_PUBLIC):
                yield f"{path.relative_to(root)}: a component includes {include}, which is not public"


# A wait that a stepped clock does not know stops it for ever. These are the places that wait for the kernel, and why.
WAITS = re.compile(r"condition_variable|std::(future|promise|async|jthread|thread|latch|barrier|\w+_semaphore)\b|sleep_(for|until)|"
                   r"(\bu|nano)sleep\(|this_thread::yield|\bpoll\([&\w.()]+, |\bppoll\(|\bp?select\(|epoll_p?wait2?\(|sigtimedwait\(|"
                   r"SYS_futex|\.wait\((std::memory_order|[a-z]\w*, )")
MAY_WAIT = {
    "runtime/suture/rt/doorbell.cpp": "the one place where threads sleep",
    "runtime/suture/rt/thread.h": "threads that a stepped clock knows",
    "runtime/suture/rt/thread.cpp": "threads that a stepped clock knows",
    "runtime/suture/testing/scheduler.h": "is the stepped clock",
    "runtime/suture/testing/scheduler.cpp": "is the stepped clock",
    "runtime/suture/lane/frame/lane_thread.cpp": "sleeps at sockets, and asks the stepped clock first",
    "runtime/suture/loop/event_port.cpp": "asks for another thread whether anything has come, without waiting",
    "runtime/suture/net/host_lookup.cpp": "asks the system's name service, which knows no other clock",
    "runtime/suture/loop/signal_wait.h": "waits for signals, which come from outside",
    "runtime/suture/loop/signal_wait.cpp": "waits for signals, which come from outside",
    "runtime/suture/deploy/report_writer.cpp": "waits for a pipe, which another process empties",
    "runtime/suture/base/line_file.cpp": "waits for a pipe, which another process empties",
    "runtime/suture/rt/standard_error.cpp": "asks if a pipe has room, and waits for nothing",
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


# The stepped clock does not find what KJ alone observes: its time would go on past what has arrived.
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


def check_folders(root):
    for top in ("compiler", "runtime", "components", "examples", "tests"):
        folders = {}
        for path in sources(root, top):
            folders.setdefault(path.parent, []).append(path)
        for folder, flat in sorted(folders.items()):
            if len(flat) > MAX_SOURCES and not {"golden", "errors"} & set(folder.parts):  # inputs and outputs, one file a case
                yield f"{folder.relative_to(root)}: {len(flat)} sources lie flat, at most {MAX_SOURCES}; part them by idea"


# These are projects and inputs of single tests: the README of the test's folder tells of them.
FIXTURES = {"golden", "errors", "evolution", "project", "consumers", "refusals"}


def folders_with_readme(root):
    """Yields each folder of a top folder, and each below it that has sources."""
    for top in ("compiler", "runtime", "components", "examples", "tests", "schemas"):
        base = root / top
        for folder in base.iterdir() if base.exists() else []:
            if folder.is_dir() and not folder.name.startswith((".", "__")) and any(folder.rglob("*.*")):
                yield folder
        for path in sources(root, top):
            if path.parent != base and not FIXTURES & set(path.parts):
                yield path.parent


def check_readmes(root):
    for folder in sorted(set(folders_with_readme(root))):
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
    # These are not ours to lay out: expected outputs, deliberately broken inputs, generated code.
    files = [p for p in files if not {"golden", "errors"} & set(p.parts) and ".suture." not in p.name and ".wire." not in p.name]
    for i in range(0, len(files), 100):
        result = subprocess.run([tool, "--dry-run", "--style=file", *map(str, files[i : i + 100])],
                                capture_output=True, text=True, cwd=root)
        for path in sorted({line.split(":")[0] for line in result.stderr.splitlines() if ": warning: " in line}):
            yield f"{pathlib.Path(path).relative_to(root)}: not formatted; run clang-format-14 -i on it"


# The name of a test case says behaviour, and is read in a list of thousands. "A" and "The" count as words, and the suite's name does not.
TEST_NAME = re.compile(r"^\s*(?:TYPED_)?TEST(?:_F|_P)?\(\s*\w+,\s*(\w+)\)", re.M)


def check_test_names(root):
    for path in sources(root, "tests"):
        for name in TEST_NAME.findall(path.read_text(encoding="utf-8")):
            words = len(re.findall(r"[A-Z][a-z0-9]*|[a-z0-9]+", name))
            if words > MAX_WORDS:
                yield f"{path.relative_to(root)}: the test {name} has {words} words, at most {MAX_WORDS}"
            if words < MIN_WORDS:
                yield f"{path.relative_to(root)}: the test {name} has {words} words, at least {MIN_WORDS}; say what happens"


# Who reads "Is called when ..." must guess who calls, or what is so.
WITHOUT_SUBJECT = re.compile(r"^\s*//+<? (Is|Has|Are|Have)\b|//.*[.;] (Is|Has|Are|Have)\b")


def check_comments(root):
    for folder in ("compiler", "runtime", "components", "examples", "tests"):
        for path in sources(root, folder):
            if {"errors", "expected"} & set(path.parts):  # what suturec writes, and inputs whose lines are counted
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if found := WITHOUT_SUBJECT.search(line):
                    yield f"{path.relative_to(root)}:{number}: a comment begins with {found[1] or found[2]}; say who does it, or what is so"


CHECKS = [check_layers, check_namespaces, check_lanes, check_parts, check_folders, check_compiler_is_alone, check_components_see_public_headers,
          check_waits, check_observers, check_lengths, check_readmes, check_test_names, check_comments, check_format]


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    violations = [line for check in CHECKS for line in check(root)]
    print("\n".join(violations) or "The tree keeps its rules.")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
