"""Runs a peer once: one server or several, a client, and a companion if the peer needs one. Ends all that it starts, by pid."""

import contextlib
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

LIMIT = 60  # s that a client may take; no measurement takes half of it
GRACE = 3  # s that a process has to end once it is told to
SHARED_MEMORY = pathlib.Path("/dev/shm")
FIRST_PORT, PORTS, PORTS_OF_A_RUN = 20000, 12000, 400  # below the ports that the kernel chooses from


class Failure(Exception):
    """Says why a peer has no figures, in words."""


class Runs:
    """Gives each run a number, and paths and ports of its own that follow from it."""

    def __init__(self, programs):
        self.programs = pathlib.Path(programs)
        self.count = 0

    def figures(self, peer, measurement, servers):
        """Returns the figures that the client prints, a dictionary a line. Raises Failure."""
        self.count += 1
        program = self.programs / peer.program
        if not program.exists():
            raise Failure("it is not built, since its packages are missing: see packages.txt")
        with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as stack:
            place = SHARED_MEMORY / f"peers.{os.getpid()}.{self.count}"
            stack.callback(remove, place)
            run = Run(program, peer, measurement, servers, place, self.port(), pathlib.Path(folder), stack)
            return run.figures()

    def port(self):
        return FIRST_PORT + (os.getpid() + self.count) * PORTS_OF_A_RUN % PORTS


class Run:
    def __init__(self, program, peer, measurement, servers, place, port, folder, stack):
        self.program, self.peer, self.measurement, self.servers = program, peer, measurement, servers
        self.place, self.port, self.folder, self.stack = place, port, folder, stack
        self.common = ("--control", f"{place}.control", "--place", place, "--port", port, "--servers", servers)

    def figures(self):
        if self.measurement.name == "conversion":
            return self.clients_figures([])
        beside = self.companions()
        servers = [self.start("server", self.measurement.cpus[1], "--server", number) for number in range(self.servers)]
        figures = self.clients_figures(beside + servers)
        for server in servers:
            with contextlib.suppress(subprocess.TimeoutExpired):
                server.wait(GRACE)
        return figures

    def clients_figures(self, others):
        client = self.start("client", self.measurement.cpus[0], *self.measurement.arguments)
        try:
            client.wait(LIMIT)
        except subprocess.TimeoutExpired:
            raise Failure(f"its client did not end within {LIMIT} s") from None
        if client.returncode != 0:
            failed = [other for other in others if other.poll()]
            raise Failure(self.words(failed[0] if failed else client))
        lines = self.file(client, "out").read_text(encoding="utf-8").splitlines()
        return [json.loads(line) for line in lines if line.startswith("{")]

    def start(self, role, cpu, *arguments):
        command = [self.program, self.peer.variant, role, self.measurement.name, *self.common, "--cpu", cpu, *arguments]
        return self.launch([str(part) for part in command], f"{role}{arguments[1] if role == 'server' else ''}")

    def companions(self):
        """Starts the companion if the peer needs one, and does not wait until it is ready: the peer does that by its own means."""
        if not self.peer.companion:
            return []
        command = [part.format(place=self.place, port=self.port) for part in self.peer.companion]
        if shutil.which(command[0]) is None:
            raise Failure(f"{command[0]}, which it needs, is missing")
        companion = self.launch(command, command[0])
        os.sched_setaffinity(companion.pid, {self.measurement.cpus[1]})
        return [companion]

    def launch(self, command, name):
        with open(self.folder / f"{name}.out", "wb") as out, open(self.folder / f"{name}.err", "wb") as errors:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=errors)
        process.name = name
        self.stack.callback(end, process)
        return process

    def file(self, process, kind):
        return self.folder / f"{process.name}.{kind}"

    def words(self, process):
        lines = self.file(process, "err").read_text(encoding="utf-8", errors="replace").split("\n")
        said = [line.strip() for line in lines if line.strip()]
        return f"{process.name} ended with {process.returncode}: {said[-1] if said else 'it said nothing'}"


def end(process):
    """Tells the process to end, and kills it if it does not."""
    if process.poll() is None:
        process.terminate()
        try:
            process.wait(GRACE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def remove(place):
    """Removes what a run has left in shared memory, also where its peers were killed."""
    for left in place.parent.glob(place.name + ".*"):
        shutil.rmtree(left) if left.is_dir() else left.unlink(missing_ok=True)
