"""Writes the results in Markdown."""

import results


def number(value, digits):
    return "-" if value is None else f"{round(value, digits) + 0.0:.{digits}f}"  # no minus before a 0


def aligned(head, rows):
    widths = [max(len(line[i]) for line in [head, *rows]) for i in range(len(head))]
    last = len(head) - 1

    def text(line):
        cells = [cell.ljust(width) if i in (0, last) else cell.rjust(width)
                 for i, (cell, width) in enumerate(zip(line, widths))]
        return "| " + " | ".join(cells) + " |"

    rule = [":" + "-" * (width - 1) if i in (0, last) else "-" * (width - 1) + ":" for i, width in enumerate(widths)]
    return "\n".join([text(head), text(rule), *map(text, rows)])


def columns_of(measurement):
    """Returns each column with the group that it belongs to, and its title."""
    if not measurement.group:
        return [(None, column, column.title) for column in measurement.columns]
    return [(key, column, f"{title} {column.title}") for key, title in measurement.titles.items()
            for column in measurement.columns]


def table(measurement, rows):
    columns = columns_of(measurement)
    lines = []
    for peer in measurement.peers:
        own = results.of(rows, measurement.name, peer.name)
        cells = [number(results.median(results.in_group(own, measurement.group, key), column.figure), column.digits)
                 for key, column, _ in columns]
        lines.append([peer.name, *cells, results.remark(own)])
    return aligned(["peer", *(title for _, _, title in columns), "remark"], lines)


def heading(measurement):
    repeated = f"; median of {measurement.repetitions} interleaved runs" if measurement.repetitions > 1 else ""
    return f"## {measurement.title}{repeated}"


def document(measurements, rows, about, shortfalls, picture):
    parts = ["# Suture beside its peers", "\n".join(f"- {name}: {value}" for name, value in about.items())]
    if picture:
        parts.append(f"![Round trip, stream, 1 MiB and fan-out of all peers]({picture})")
    for measurement in measurements:
        parts += [heading(measurement), table(measurement, rows)]
    parts += ["## Bounds that are not kept", "\n".join(f"- {line}" for line in shortfalls) or "None."]
    return "\n\n".join(parts) + "\n"
