"""This is a reader's project: the folder in which a page's commands run, and the processes that they start."""

import os
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import threading

from page import PageError

LIMIT = 300  # s for a block that runs; only so that a hang ends the test
# Output comes line by line, as at a terminal.
SHELL = ["stdbuf", "-oL", "bash", "-e", "-c"]
PORT = re.compile(r"\b77\d\d\b")


class Process:
    """This is a process of a page that goes on beside it, with all that it has said."""

    def __init__(self, text, options):
        self._changed = threading.Condition()
        self._ended = False
        self._bytes = b""
        self._process = subprocess.Popen(SHELL + [text], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                         stderr=subprocess.STDOUT, start_new_session=True, **options)
        self._reader = threading.Thread(target=self._listen)
        self._reader.start()

    def _listen(self):
        while chunk := os.read(self._process.stdout.fileno(), 65536):
            with self._changed:
                self._bytes += chunk
                self._changed.notify()
        with self._changed:
            self._ended = True
            self._changed.notify()

    @property
    def said(self):
        return self._bytes.decode(errors="replace")

    def says(self, is_enough, patience):
        """Waits until it has said enough, has ended, or has no time left. Returns true if it has said enough."""
        with self._changed:
            self._changed.wait_for(lambda: is_enough(self.said) or self._ended, patience)
            return is_enough(self.said)

    def finish(self, limit):
        """Returns its status when it has ended, and with it whatever it started; None if they had to be killed."""
        with self._changed:
            ended = self._changed.wait_for(lambda: self._ended, limit)
        try:
            status = self._process.wait(limit) if ended else None
        except subprocess.TimeoutExpired:
            status = None
        if status is None:
            os.killpg(self._process.pid, signal.SIGKILL)  # one of the group lives, so its number is still its own
            self._process.wait()
        self._reader.join()
        self._process.stdout.close()
        return status

    def stop(self, limit):
        """Sends Ctrl-C, if it runs; otherwise does as finish()."""
        if self._process.poll() is None:
            os.killpg(self._process.pid, signal.SIGINT)
        status = self.finish(limit)
        return 0 if status in (-signal.SIGINT, 128 + signal.SIGINT) else status


class Project:
    def __init__(self, folder, package, patience, limit=LIMIT):
        self._folder = folder
        self._patience = patience
        self._limit = limit
        self._processes = {}
        self._ports = {}
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        self._runtime = tempfile.mkdtemp()  # for sockets, whose paths have to be short
        self._environment = {**os.environ, "PATH": f"{package}/bin:{os.environ['PATH']}", "CMAKE_PREFIX_PATH": str(package),
                             "XDG_RUNTIME_DIR": self._runtime, "CMAKE_BUILD_PARALLEL_LEVEL": "2"}

    def with_free_ports(self, text):
        """77xx stands for a port that is free: kept from others by a socket that is bound, and that lets a server listen."""
        return PORT.sub(lambda found: str(self._port(found[0])), text)

    def _port(self, written):
        if written not in self._ports:
            keeper = socket.socket()
            keeper.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            keeper.bind(("127.0.0.1", 0))
            self._ports[written] = keeper
        return self._ports[written].getsockname()[1]

    def write(self, file, text, mode="w"):
        path = self._folder / file
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open(mode, encoding="utf-8") as stream:
            stream.write(text)

    def insert(self, file, text, behind):
        path = self._folder / file
        lines = path.read_text(encoding="utf-8").splitlines(keepends=True) if path.exists() else []
        places = [at for at, line in enumerate(lines, 1) if behind in line]
        if len(places) != 1:
            raise PageError(f"{len(places)} lines of {file} have '{behind}'; it has to be in one")
        lines.insert(places[0], text)
        path.write_text("".join(lines), encoding="utf-8")

    def run(self, text):
        """Returns its status and what it said."""
        process = Process(text, self._options())
        return process.finish(self._limit), process.said

    def start(self, name, text):
        if name in self._processes:
            raise PageError(f"'{name}' runs already")
        self._processes[name] = Process(text, self._options())
        return self._processes[name]

    def process(self, name):
        if name not in self._processes:
            raise PageError(f"no '{name}' has been started")
        return self._processes[name]

    def stop(self, name):
        process = self.process(name)
        del self._processes[name]
        status = process.stop(self._patience)
        if status is None:
            raise PageError(f"'{name}' does not end at Ctrl-C; it said:\n{process.said}")
        if status != 0:
            raise PageError(f"'{name}' ended with status {status}; it said:\n{process.said}")
        return process

    def stop_all(self):
        """Stops what still runs, the latest first. Returns what went wrong at that."""
        problems = []
        for name in reversed(list(self._processes)):
            try:
                self.stop(name)
            except PageError as problem:
                problems.append(str(problem))
        return problems

    def close(self):
        self.stop_all()
        for keeper in self._ports.values():
            keeper.close()
        shutil.rmtree(self._runtime)

    def _options(self):
        return {"cwd": self._folder, "env": self._environment}
