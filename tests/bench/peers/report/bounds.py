"""Compares with bounds.txt: figures of one peer against those of another in the same run."""

import dataclasses
import operator
import re

import results

COMPARISONS = {"<=": operator.le, ">=": operator.ge, "<": operator.lt}
LINE = re.compile(r"(?P<figure>\S+)\s+(?P<peer>.+?) (?P<comparison><=|>=|<) (?P<factor>[\d.]+) x (?P<rival>.+?)\s+\| (?P<words>.+)")


@dataclasses.dataclass(frozen=True)
class Bound:
    measurement: str
    key: object  # of the group: servers or bytes; None without
    figure: str
    peer: str
    comparison: str
    factor: float
    rival: str
    words: str


def parsed(line):
    found = LINE.fullmatch(line)
    if found is None:
        raise ValueError(f"this is no bound: {line}")
    measurement, *key, figure = found["figure"].split(".")
    return Bound(measurement, int(key[0]) if key else None, figure, found["peer"], found["comparison"],
                 float(found["factor"]), found["rival"], found["words"])


def read(file):
    lines = [line.strip() for line in file.read_text(encoding="utf-8").splitlines()]
    return [parsed(line) for line in lines if line and not line.startswith("#")]


def rows_of(bound, peer, measurements, rows):
    group = {measurement.name: measurement.group for measurement in measurements}[bound.measurement]
    return results.in_group(results.of(rows, bound.measurement, peer), group, bound.key)


def shortfall(bound, ours, theirs):
    """Returns what is to be said of a bound, by the rows of the two peers; "" if it is kept."""
    for peer, own in ((bound.peer, ours), (bound.rival, theirs)):
        if results.median(own, bound.figure) is None:
            return f"no figure of {peer}"
        if results.wrongs(own):
            return f"no figure of {peer} that counts, {results.remark(own)}"
    mine, rivals = (results.median(own, bound.figure) for own in (ours, theirs))
    if COMPARISONS[bound.comparison](mine, bound.factor * rivals):
        return ""
    return (f"{bound.peer} {mine:.6g}, {bound.rival} {rivals:.6g}, which is {mine / rivals:.2f} x; "
            f"asked is {bound.comparison} {bound.factor:g} x")


def shortfalls(bounds, measurements, rows):
    """Returns a line for people for each bound that is not kept."""
    lines = []
    for bound in bounds:
        ours, theirs = (rows_of(bound, peer, measurements, rows) for peer in (bound.peer, bound.rival))
        words = shortfall(bound, ours, theirs)
        if words:
            lines.append(f"{bound.words}: {words}")
    return lines
