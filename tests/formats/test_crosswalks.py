"""Crosswalks in figures and in the formats of other tools: paint, and no obstacle anywhere."""

from __future__ import annotations

import json
from functools import cache
from xml.etree import ElementTree

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import PAINT_HEIGHT, crosswalk_paint
from roadlang.ir.scene import Scene
from roadlang_formats.emit_commonroad import CommonRoadBackend
from roadlang_formats.emit_geojson import GeoJsonBackend
from roadlang_formats.emit_gltf import GltfBackend
from roadlang_formats.emit_mujoco import MujocoBackend
from roadlang_formats.emit_opendrive import OpenDriveBackend
from roadlang_godot.build.layout import layout_of
from roadlang_standard.emit_svg import Svg
from tests.formats.glb_reader import ReadGlb

TEXT = """
road main { draw with segments { pieces: [arc(60m, 90deg)] }, lanes: 2, sidewalks: 2m }
object zebra is crosswalk on main at 50m { width: 6.9m, heading: 10deg }
agent ego is car on main at 10m
"""


@cache
def scene() -> Scene:
    found: Scene = testing.sample(TEXT)[0].record
    return found


def without() -> Scene:
    from dataclasses import replace

    return replace(scene(), markings=())


def test_stripes_run_along_it_and_fill_half_of_it() -> None:
    (zebra,) = scene().markings
    shapes = list(crosswalk_paint(scene()))
    assert len(shapes) == 7  # 0.5 m each, and six gaps: 6.5 m of 6.9 m
    turn = complex(np.cos(zebra.heading), -np.sin(zebra.heading))
    for shape in shapes:
        local = (shape.points @ [1, 1j] - complex(zebra.x, zebra.y)) * turn
        assert np.ptp(local.real) == pytest.approx(4.0)
        assert np.ptp(local.imag) == pytest.approx(0.5)
        assert abs(local.imag).max() < 6.5 / 2 + 1e-9


def test_opendrive_has_its_type_and_corners() -> None:
    text = OpenDriveBackend().files(scene())["xodr"]
    (found,) = ElementTree.fromstring(text).iter("object")
    assert (found.get("type"), found.get("name")) == ("crosswalk", "zebra")
    assert float(found.get("s", "nan")) == pytest.approx(50.0, abs=0.01)
    corners = {(float(c.get("u", 0)), float(c.get("v", 0))) for c in found.iter("cornerLocal")}
    assert corners == {(2.0, 3.45), (-2.0, 3.45), (-2.0, -3.45), (2.0, -3.45)}


def test_geojson_has_its_area() -> None:
    features = json.loads(GeoJsonBackend(origin=(0.8, 0.2)).files(scene())["geojson"])["features"]
    (found,) = (each["properties"] for each in features if each["properties"]["type"] == "marking")
    assert (found["name"], found["category"], found["length"]) == ("zebra", "crosswalk", 4.0)


def test_gltf_has_its_stripes_on_the_road() -> None:
    file = ReadGlb.of(GltfBackend().files(scene())["glb"])
    triangles = file.triangles("crosswalks markings")
    assert len(triangles) == 7 * 2
    sides = triangles[:, 1:] - triangles[:, :1]
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum() / 2
    assert area == pytest.approx(7 * 0.5 * 4.0, rel=1e-4)
    # Up is y in glTF, z in the scene; the reader has either.
    assert triangles.std(axis=(0, 1)).min() == pytest.approx(0.0, abs=1e-6)
    assert np.isclose(triangles, PAINT_HEIGHT, atol=1e-6).all(axis=(0, 1)).any()


def test_figures_and_the_engine_paint_it() -> None:
    drawn, plain = (Svg().files(each)["svg"] for each in (scene(), without()))
    assert drawn.count("<path") == plain.count("<path") + 7
    parts = {part.label for part in layout_of(scene()).parts}
    assert parts - {part.label for part in layout_of(without()).parts} == {"paint 1"}


@pytest.mark.parametrize("backend", [CommonRoadBackend(), MujocoBackend()])
def test_it_is_no_obstacle(backend: CommonRoadBackend | MujocoBackend) -> None:
    assert backend.files(scene()) == backend.files(without())
