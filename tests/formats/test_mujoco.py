"""`emit mujoco`: what a model is made of; the slow test drives in MuJoCo itself."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely

import roadlang
from roadlang import testing
from roadlang.api import CURB_HEIGHT
from roadlang.ir.scene import Scene
from roadlang_formats.emit_mujoco import MujocoBackend
from roadlang_formats.mjcf.document import driven_agent
from tests.formats.tool_environments import ask_tool

ROOT = Path(__file__).parents[2]
TOWN = '''
image plan from """
...#...
#######
...#...
""" { scale: 30m/px }
network town from plan { lanes: 4, sidewalks: 2m }
agent walker is pedestrian on town at random
agent cars is car on town at random { count: 3, apart: 8m }
object tree is tree on town at random { side: left, offset: 1m }
world { friction: 0.5 }
'''
HAIRPIN = """
road main { draw with segments { pieces: [straight(30m), arc(12m, 180deg), straight(30m)] },
  width: 7m, lanes: 2 }
agent ego is car on main at 3m { lane: -1, drive with pure_pursuit { speed: 9m/s } }
"""


def model_of(scene: Scene) -> ElementTree.Element:
    text = MujocoBackend().files(scene)["mjcf.xml"]
    assert MujocoBackend().files(scene)["mjcf.xml"] == text
    return ElementTree.fromstring(text)


def floats(text: str | None) -> np.ndarray:
    return np.array((text or "").split(), dtype=float)


@pytest.fixture(scope="module")
def scene() -> Scene:
    found: Scene = testing.sample(TOWN)[0].record
    return found


def test_the_roads_are_convex_prisms_that_cover_roads_and_junctions(scene: Scene) -> None:
    root = model_of(scene)
    geoms = {geom.get("mesh"): geom for geom in root.iter("geom") if geom.get("type") == "mesh"}
    covered, tops = [], set()
    for mesh in root.iter("mesh"):
        corners = floats(mesh.get("vertex")).reshape(-1, 3)
        corners += floats(geoms[mesh.get("name")].get("pos"))
        top, bottom = corners[: len(corners) // 2], corners[len(corners) // 2 :]
        np.testing.assert_allclose(top - bottom, [[0, 0, 0.5]] * len(top), atol=2e-4)
        tops |= {round(float(z), 3) for z in top[:, 2]}
        polygon = shapely.Polygon(top[:, :2])
        assert polygon.is_valid
        assert polygon.convex_hull.area - polygon.area < 1e-2
        covered.append(polygon)
    assert tops == {0.0, CURB_HEIGHT}
    whole = shapely.union_all([polygon.buffer(1e-3) for polygon in covered])
    assert sum(polygon.area for polygon in covered) == pytest.approx(whole.area, rel=0.01)
    for network in scene.networks:
        for junction in network.junctions:
            area = shapely.Polygon(junction.area)
            assert area.difference(whole).area < 0.01 * area.area
    for road in scene.roads:
        inside = (np.array(road.stations) > road.trim[0]) & (
            np.array(road.stations) < road.length - road.trim[1]
        )
        points = shapely.points(np.column_stack((road.x, road.y))[inside])
        assert shapely.covers(whole, points).all()


def test_one_vehicle_is_driven_and_all_else_is_an_obstacle(scene: Scene) -> None:
    root = model_of(scene)
    (free,) = root.iter("freejoint")
    assert free.get("name") == "cars[0]"
    bodies = {body.get("name"): body for body in root.iter("body")}
    others = {"walker", "cars[1]", "cars[2]"}
    assert {name for name, body in bodies.items() if body.get("mocap") == "true"} == others
    boxes = {geom.get("name"): geom for geom in root.iter("geom") if geom.get("type") == "box"}
    for actor in (*scene.agents[:1], *scene.objects):
        size = actor.length / 2, actor.width / 2, actor.height / 2
        assert floats(boxes[actor.name].get("size")) == pytest.approx(size)
    wheels = [geom for geom in root.iter("geom") if geom.get("class") == "tire"]
    assert len(wheels) == 4
    assert all(floats(wheel.get("friction"))[0] == 0.5 for wheel in wheels)
    controls = [control.get("name") for control in root.find("actuator") or ()]
    assert controls == ["cars[0] steering", "cars[0] drive"]


def test_the_path_is_the_middle_of_the_lane() -> None:
    found = testing.sample(HAIRPIN)[0].record
    root = model_of(found)
    x, y = (floats(row.get("data")) for row in list(root.iter("numeric"))[:2])
    road = found.roads[0]
    line = shapely.LineString(np.column_stack((road.x, road.y)))
    away = shapely.distance(line, shapely.points(np.column_stack((x, y))))
    assert away == pytest.approx(1.75, abs=0.02)
    assert (x[0], y[0]) == pytest.approx((3.0, -1.75), abs=0.01)
    assert (x[-1], y[-1]) == pytest.approx((0.0, 25.75), abs=0.01)


def test_a_scene_without_agents_gets_a_car_at_the_start_of_its_longest_road() -> None:
    text = HAIRPIN.partition("agent")[0]
    car = driven_agent(testing.sample(text)[0].record)
    assert (car.x, car.y, car.heading) == pytest.approx((5.0, -1.75, 0.0), abs=1e-3)


@pytest.mark.slow
def test_the_car_stays_within_half_a_meter_of_its_lane(tmp_path: Path, scene: Scene) -> None:
    scenes = {"town": scene, "hairpin": testing.sample(HAIRPIN)[0].record}
    for name in ("hairpin", "roundabout", "street", "network"):
        path = ROOT / "examples" / f"{name}.rl"
        scenes[f"{name}.rl"] = roadlang.load(path).sample(1)[0].record
    models = {name: tmp_path / f"{name}.mjcf.xml" for name in scenes}
    for name, path in models.items():
        path.write_text(MujocoBackend().files(scenes[name])["mjcf.xml"], encoding="utf-8")
    driver = ROOT / "docs" / "examples" / "mujoco_driver.py"
    question = {"driver": str(driver), "models": [str(path) for path in models.values()]}
    answers = ask_tool("mujoco", "mujoco_drives.py", question)
    for name, path in models.items():
        away, share = answers[str(path)]
        assert away < 0.5, name
        assert share > 0.95, name


def test_a_car_that_is_added_takes_no_name_away() -> None:
    text = HAIRPIN.split("agent")[0] + "agent ego is pedestrian on main at 9m\n"
    root = model_of(testing.sample(text + "object ground is cone on main at 20m\n")[0].record)
    bodies = {body.get("name"): body.get("mocap") for body in root.iter("body")}
    assert bodies["ego"] == "true"
    (free,) = root.iter("freejoint")
    assert free.get("name") == "ego car"
    names = [geom.get("name") for geom in root.iter("geom") if geom.get("name")]
    assert len(names) == len(set(names))


@pytest.mark.parametrize("lengths", [(40, 90), (90, 40)])
def test_of_several_roads_the_longest_gets_the_car(lengths: tuple[int, int]) -> None:
    text = "".join(
        f"road r{m} {{ draw with waypoints {{ points: [(0m, {m}m), ({m}m, {m}m)] }} }}\n"
        for m in lengths
    )
    assert driven_agent(testing.sample(text)[0].record).road == "r90"


def test_a_car_is_driven_before_a_bus_that_cannot_turn_as_tight() -> None:
    text = "road main { draw with segments { pieces: [straight(90m)] }, lanes: 2 }\n"
    bus = text + "agent liner is bus on main at 20m\n"
    assert driven_agent(testing.sample(bus)[0].record).name == "liner"
    both = testing.sample(bus + "agent taxi is car on main at 60m\n")[0].record
    assert [agent.name for agent in both.agents] == ["liner", "taxi"]
    assert driven_agent(both).name == "taxi"
