"""Keeps what has been measured: a row, a dictionary, for each line of figures, or for each failure."""

import csv
import json
import statistics

LEADING = ("measurement", "peer", "repetition", "servers", "bytes", "failure", "without")


def of(rows, measurement, peer):
    return [row for row in rows if row["measurement"] == measurement and row["peer"] == peer]


def median(rows, figure):
    """Returns the median over repetitions; None if none has the figure."""
    values = [row[figure] for row in rows if figure in row]
    return statistics.median(values) if values else None


def in_group(rows, group, key):
    return [row for row in rows if row.get(group) == key] if group else rows


def wrongs(rows):
    """Says what makes figures worthless: they are of something else than was asked."""
    found = {
        "what came back was not what was sent": any(row.get("same") == 0 for row in rows),
        "poses were lost": any(row.get("lost") for row in rows),
        "poses came out of order": any(row.get("disorder") for row in rows),
    }
    return [f"WRONG: {words}" for words, true in found.items() if true]


def remark(rows):
    """Says of a peer why figures are missing or wrong, else ok."""
    if not rows:
        return "not run"
    reasons = [row[kind] for row in rows for kind in ("failure", "without") if kind in row]
    return "; ".join(dict.fromkeys(reasons + wrongs(rows))) or "ok"


def write_csv(rows, file):
    names = sorted({name for row in rows for name in row}, key=lambda name: (name not in LEADING, name))
    with open(file, "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, names)
        writer.writeheader()
        writer.writerows(rows)


def write_json(rows, about, shortfalls, file):
    content = {"machine": about, "rows": rows, "shortfalls": shortfalls}
    file.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
