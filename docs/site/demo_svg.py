"""Draws docs/demo.svg: examples/demo.sh --network tls | demo_svg.py "./examples/demo.sh --network tls" > docs/demo.svg

The picture has all that the demo prints but most of its connections, in the colours of a terminal.
"""

import re
import sys
from xml.sax.saxutils import escape

COLUMN, LINE, MARGIN = 7.85, 17, 16  # pixels; a character of the font is as wide as a column
BLUE, GREY, GREEN = "#8ab4f8", "#8a919e", "#7bc275"
HEADS = ("  time ", "connection ", "component ", "table 2 of the paper", "slave ")
KEPT = ("MTML/Drives", "TeleopL/", "Console/PSM1", "MTMRDrives/Stop", "TeleopR/")  # how the connections that are shown begin


def without_most_connections(lines):
    """Leaves out the connections that are not in KEPT, with their second lines, and says how many."""
    begin = next(i for i, line in enumerate(lines) if line.startswith("connection "))
    end = lines.index("", begin)
    shown, left_out, kept = lines[:begin + 1], 0, True
    for line in lines[begin + 1:end]:
        if not line.startswith(" "):
            kept = line.startswith(KEPT)
            left_out += not kept
        if kept:
            shown.append(line)
    return [*shown, f"... and {left_out} more connections", *lines[end:]]


def marked(line):
    """Returns the attributes and the text of a line. Browsers collapse spaces that may be broken."""
    text = escape(line.lstrip()).replace(" ", "\u00a0")
    if line.startswith("$"):
        return f' fill="{BLUE}"', text
    if line.startswith("..."):
        return f' fill="{GREY}"', text
    if line.startswith(HEADS):
        return ' font-weight="bold"', text
    return "", re.sub("^(Teleoperation\u00a0\\S+?)(?=\u00a0)", r'<tspan font-weight="bold">\1</tspan>',
                      re.sub("^ok", f'<tspan fill="{GREEN}">ok</tspan>', text))


def picture(lines):
    width = round(max(map(len, lines)) * COLUMN + 2 * MARGIN)
    height = LINE * len(lines) + 2 * MARGIN
    yield f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">'
    yield f'<rect width="{width}" height="{height}" rx="8" fill="#1c1f26"/>'
    yield '<g font-family="DejaVu Sans Mono, Menlo, Consolas, monospace" font-size="13" fill="#d7dae0">'
    for number, line in enumerate(lines):
        if line:
            attributes, text = marked(line)
            indent = len(line) - len(line.lstrip())  # a place of its own, since some viewers drop all spaces in front
            x, y = MARGIN + indent * COLUMN, 28 + LINE * number
            yield f'<text x="{x:.1f}" y="{y}" textLength="{(len(line) - indent) * COLUMN:.1f}"{attributes}>{text}</text>'
    yield "</g>\n</svg>"


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: demo_svg.py COMMAND < OUTPUT > PICTURE")
    print("\n".join(picture(["$ " + sys.argv[1], *without_most_connections(sys.stdin.read().rstrip("\n").split("\n"))])))


if __name__ == "__main__":
    main()
