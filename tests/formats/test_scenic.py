"""`emit scenic`: what the program says; the slow test asks Scenic itself."""

from __future__ import annotations

import ast
import math
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

import roadlang
from roadlang import testing
from roadlang.cli.main import run
from roadlang.ir.scene import Scene
from roadlang_formats.emit_scenic import ScenicBackend
from roadlang_formats.scenic.names import variable_names
from tests.formats.opendrive_reader import arc_length
from tests.formats.tool_environments import ask_tool

EXAMPLES = Path(__file__).parents[2] / "examples"
STREET = """
road main { draw with segments { pieces: [straight(60m), arc(400m, 40deg)] },
  left: [drive, sidewalk(2m)], right: [drive, parking(2.2m), sidewalk(2m)], speed_limit: 30km/h }
agent other is van on main at 40m { lane: 1, facing: back, drive with car_follow { speed: 8m/s } }
agent ego is car on main at 10m { lane: -1, start_speed: 5m/s, drive with lane_follow }
agent walker is pedestrian on main at 30m { side: right, offset: 1m }
object parked is parked_car on main at 50m { lane: parking }
object model is building at (60m, 40m) { heading: 30deg }
"""
TRAFFIC = '''%s
image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { lanes: 4, sidewalks: 2m, speed_limit: 50km/h, control with stop }
agent cars is choice(car, van) on town at random { count: 6, apart: 6m, drive with traffic }
'''
SINGLE = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 20m)] }, width: 4m, lanes: 1 }
agent ego is car on main at 10m
agent oncoming is car on main at 60m { facing: back }
"""
SAMPLES = 4
"""Of programs in which nothing is random: each is drawn at once, or never."""
TEXTS = {
    "street": STREET,
    "single": SINGLE,
    "town": TRAFFIC % "",
    "left-hand": TRAFFIC % "world { traffic: left }",
}


def program(scene: Scene) -> dict[str, str]:
    files = dict(ScenicBackend().files(scene))
    assert ScenicBackend().files(scene) == files
    return files


def specifiers(text: str) -> dict[str, dict[str, str]]:
    """By the names of objects: the class and position, and all that `with` sets."""
    found = {}
    for block in re.findall(r"^\w+ = new .*(?:\n    .*)*", text, flags=re.MULTILINE):
        start = re.match(r"(\w+) = new (\w+) at (\([^)]*\)), facing (\S+),", block)
        assert start is not None
        values = dict(re.findall(r"with (\w+) (\([^)]*\)|\w+\([^)]*\)|\"[^\"]*\"|[^,\n]+)", block))
        names = ("variable", "class", "at", "facing")
        found[ast.literal_eval(values["name"])] = values | dict(
            zip(names, start.groups(), strict=True)
        )
    return found


def test_a_program_places_agents_and_objects_as_the_scene_does() -> None:
    scene = testing.sample(STREET)[0].record
    files = program(scene)
    assert 'param map = localPath("scene-0000.scenic.xodr")' in files["scenic"]
    things = specifiers(files["scenic"])
    for actor in (*scene.agents, *scene.objects):
        thing = things[actor.name]
        x, y = ast.literal_eval(thing["at"])
        assert math.hypot(x - actor.x, y - actor.y) < 1e-6
        turn = float(thing["facing"]) + math.pi / 2 - actor.heading
        assert abs(math.remainder(turn, math.tau)) < 1e-6
        size = [float(thing[name]) for name in ("length", "width", "height")]
        assert size == pytest.approx([actor.length, actor.width, actor.height])
    assert [things[name]["class"] for name in ("ego", "walker", "parked")] == [
        "Car", "Pedestrian", "Object",
    ]  # fmt: skip
    assert things["ego"]["behavior"] == "FollowLaneBehavior(target_speed=8.33333333333)"
    assert things["ego"]["speed"] == "5"
    assert things["other"]["behavior"] == "DriveAvoidingCollisions(target_speed=8)"
    # Only what stands wholly on lanes may be held to them.
    held = {name for name, thing in things.items() if "regionContainedIn" not in thing}
    assert held == {"ego", "other"}
    assert files["scenic"].index("ego = ") < files["scenic"].index("other = ")


def test_the_map_has_no_lane_that_scenic_does_not_drive_on_or_that_has_no_width() -> None:
    taper = "road a { draw with segments { pieces: [straight(100m)] }, lanes: 2, oneway: true }\n"
    taper += taper.replace("road a", "road b").replace("lanes: 2", "lanes: 3")
    for text in (SINGLE, taper + "road main from a { then: [b], taper: 40m }"):
        root = ElementTree.fromstring(program(testing.sample(text)[0].record)["scenic.xodr"])
        for road in root.iter("road"):
            for lane in road.iter("lane"):
                assert lane.get("type") in ("driving", "none")
                for width in lane.iter("width"):
                    assert float(width.get("a", 0)) >= 0.1


def test_no_cubic_says_that_it_is_longer_than_it_is() -> None:
    text = "road main { draw with waypoints { points: [(0m, 0m), (60m, 0m), (110m, 50m)] } }"
    root = ElementTree.fromstring(program(testing.sample(text)[0].record)["scenic.xodr"])
    pieces = [piece for piece in root.iter("geometry") if piece.find("paramPoly3") is not None]
    assert pieces
    for piece in pieces:
        stated, found = float(piece.get("length", 0.0)), arc_length(piece, 2001)
        assert found - 1e-6 < stated < found


def test_variables_are_new_words() -> None:
    names = ["cars[0]", "cars[1]", "cars_1", "road", "import", "town/tree[3]", "2", "ä"]
    variables = variable_names(names)
    assert list(variables) == names
    assert len(set(variables.values())) == len(names)
    assert all(name.isidentifier() and name.isascii() for name in variables.values())
    assert variables["cars[1]"] == "cars_1"
    assert not {"road", "import"} & set(variables.values())


@pytest.mark.slow
def test_scenic_samples_the_programs_without_a_rejection(tmp_path: Path) -> None:
    scenes = {name: testing.sample(text)[0].record for name, text in TEXTS.items()}
    for name in ("composed", "on_ramp", "parked_row", "roundabout", "traffic", "two_actors"):
        scenes[name] = roadlang.load(EXAMPLES / f"{name}.rl").sample(1)[0].record
    paths = {}
    for name, scene in scenes.items():
        folder = tmp_path / name
        folder.mkdir()
        for ending, content in program(scene).items():
            (folder / f"{scene.stem}.{ending}").write_text(content, encoding="utf-8")
        paths[name] = str(folder / f"{scene.stem}.scenic")
    question = {"programs": list(paths.values()), "samples": SAMPLES}
    answers = ask_tool("scenic", "scenic_samples.py", question)
    for name, path in paths.items():
        answer = answers[path]
        assert answer.get("draws") == SAMPLES, (name, answer)
        for actor in scenes[name].agents:
            roads = [road for road in scenes[name].roads if road.name == actor.road]
            lanes = [lane for road in roads for lane in road.lane_list if lane.id == actor.lane]
            if not any(lane.drivable for lane in lanes):
                continue
            on = answer["lanes"][actor.name]
            assert on is not None, (name, actor.name)
            assert on[1] < 0.3, (name, actor.name)


def test_a_pedestrian_on_a_lane_may_be_there() -> None:
    text = """
road main { draw with segments { pieces: [straight(80m)] }, lanes: 2 }
agent walker is pedestrian on main at 20m { lane: -1 }
agent car is car on main at 50m { lane: -1 }
"""
    program = ScenicBackend().files(testing.sample(text)[0].record)["scenic"]
    walker, car = program.split("new ")[1:]
    assert "regionContainedIn everywhere" in walker
    assert "regionContainedIn" not in car


def test_a_converted_program_loads_the_map_beside_it(tmp_path: Path) -> None:
    (tmp_path / "scene.rl").write_text(SINGLE)
    target = tmp_path / "my & scene-0000.scenic"
    assert run(["convert", str(tmp_path / "scene.rl"), str(target)]) == 0
    found = re.search(r"localPath\((.*)\)", target.read_text())
    assert found is not None
    assert (tmp_path / ast.literal_eval(found[1])).is_file()
