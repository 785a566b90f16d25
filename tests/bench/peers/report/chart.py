"""Draws the picture: four measurements, the peers in the order of their figures, Suture in one colour."""

import dataclasses

from matplotlib.figure import Figure
from matplotlib.patches import Patch

import results

OURS, RIVAL, FLOOR = "#d1495b", "#8d99ae", "#d5dae3"


@dataclasses.dataclass(frozen=True)
class Panel:
    measurement: str
    key: object  # of the group: bytes or servers
    figure: str
    title: str
    digits: int
    more_is_better: bool = False


PANELS = (
    Panel("round_trip", None, "median", "Round trip of a pose, both ends on one CPU [us]", 1),
    Panel("stream", None, "per_second", "Poses one way [1/s], more is better", 0, True),
    Panel("payload", 1048576, "median", "Round trip of 1 MiB [us]", 0),
    Panel("fan_out", 16, "median", "Until the last of 16 processes has a pose [us]", 0),
)


def colour(peer):
    return OURS if peer.is_ours else FLOOR if peer.is_floor else RIVAL


def bars(panel, measurement, rows):
    """Returns peers and figures, the best first, and the names of peers without a figure that counts."""
    found, without = [], []
    for peer in measurement.peers:
        own = results.in_group(results.of(rows, measurement.name, peer.name), measurement.group, panel.key)
        figure = results.median(own, panel.figure)
        if figure is None:
            without.append(peer.name)
        elif results.wrongs(own):
            without.append(f"{peer.name} (wrong)")
        else:
            found.append((peer, figure))
    return sorted(found, key=lambda bar: bar[1], reverse=panel.more_is_better), without


def draw_panel(axes, panel, measurement, rows):
    found, without = bars(panel, measurement, rows)
    figures = [figure for _, figure in found]
    drawn = axes.barh([peer.name for peer, _ in found], figures, color=[colour(peer) for peer, _ in found])
    axes.bar_label(drawn, [f"{figure:,.{panel.digits}f}" for figure in figures], padding=3, fontsize=7)
    axes.set_xscale("log")
    axes.margins(x=0.12, y=0.01)
    axes.invert_yaxis()
    axes.set_title(panel.title, fontsize=10, loc="left")
    axes.tick_params(labelsize=8)
    if without:
        axes.set_xlabel(f"not shown: {', '.join(without)}", fontsize=8)
    for label, (peer, _) in zip(axes.get_yticklabels(), found):
        label.set_color(OURS if peer.is_ours else "black")
    axes.spines[["top", "right"]].set_visible(False)


def draw(measurements, rows, file):
    by_name = {measurement.name: measurement for measurement in measurements}
    picture = Figure(figsize=(14, 11), layout="constrained")
    places = picture.subplots(2, 2).flat
    for panel, axes in zip(PANELS, places):
        draw_panel(axes, panel, by_name[panel.measurement], rows)
    colours = {"Suture": OURS, "peers": RIVAL, "without middleware": FLOOR}
    places[0].legend([Patch(color=shade) for shade in colours.values()], colours, loc="upper right")
    picture.savefig(file, dpi=110)
