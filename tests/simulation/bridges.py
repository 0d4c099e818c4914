"""A map with a bridge: a street from west to east, and one from north to south above it, which a
ramp joins. Meters from the crossing."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from roadlang import testing
from roadlang.session.scene_set import SceneSet

NODES = {
    "west": (-200.0, 0.0), "east": (200.0, 0.0), "north": (0.0, 200.0), "south": (0.0, -200.0),
    "off": (0.0, 120.0), "on": (120.0, 0.0),
}  # fmt: skip
WAYS = {
    "street": ("west", "on", "east"),
    "bridge": ("north", "off", "south"),
    "ramp": ("off", "on"),
}
LATITUDE, LONGITUDE = 111_195.0, 74_100.0
"""Meters for each degree, nearly, at 48 degrees."""


def bridge_map(folder: Path, tags: Mapping[str, Mapping[str, str]]) -> None:
    """Write `town.osm`. `tags`: of the ways that have more than `highway`; other ways than `street`
    and `bridge` exist only with tags."""
    nodes = "".join(
        f'<node id="{id}" lat="{48.0 + y / LATITUDE:.7f}" lon="{11.0 + x / LONGITUDE:.7f}"/>'
        for id, (x, y) in enumerate(NODES.values(), 1)
    )
    names = list(NODES)
    ways = ""
    for id, (name, along) in enumerate(WAYS.items(), 10):
        if name == "ramp" and name not in tags:
            continue
        said = {"highway": "residential", **tags.get(name, {})}
        refs = "".join(f'<nd ref="{names.index(node) + 1}"/>' for node in along)
        pairs = "".join(f'<tag k="{key}" v="{value}"/>' for key, value in said.items())
        ways += f'<way id="{id}">{refs}{pairs}</way>'
    (folder / "town.osm").write_text(f'<osm version="0.6">{nodes}{ways}</osm>')


def bridge_scenes(folder: Path, agents: str, count: int = 1, **tags: Mapping[str, str]) -> SceneSet:
    """Scenes with these agents on the map; the bridge is one unless `tags` say otherwise."""
    bridge_map(folder, {"bridge": {"bridge": "yes"}, **tags})
    read = "{ read with osm { origin: (48deg, 11deg) } }"
    return testing.sample(f'network town from "town.osm" {read}\n{agents}', count, folder=folder)
