"""Maps of the ROS map server: their free space is read as a network, in the frame of the map."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

import roadlang

YAML = """\
image: {image}
resolution: 0.05
origin: [{x}, {y}, {yaw}]
negate: {negate}
occupied_thresh: 0.65
free_thresh: 0.196
"""
SCENE = 'network hall from "map.yaml"\nroad way from hall { select: longest }\n'
FREE, UNKNOWN, WALL = 254, 205, 0


def hall() -> NDArray[np.uint8]:
    """A corridor 2 m wide along y = 5 m, one up from its middle, walls around, unknown beyond."""
    cells = np.full((300, 400), UNKNOWN, np.uint8)
    for value, wall in ((WALL, 4), (FREE, 0)):
        cells[180 - wall : 220 + wall, 20 - wall : 380 + wall] = value
        cells[20 - wall : 200, 180 - wall : 220 + wall] = value
    cells[176:184, 180:220] = FREE
    rng = np.random.default_rng(1)
    for row, column in rng.integers(0, [300, 400], (200, 2)):  # what a scanner gets wrong
        cells[row, column] = rng.choice([FREE, UNKNOWN, WALL])
    return cells


def write(
    folder: Path,
    cells: NDArray[np.uint8],
    image: str = "map.pgm",
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0),
    negate: int = 0,
) -> Path:
    x, y, yaw = origin
    (folder / "map.yaml").write_text(YAML.format(image=image, x=x, y=y, yaw=yaw, negate=negate))
    done, content = cv2.imencode(Path(image).suffix, cells)
    assert done
    (folder / image).write_bytes(content.tobytes())
    return folder


def scene_of(folder: Path) -> roadlang.Scene:
    (scene,) = roadlang.loads(SCENE, folder=folder).sample()
    return scene


@pytest.mark.parametrize("image", ["map.pgm", "map.png", "map.bmp"])
def test_corridors_are_roads_as_wide_as_they_are(image: str, tmp_path: Path) -> None:
    scene = scene_of(write(tmp_path, hall(), image))
    (network,) = scene.networks.values()
    junctions = [node for node in network.nodes if len(node.roads) == 3]
    assert len(junctions) == 1
    assert (junctions[0].x, junctions[0].y) == pytest.approx((10.0, 5.0), abs=0.3)
    way = scene.roads["way"]
    assert np.median(way.width) == pytest.approx(2.0, abs=0.15)
    assert 14.0 < way.length < 19.0


def test_the_origin_places_and_turns_the_map(tmp_path: Path) -> None:
    plain = scene_of(write(tmp_path, hall())).roads["way"]
    turned = scene_of(write(tmp_path, hall(), origin=(-3.0, 7.0, math.pi / 2))).roads["way"]
    np.testing.assert_allclose(turned.x, -3.0 - plain.y, atol=1e-6)
    np.testing.assert_allclose(turned.y, 7.0 + plain.x, atol=1e-6)


def test_a_negated_map_is_the_same(tmp_path: Path) -> None:
    plain = scene_of(write(tmp_path, hall())).roads["way"]
    negated = scene_of(write(tmp_path, 255 - hall(), negate=1)).roads["way"]
    np.testing.assert_array_equal(plain.points, negated.points)


def test_thresholds_decide_what_is_free(tmp_path: Path) -> None:
    write(tmp_path, hall())
    text = (tmp_path / "map.yaml").read_text()
    (tmp_path / "map.yaml").write_text(text.replace("0.196", "0.0"))
    with pytest.raises(roadlang.DiagnosticError, match=r"RL428.*no pixel of its image is free"):
        scene_of(tmp_path)


def test_a_value_at_a_threshold_is_not_free(tmp_path: Path) -> None:
    cells = np.where(hall() == FREE, 204, 0).astype(np.uint8)  # (255 - 204) / 255 is 0.2
    write(tmp_path, cells)
    text = (tmp_path / "map.yaml").read_text()
    (tmp_path / "map.yaml").write_text(text.replace("0.196", "0.2"))
    with pytest.raises(roadlang.DiagnosticError, match="RL428"):
        scene_of(tmp_path)
    (tmp_path / "map.yaml").write_text(text.replace("0.196", "0.21"))
    assert scene_of(tmp_path).roads["way"].length > 14


def test_the_digests_of_both_files_are_recorded(tmp_path: Path) -> None:
    from hashlib import sha256

    folder = tmp_path / "maps"
    folder.mkdir()
    write(folder, hall())
    (scene,) = roadlang.loads(SCENE.replace("map.yaml", "maps/map.yaml"), folder=tmp_path).sample()
    inputs = scene.provenance.inputs
    assert inputs["maps/map.pgm"] == sha256((folder / "map.pgm").read_bytes()).hexdigest()
    assert inputs["maps/map.yaml"] == sha256((folder / "map.yaml").read_bytes()).hexdigest()


def test_an_option_sets_the_width(tmp_path: Path) -> None:
    write(tmp_path, hall())
    text = SCENE.replace('"map.yaml"', '"map.yaml" { read with ros_map { width: 1.2m } }')
    (scene,) = roadlang.loads(text, folder=tmp_path).sample()
    np.testing.assert_allclose(scene.roads["way"].width, 1.2, atol=1e-9)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("image: [", "it is not YAML"),
        ("\xff\xfe", "it is not YAML"),
        ("- 1", "it is not a map of"),
        ("", "it is empty"),
        ("image: [3]\nresolution: 1", "`image` is not the name"),
        ("resolution: 1", "`image` is not the name"),
        ("image: map.pgm", "`resolution` is missing"),
        ("image: map.pgm\nresolution: wide", "`resolution` is not a number: 'wide'"),
        ("image: map.pgm\nresolution: .nan", "`resolution` is not a number"),
        # YAML 1.1, which PyYAML reads, has other numbers here than YAML 1.2 and ROS.
        ("image: map.pgm\nresolution: 1:30", "`resolution` is not a number: '1:30'"),
        ("image: map.pgm\nresolution: 1_0", "`resolution` is not a number: '1_0'"),
        ("image: map.pgm\nresolution: 00200000", "it is 80000km wide"),
        ("image: map.pgm\nresolution: 0", "must be above 0"),
        ("image: map.pgm\nresolution: true", "`resolution` is not a number: 'true'"),
        ("image: map.pgm\nresolution: 1" + 400 * "0", "`resolution` is not a number: '10"),
        ("image: map.pgm\nresolution: 1.0e+4", "100km is the most"),
        ("image: map.pgm\nresolution: 1\norigin: [1.0e+300, 0]", "more than 10,000km away"),
        ("image: map.pgm\nresolution: 1\norigin: [0, 1, .inf]", "`origin` is not a number: '.inf'"),
        ("image: map.pgm\nresolution: 1\nnegate: [1]", "`negate` is not a number"),
        ("image: map.pgm\nresolution: 1\norigin: 3", "`origin` is not"),
        ("image: map.pgm\nresolution: 1\norigin: [a, 0]", "`origin` is not a number: 'a'"),
        ("image: map.pgm\nresolution: 1\nmode: scale", "its mode is `scale`"),
        ("image: map.pgm\nresolution: 1\nfree_thresh: 0.9", "must rise from 0 to 1"),
        ("image: nope.pgm\nresolution: 1", "`nope.pgm`"),
        ("image: map.yaml\nresolution: 1", "`map.yaml`"),
        ("image: ..\nresolution: 1", "folder"),
        ("a: &a [x, x]\nb: &b [*a, *a]\nimage: *b\nresolution: 1", "`image` is not the name"),
    ],
)
def test_what_is_no_map_is_said(text: str, reason: str, tmp_path: Path) -> None:
    write(tmp_path, hall())
    (tmp_path / "map.yaml").write_text(text, encoding="latin-1")
    with pytest.raises(roadlang.DiagnosticError) as caught:
        scene_of(tmp_path)
    words = str(caught.value)
    assert reason in words
    assert "scene.rl:1:" in words
    assert "RL470" not in words


@pytest.mark.parametrize("key", ["resolution", "negate", "mode", "origin"])
def test_aliases_of_aliases_are_not_written_out(key: str, tmp_path: Path) -> None:
    """Nine levels of nine stand for 387 million items."""
    write(tmp_path, hall())
    names = "abcdefghi"
    steps = [
        f"{name}: &{name} [{', '.join(9 * [f'*{before}'])}]" for before, name in pairwise(names)
    ]
    lines = ["a: &a [x]", *steps, "image: map.pgm", f"{key}: [*i, 0]"]
    (tmp_path / "map.yaml").write_text("\n".join(["resolution: 1", *lines]))
    with pytest.raises(roadlang.DiagnosticError, match="RL428") as caught:
        scene_of(tmp_path)
    assert len(str(caught.value)) < 1000


@pytest.mark.parametrize("written", ["5e-2", "'0.05'", "5.0e-02"])
def test_a_resolution_may_be_written_as_other_tools_do(written: str, tmp_path: Path) -> None:
    """YAML 1.1 wants a point in `5e-2`, of which other writers know nothing."""
    write(tmp_path, hall())
    plain = scene_of(tmp_path).roads["way"]
    path = tmp_path / "map.yaml"
    path.write_text(path.read_text() + f"resolution: {written}\n")
    assert scene_of(tmp_path).roads["way"].length == pytest.approx(plain.length)


@pytest.mark.parametrize("kind", [b"P5", b"P2"])
def test_gray_images_of_robots_have_comments_and_two_bytes(kind: bytes, tmp_path: Path) -> None:
    write(tmp_path, hall())
    cells = hall().astype(np.uint16) * 257
    head = kind + b"\n# CREATOR: map_generator.cpp 0.050 m/pix\n400 300\n65535\n"
    body = cells.astype(">u2").tobytes()
    if kind == b"P2":
        body = " ".join(map(str, cells.ravel())).encode() + b"\n"
    (tmp_path / "map.pgm").write_bytes(head + body)
    assert scene_of(tmp_path).roads["way"].length > 14
    if kind == b"P5":
        (tmp_path / "map.pgm").write_bytes((head + body)[:-2])
        with pytest.raises(roadlang.DiagnosticError, match="RL403"):
            scene_of(tmp_path)
