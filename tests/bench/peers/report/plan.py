"""Says what is measured, how often, and what its table shows."""

import dataclasses
import os

import catalogue


@dataclasses.dataclass(frozen=True)
class Column:
    title: str
    figure: str
    digits: int = 1


@dataclasses.dataclass(frozen=True)
class Measurement:
    name: str
    title: str
    peers: tuple
    columns: tuple
    repetitions: int
    arguments: tuple
    cpus: tuple  # of the client, and of servers
    servers: tuple = (1,)
    group: str = ""  # a figure by which a peer has several sets of columns
    titles: dict = dataclasses.field(default_factory=dict)  # of the groups


def blocking(peers):
    return tuple(peer for peer in peers if not peer.spins)


def round_trip(quick):
    count = 2000 if quick else 10000
    columns = (Column("min", "minimum"), Column("median", "median"), Column("p99", "p99"), Column("p99.9", "p99_9"),
               Column("max", "maximum", 0), Column("CPU client", "client_cpu"), Column("CPU server", "server_cpu"),
               Column("switches", "switches"), Column("lo bytes", "loopback_bytes", 0),
               Column("lo packets", "loopback_packets"))
    # Both run on one processor, so that what is left is the way through the middleware and two switches.
    return Measurement("round_trip", f"Round trip of a pose, us; {count} of them, both processes on one CPU",
                       blocking(catalogue.RIVALS + catalogue.OURS + catalogue.OURS_BY_RETURN), columns,
                       1 if quick else 5, ("--count", count), (0, 0))


def conversion(quick):
    return Measurement("conversion", "A pose to the bytes of a message and back, in process", catalogue.CONVERTERS,
                       (Column("bytes", "bytes", 0), Column("ns", "ns")), 1 if quick else 3,
                       ("--count", 100_000 if quick else 1_000_000), (0, 0))


def stream(quick, cpus):
    seconds = 0.5 if quick else 1
    columns = (Column("poses/s", "per_second", 0), Column("received", "received", 0), Column("lost", "lost", 0),
               Column("out of order", "disorder", 0), Column("CPU us send", "client_cpu", 2),
               Column("CPU us receive", "server_cpu", 2))
    return Measurement("stream", f"Poses one way, as fast as there is room; at most 400000, at most {seconds} s",
                       catalogue.RIVALS + catalogue.OURS, columns, 1 if quick else 2,
                       ("--count", 400_000, "--seconds", seconds), cpus)


def payload(quick, cpus):
    titles = {120: "120 B", 1024: "1 KiB", 65536: "64 KiB", 1048576: "1 MiB"}
    return Measurement("payload", "Round trip by payload (a vector of doubles), us", catalogue.RIVALS + catalogue.OURS,
                       (Column("median", "median"), Column("p99", "p99", 0)), 1,
                       ("--seconds", 0.3 if quick else 1.5), cpus, group="bytes", titles=titles)


def fan_out(quick, cpus):
    servers = (16,) if quick else (1, 4, 16)
    count = 500 if quick else 2000
    columns = (Column("median", "median", 0), Column("p99", "p99", 0), Column("CPU", "client_cpu"),
               Column("lost", "lost", 0))
    return Measurement("fan_out", f"{count} poses at 1 kHz to so many processes: us until the last one has it, and CPU "
                       "us of the sender for each", blocking(catalogue.RIVALS + catalogue.OURS), columns, 1,
                       ("--count", count), cpus, servers, "servers", {n: f"{n}:" for n in servers})


def measurements(quick):
    """Returns the measurements of a run; with `quick` fewer messages, and fan-out only to 16."""
    cpus = (0, min(1, os.cpu_count() - 1))
    return (round_trip(quick), conversion(quick), stream(quick, cpus), payload(quick, cpus), fan_out(quick, cpus))
