"""`check` finds what no draw can mend, all of it in one run, and stays light."""

from __future__ import annotations

import shutil
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import roadlang

EXAMPLES = Path(__file__).parents[2] / "examples"
STRAIGHT = "road main {{ draw with segments {{ pieces: [straight(100m)] }}{0} }}\n"
WAYS = "road main {{ draw with waypoints {{ points: [(0m, 0m), (60m, 30m), (100m, 0m)] }}{0} }}\n"


def faults(text: str, folder: Path | str = ".") -> list[tuple[str, int]]:
    """Code and line of each error."""
    found = roadlang.loads(text, folder=folder).check()
    return [(d.code, d.span.line if d.span else 0) for d in found if d.is_error]


def test_everything_is_found_in_one_run() -> None:
    text = (
        STRAIGHT.format(", lanes: 3")
        + "agent a is car on main at 5m { lane: 2 }\n"
        + "agent b is car on main at 101m { lane: -2 }\n"
        + "object c is tree on main at -1m { side: left }\n"
        + "object d is tree on main at 101% { side: left }\n"
        + "object e is tree on main at 100m { side: left }\n"
        + "agent f is car on main at 5m { lane: -3 }\n"
    )
    assert faults(text) == [
        ("RL613", 2), ("RL615", 3), ("RL615", 4), ("RL615", 5), ("RL613", 7)
    ]  # fmt: skip


@pytest.mark.parametrize("road", [STRAIGHT, WAYS])
@pytest.mark.parametrize(
    ("more", "at", "wrong"),
    [
        ("", "99m", False),
        ("", "130m..140m", True),
        ("", "90m..140m", False),
        ("", "-2m..-1m", True),
        ("", "0%", False),
        ("", "100%", False),
        (", perturb with sine { amplitude: 1m, wavelength: 50m }", "400m", False),
        (", perturb with sine { amplitude: 1m, wavelength: 50m }", "120%", True),
    ],
)
def test_where_a_position_is_on_the_road(road: str, more: str, at: str, wrong: bool) -> None:
    if "perturb" in more:
        more = more.replace(", perturb", " perturb")
    text = road.format(more) + f"object e is tree on main at {at} {{ side: left }}\n"
    assert faults(text) == ([("RL615", 2)] if wrong else [])


def test_a_closed_road_goes_on_at_its_start() -> None:
    text = WAYS.format(", closed: true") + "object e is tree on main at 400m { side: left }\n"
    assert faults(text) == []


@given(st.floats(0.0, 200.0))
def test_check_and_compile_agree_on_positions(at: float) -> None:
    text = WAYS.format("") + f"object e is tree on main at {at:.6f}m {{ side: left }}\n"
    length = roadlang.loads(WAYS.format("")).sample()[0].roads["main"].length
    if abs(at - length) > 1e-3:
        assert bool(faults(text)) == (at > length)


@pytest.mark.parametrize(
    "piece", ["straight(90m)", "arc(20m, -270deg)", "clothoid(90m, to: 0.05/m, start: 0/m)"]
)
def test_a_piece_is_at_least_as_long_as_it_says(piece: str) -> None:
    text = f"road main {{ draw with segments {{ pieces: [{piece}, straight(5m)] }} }}\n"
    length = roadlang.loads(text).sample()[0].roads["main"].length
    beyond = f"object e is tree on main at {length + 0.01}m {{ side: left }}\n"
    before = f"object e is tree on main at {length - 0.01}m {{ side: left }}\n"
    assert faults(text + beyond) == [("RL615", 2)]
    assert faults(text + before) == []


def test_lanes_are_those_of_the_road_that_has_them() -> None:
    text = (
        STRAIGHT.format(", lanes: 4")
        + "road moved from main { perturb with bump { at: 50m, height: 1m, length: 20m } }\n"
        + "road narrow from moved { lanes: 1 }\n"
        + "agent a is car on moved at 5m { lane: 2 }\n"
        + "agent b is car on narrow at 5m { lane: 1 }\n"
    )
    assert faults(text) == [("RL613", 5)]


def test_lanes_that_are_drawn_are_not_judged_before() -> None:
    text = STRAIGHT.format(", lanes: choice(2, 4)") + "agent a is car on main at 5m { lane: 2 }\n"
    assert faults(text) == []


@pytest.fixture
def pictures(tmp_path: Path) -> Path:
    shutil.copy(EXAMPLES / "town.png", tmp_path)
    return tmp_path


NETWORK = (
    'image plan from "town.png" {0}\nimage worse from plan {1}\nnetwork town from worse {{}}\n'
)


@pytest.mark.parametrize(
    ("first", "second", "wrong"),
    [
        ("{}", "{}", True),
        ("{ scale: 1m/px }", "{}", False),
        ("{}", "{ scale: 1m/px }", False),
    ],
)
def test_an_image_without_scale_is_found_without_opening_it(
    first: str, second: str, wrong: bool, pictures: Path
) -> None:
    expected = [("RL406", 2)] if wrong else []
    assert faults(NETWORK.format(first, second), pictures) == expected


def test_an_image_that_no_network_is_made_from_needs_no_scale(pictures: Path) -> None:
    assert faults('image plan from "town.png"\n' + STRAIGHT.format(""), pictures) == []


def test_a_world_file_gives_the_scale(pictures: Path) -> None:
    (pictures / "town.pgw").write_text("0.5\n0\n0\n-0.5\n0\n0\n")
    assert faults(NETWORK.format("{}", "{}"), pictures) == []


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("0.5\nzero\n0\n-0.5\n0\n0\n", "line 2: 'zero' is not a number"),
        ("0.5\n0\n0\n", "line 4: a world file has six numbers"),
    ],
)
def test_a_world_file_that_gives_no_scale_is_named(text: str, said: str, pictures: Path) -> None:
    (pictures / "town.pgw").write_text(text)
    (found,) = roadlang.loads(NETWORK.format("{}", "{}"), folder=pictures).check()
    assert found.help[0].startswith(f"`town.pgw`, {said}")


def test_the_tags_of_a_geotiff_give_the_scale(tmp_path: Path) -> None:
    scale = struct.pack("<3d", 0.5, 0.5, 0.0)
    entries = [(256, 3, 1, 8), (257, 3, 1, 8), (33550, 12, 3, 8 + 2 + 3 * 12 + 4)]
    tags = b"".join(struct.pack("<HHII", *entry) for entry in entries)
    head = b"II*\0" + struct.pack("<I", 8) + struct.pack("<H", len(entries))
    (tmp_path / "town.png").write_bytes(head + tags + bytes(4) + scale)
    assert faults(NETWORK.format("{}", "{}"), tmp_path) == []
    (tmp_path / "town.png").write_bytes(head[:8] + struct.pack("<H", 2) + tags[:24] + bytes(64))
    assert faults(NETWORK.format("{}", "{}"), tmp_path) == [("RL406", 2)]


@pytest.mark.parametrize(
    ("text", "imports"),
    [
        (WAYS.format("") + "agent a is car on main at 50m { lane: -1 }\n", False),
        (WAYS.format("") + "agent a is car on main at 2 * 20m { lane: 1 }\n", False),
        (WAYS.format("") + "agent a is car on main at 500m { lane: -1 }\n", True),
        (NETWORK.format("{}", "{}"), False),
    ],
)
def test_numpy_is_imported_only_to_draw_a_road_that_may_be_too_short(
    text: str, imports: bool, pictures: Path
) -> None:
    (pictures / "scene.rl").write_text(text)
    code = (
        "import sys\nfrom roadlang.cli.main import run\nrun(['check', 'scene.rl'])\n"
        "print('numpy' in sys.modules, 'cv2' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=pictures
    )
    assert done.stdout.split() == [str(imports), "False"]


@pytest.mark.parametrize("angle", ["180deg", "-180deg"])
def test_a_road_is_as_long_to_the_right_as_to_the_left(angle: str) -> None:
    """A half circle of 157 m, perhaps bent further: 100 m is on it, and nothing is said."""
    road = f"road main {{ draw with segments {{ pieces: [arc(50m, {angle})] }} }}\n"
    assert faults(road + "agent a is car on main at 150m\n") == []
    assert faults(road + "agent a is car on main at 160m\n") == [("RL615", 2)]


CROSSING = '''image plan from """
...#....
########
...#....
""" {{ scale: 20m/px, legend: {{ "#": road }} }}
network town from plan {{ extract with pixels, control with stop {{ {0} }} }}
'''


@pytest.mark.parametrize(
    ("option", "code"),
    [
        ("junctions: [99], roads: [1]", "RL429"),
        ("junctions: [3], roads: [1]", "RL429"),
        ("roads: [9]", "RL411"),
    ],
)
def test_junctions_and_roads_that_a_typed_picture_lacks(option: str, code: str) -> None:
    assert faults(CROSSING.format(option)) == [(code, 6)]


def test_junctions_and_roads_that_a_typed_picture_has() -> None:
    assert faults(CROSSING.format("junctions: [1], roads: [1]")) == []


@pytest.mark.parametrize(
    "weights", ["[1]", "[1, 1, 1]", "[1, -1]", "[0, 0]", "[-1, 1..2]", "[1..2]"]
)
@pytest.mark.parametrize("items", ["car, van", "2m, 3m", "'a', 'b'", "1m..2m, 3m"])
def test_wrong_weights_of_a_choice(items: str, weights: str) -> None:
    drawn = f"choice({items}, weights: {weights})".replace("'", '"')
    if "car" in items:
        text = STRAIGHT.format("") + f"agent a is {drawn} on main at 5m\n"
    else:
        text = "\n" + f"param a = {drawn}\n"
    assert faults(text) == [("RL476", 2)]  # also where an item or weight is random
    with pytest.raises(roadlang.DiagnosticError, match="RL476"):
        roadlang.loads(text).sample(1)


NUDGES = "road bent from main {{ perturb with nudges {{ at: {0}, by: {1} }} }}\n"


@pytest.mark.parametrize(
    ("text", "underlined"),
    [
        (STRAIGHT.format("") + NUDGES.format("[9m, 50m]", "[(0m, 1m)]"), "[(0m, 1m)]"),
        (STRAIGHT.format("") + NUDGES.format("[9m]", "[(0m, 1m..2m), (0m, 2m)]"),
         "[(0m, 1m..2m), (0m, 2m)]"),
        ("road main { draw with segments { pieces: [straight(9m), arc(9m, 0deg)] } }\n", "0deg"),
        ("road main { draw with waypoints { points: [(1m, 2m), (1m, 2m)] } }\n",
         "[(1m, 2m), (1m, 2m)]"),
        ('network map from "map.osm" { read with osm { origin: (200deg, 10deg) } }\n',
         "(200deg, 10deg)"),
        ('network map from "map.osm" { read with osm { origin: (48deg, -181deg) } }\n',
         "(48deg, -181deg)"),
        ('network map from "map.osm"\nroad way from map { select: route((1m, 2m), (1m, 2m)) }\n',
         "(1m, 2m)"),
    ],
)  # fmt: skip
def test_options_that_a_kind_refuses(text: str, underlined: str, tmp_path: Path) -> None:
    """Its own class says so, and the option is underlined."""
    (tmp_path / "map.osm").write_text("<osm/>")
    (error,) = roadlang.loads(text, folder=tmp_path).check()
    assert error.code == "RL480"
    assert error.span is not None
    assert error.span.text == underlined


def test_options_that_a_kind_refuses_only_in_some_scenes() -> None:
    """The draws decide, so that there may be scenes."""
    text = STRAIGHT.format("") + "param where = choice(10m, 20m, weights: [0..1, 0..1])\n"
    assert faults(text) == []
    piece = "arc(9m, 0deg..20deg)"
    assert faults(f"road main {{ draw with segments {{ pieces: [{piece}] }} }}\n") == []


@pytest.mark.parametrize(
    ("over", "wrong"),
    [
        ("[120m, 140m]", True),
        ("[100m, 140m]", True),
        ("[90m, 140m]", False),
        ("[90m..120m, 140m]", False),
        ("[110m..120m, 140m]", True),
    ],
)
@pytest.mark.parametrize("length", ["100m", "90m..100m"])
def test_an_interval_beyond_the_end_of_its_road(over: str, wrong: bool, length: str) -> None:
    road = STRAIGHT.format("").replace("100m", length)
    sine = f"perturb with sine {{ amplitude: 1m, wavelength: 50m, over: {over}, taper: 1m }}"
    known = length == "100m"  # else only drawing shows how long it is
    found = faults(road + f"road bent from main {{ {sine} }}\n")
    assert found == ([("RL414", 2)] if wrong and known else [])


def test_a_negative_standard_deviation_is_found_by_check() -> None:
    assert faults("param a = normal(5m, -1m)\n") == [("RL208", 1)]
    assert faults("param a = normal(5m, 0m)\n") == []


RING = """road main {{
  draw with waypoints {{ points: [(0m, 0m), (60m, 0m..5m), (60m, 60m), (0m, 60m)] }}, closed: {0}
}}
road bent from main {{ perturb with sine {{ amplitude: 1m, wavelength: 60m..70m }} }}
{1} gentle: always (curvature({2}) < 1/m) {{ semantics: {3} }}
"""


@pytest.mark.parametrize("word", ["require", "expect"])
@pytest.mark.parametrize("road", ["main", "bent"])
@pytest.mark.parametrize("semantics", ["held", "linear"])
def test_formulas_between_the_samples_of_a_closed_road(
    word: str, road: str, semantics: str
) -> None:
    (error,) = roadlang.loads(RING.format("true", word, road, semantics)).check()
    assert error.code == "RL312"
    assert error.span is not None
    assert (error.span.line, error.span.text) == (5, semantics)
    assert faults(RING.format("false", word, road, semantics)) == []
    assert faults(RING.format("true", word, road, "sampled")) == []


@pytest.mark.parametrize("word", ["require", "expect"])
def test_a_road_that_turns_out_closed_is_refused_at_the_same_place(word: str) -> None:
    """Whether it is closed is drawn here, which only a scene shows."""
    text = "param is_ring = choice(true, true)\n" + RING.format("is_ring", word, "main", "linear")
    loaded = roadlang.loads(text)
    assert [found for found in loaded.check() if found.is_error] == []
    with pytest.raises(roadlang.DiagnosticError) as caught:
        loaded.sample(1)
    (error,) = caught.value.diagnostics
    assert error.code == "RL312"
    assert error.span is not None
    assert error.span.text == "linear"


@pytest.mark.parametrize(
    ("option", "is_found"),
    [
        ("", False),
        (", origin: (52deg, 13deg)", False),
        (", origin: (120deg, 5deg)", True),
        (", origin: (5deg, 190deg)", True),
        (", origin: (20deg..120deg, 5deg)", False),
    ],
)
def test_an_origin_that_is_not_on_earth_is_found_before_the_picture_is_read(
    option: str, is_found: bool
) -> None:
    photo = EXAMPLES / "hairpin.jpg"
    text = f'image photo from "{photo}" {{ scale: 0.5m/px{option} }}\nnetwork town from photo\n'
    found = [each for each in roadlang.loads(text).check() if each.code == "RL480"]
    assert [each.help for each in found] == is_found * [("it is written `(latitude, longitude)`",)]
