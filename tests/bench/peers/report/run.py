"""Measures all peers by turns, and writes peers.md, peers.csv, peers.json and peers.png; peers.sh builds them first."""

import argparse
import importlib.util
import pathlib
import signal
import sys
import time

import bounds
import machine
import plan
import processes
import results
import tables

PROJECT = pathlib.Path(__file__).resolve().parents[1]


def measured(runs, measurement, peer, servers, repetition):
    """Returns the rows of one run, also of one that failed."""
    about = {"measurement": measurement.name, "peer": peer.name, "repetition": repetition, "servers": servers}
    begin = time.monotonic()
    try:
        rows = [{**about, **figures} for figures in runs.figures(peer, measurement, servers)]
    except processes.Failure as failure:
        rows = [{**about, "failure": str(failure)}]
    seconds = time.monotonic() - begin
    print(f"{measurement.name}, {servers} x {peer.name}: {seconds:.1f} s, {results.remark(rows)}", file=sys.stderr, flush=True)
    return rows


def measure(runs, measurements):
    """Peers take turns, so that what disturbs the machine disturbs all alike."""
    rows = []
    for measurement in measurements:
        for repetition in range(measurement.repetitions):
            for servers in measurement.servers:
                for peer in measurement.peers:
                    rows += measured(runs, measurement, peer, servers, repetition)
    return rows


def draw(measurements, rows, file):
    """Returns the name of the picture, "" if there is none."""
    if importlib.util.find_spec("matplotlib") is None:
        print("no picture: python3-matplotlib is missing", file=sys.stderr)
        return ""
    import chart  # only where there is what it needs
    chart.draw(measurements, rows, file)
    return file.name


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="the folder of the peers' programs")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--check", action="store_true", help="exit status 1 if a bound is not kept")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("told to end"))  # so that what it has started ends first

    wanted = bounds.read(PROJECT / "bounds.txt")
    about = machine.description(PROJECT / "packages.txt")
    measurements = plan.measurements(options.quick)
    rows = measure(processes.Runs(options.programs), measurements)
    shortfalls = bounds.shortfalls(wanted, measurements, rows)

    options.out.mkdir(parents=True, exist_ok=True)
    results.write_csv(rows, options.out / "peers.csv")
    results.write_json(rows, about, shortfalls, options.out / "peers.json")
    picture = draw(measurements, rows, options.out / "peers.png")
    text = tables.document(measurements, rows, about, shortfalls, picture)
    (options.out / "peers.md").write_text(text, encoding="utf-8")
    print(text)
    return 1 if options.check and shortfalls else 0


if __name__ == "__main__":
    sys.exit(main())
