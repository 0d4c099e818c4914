"""Two maps, or a map and a picture, that have places of their own on Earth: one warning."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

import roadlang

OSM = """<osm version="0.6">
<node id="1" lat="LAT" lon="11.573"/><node id="2" lat="LAT" lon="11.577"/>
<way id="10"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way>
</osm>
"""
ORIGIN = "{ read with osm { origin: (48.138deg, 11.576deg) } }"


@pytest.fixture(autouse=True)
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("town.osm").write_text(OSM.replace("LAT", "48.137"))
    Path("village.osm").write_text(OSM.replace("LAT", "48.139"))
    drawing = np.full((120, 200, 3), 255, np.uint8)
    cv2.line(drawing, (10, 60), (190, 60), (0, 0, 0), 8)
    cv2.imwrite("plan.png", drawing)


def warned(text: str) -> list[roadlang.Diagnostic]:
    Path("scene.rl").write_text(text)
    found = roadlang.load("scene.rl").sample(1).diagnostics
    return [diagnostic for diagnostic in found if diagnostic.code == "RL445"]


def test_maps_around_origins_of_their_own_are_warned_of() -> None:
    [found] = warned('network town from "town.osm"\nnetwork village from "village.osm"\n')
    assert "`town` and `village` have different origins on Earth, 222m apart" in found.message
    assert found.span is not None
    assert found.span.line == 2
    assert "read `village` around the other: `origin: (48.137deg, 11.575deg)`" in found.help[0]
    same = f'network town from "town.osm" {ORIGIN}\nnetwork village from "village.osm" {ORIGIN}\n'
    assert not warned(same)


def test_a_map_is_read_around_the_origin_of_a_picture() -> None:
    picture = 'image plan from "plan.png" { scale: 1m/px, origin: (48.138deg, 11.576deg) }\n'
    drawn = "network drawn from plan { extract with contour }\n"
    [found] = warned(f'network town from "town.osm"\n{picture}{drawn}')
    assert "read `town` around the other: `origin: (48.138deg, 11.576deg)`" in found.help[0]
    assert not warned(f'network town from "town.osm" {ORIGIN}\n{picture}{drawn}')


def test_what_has_no_place_on_earth_is_not_warned_of() -> None:
    road = "road main { draw with waypoints { points: [(0m, 0m), (90m, 5m)] } }\n"
    picture = 'image plan from "plan.png" { scale: 1m/px }\n'
    assert not warned(f'network town from "town.osm"\n{road}{picture}network n from plan\n')
