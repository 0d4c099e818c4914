"""A scene file that is edited while it is driven: whoever drives goes on where it is."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

import roadlang
from roadlang_godot.commands.watch import Watcher
from roadlang_godot.editing.live import LiveScene
from roadlang_godot.engines.engine import Engine
from roadlang_godot.net.session import Session
from tests.godot.godot_engines import started, until

pytestmark = pytest.mark.godot

TEXT = """\
image photo from \"\"\"
  ..................
  .################.
  ..................
\"\"\" { scale: 10m/px, legend: { "#": road } }
network drawn from photo
road bent from drawn { width: 8m, perturb with sine { amplitude: 2m, wavelength: 60m } }
road main {
  draw with waypoints {
    points: [(0m, 100m), (60m, 100m), (120m, 110m), (180m, 100m), (240m, 100m), (300m, 120m)]
  }
  width: 8m, lanes: 2
}
agent ego is car on main at 5m { start_speed: 8m/s, drive with stanley { speed: 9m/s } }
agent lead is car on main at 25m {
  start_speed: 8m/s
  drive with traffic { speed: 8m/s }
  drive with change_lane { to: left, force: true, duration: 6s }
}
agent other is car on bent at 5m {
  start_speed: 6m/s
  drive with lane_follow { speed: 6m/s }
  drive with brake { deceleration: 2m/s^2, when: time > 400s }
}
agent child is pedestrian on main at 200m { side: right, offset: 1m, height: 1.7m, drive with walk }
object oak is tree at (150m, 60m)
world { friction: 0.9 }
"""


@pytest.fixture(scope="module")
def engine() -> Iterator[Engine]:
    with started() as engine:
        yield engine


class Edited:
    """A watched file that is edited while its agents drive."""

    def __init__(self, session: Session, file: Path, text: str = TEXT) -> None:
        file.write_text(text, encoding="utf-8")
        self.file = file
        loaded = roadlang.load(file)
        self.watcher = Watcher(loaded, 0, "mesh", save=False)
        self.live: LiveScene = self.watcher.start(session, loaded.sample(1, seed=0)[0].record)

    def now(self) -> tuple[float, dict[str, np.ndarray]]:
        """The time of the last sample, and x, y and speed of every agent then."""
        trace = self.live.trace()
        assert trace is not None
        agents = {name: trace.agents[name] for name in self.live.layout.agents}
        return float(trace.time[-1]), {
            name: np.array([agent.x[-1], agent.y[-1], agent.speed[-1]])
            for name, agent in agents.items()
        }

    def drive(self, seconds: float) -> None:
        """Drive on for some time of the scene."""
        until(self._has_samples)
        end = self.now()[0] + seconds
        until(lambda: self._has_samples() and self.now()[0] >= end)

    def edit(self, change: Callable[[str], str]) -> dict[str, tuple[float, float]]:
        """How far each agent was moved by an edit, beyond what its speed explains, in meters, and
        by how much its speed was changed."""
        text = self.file.read_text()
        changed = change(text)
        assert changed != text
        self.file.write_text(changed, encoding="utf-8")
        self.watcher.look(self.live)  # begins to compile it
        while not self._is_compiled():
            self.watcher.listen(self.live)
        time, before = self.now()
        self.watcher.settle(self.live)
        until(self._has_samples)
        trace = self.live.trace()
        assert trace is not None
        later = float(trace.time[0]) - time
        found = {}
        for name in before.keys() & self.live.layout.agents.keys():
            agent, (x, y, speed) = trace.agents[name], before[name]
            distance = float(np.hypot(agent.x[0] - x, agent.y[0] - y))
            along = 0.5 * (speed + float(agent.speed[0])) * later
            found[name] = abs(distance - along), abs(float(agent.speed[0]) - speed)
        return found

    def _is_compiled(self) -> bool:
        compiling = self.watcher._compiling
        return compiling is not None and compiling.done()

    def _has_samples(self) -> bool:
        self.live.listen(0.02)
        return self.live.trace() is not None


@pytest.fixture
def edited(engine: Engine, tmp_path: Path) -> Iterator[Edited]:
    with engine.connect("edited") as session:
        yield Edited(session, tmp_path / "scene.rl")


def replaced(pattern: str, *values: str) -> Callable[[str], str]:
    """Gives a number of the text the next of its values in turn."""

    def change(text: str) -> str:
        found = re.search(pattern, text)
        assert found is not None, pattern
        at = (values.index(found[1]) + 1) % len(values) if found[1] in values else 0
        return text[: found.start(1)] + values[at] + text[found.end(1) :]

    return change


def toggled(line: str) -> Callable[[str], str]:
    return lambda text: text.replace(line, "") if line in text else text + line


def toggled_after(place: str, option: str) -> Callable[[str], str]:
    """Adds an option at a place, or takes it away."""
    return lambda text: (
        text.replace(option, "") if option in text else text.replace(place, place + option)
    )


EDITS = {
    "a far waypoint": replaced(r"\(300m, (\d+m)\)", "120m", "122m"),
    "the surface of a road": toggled_after("width: 8m, lanes: 2", ", surface: gravel"),
    "a patch of ice": toggled_after(
        "width: 8m, lanes: 2", ", surface_patches: [{ surface: ice, over: [150m, 170m] }]"
    ),
    "a near waypoint": replaced(r"\(60m, (\S+m)\)", "100m", "100.5m"),
    "the perturbation of a photo": replaced(r"amplitude: (\S+m),", "2m", "2.5m"),
    "an option of a controller": replaced(r"stanley \{ speed: (\S+) \}", "9m/s", "10m/s"),
    "another controller": replaced(r"with (\w+) \{ speed: \d+m/s \} \}", "stanley", "pure_pursuit"),
    "the place of an object": replaced(r"at \(150m, (\S+)\)", "60m", "64m"),
    "another object": toggled("object elm is tree at (100m, 60m)\n"),
    "the width of a road": replaced(r"width: (\S+), lanes", "8m", "8.5m"),
    "the lanes of a road": replaced(r"lanes: (\d)", "2", "4"),
    "the friction": replaced(r"friction: (\S+)", "0.9", "0.8"),
    "another agent": toggled("agent late is car on main at 290m { drive with stanley }\n"),
    "the size of an agent": replaced(r"offset: 1m, height: (\S+),", "1.7m", "1.2m"),
}  # fmt: skip


def test_an_edit_of_any_kind_neither_moves_nor_stops_who_drives(edited: Edited) -> None:
    edited.drive(0.5)
    for kind, change in EDITS.items():
        moved = edited.edit(change)
        assert {"ego", "lead", "other", "child"} <= moved.keys(), kind
        for name, (meters, speed) in moved.items():
            assert meters <= 0.05, (kind, name, "no tick of a drive is lost")
            assert speed <= 0.5, (kind, name)
        edited.drive(0.3)
    _, now = edited.now()
    assert now["ego"][2] > 6.0
    assert now["other"][2] > 4.0
    assert now["lead"][1] > now["ego"][1] + 0.5, "the change of lanes went on"


def test_only_an_agent_whose_own_start_was_edited_moves(edited: Edited) -> None:
    edited.drive(2.0)
    moved = edited.edit(replaced(r"lead is car on main at (\S+) ", "25m", "80m"))
    assert moved["lead"][0] > 10.0
    assert max(moved[name][0] for name in ("ego", "other", "child")) <= 0.2
    _, now = edited.now()
    assert now["lead"][0] == pytest.approx(80.0, abs=6.0)


def test_a_controller_that_only_python_has_drives(edited: Edited) -> None:
    edited.drive(1.0)
    first = edited.now()[1]["lead"]
    edited.drive(1.0)
    last = edited.now()[1]["lead"]
    assert last[0] - first[0] > 6.0


def test_an_agent_that_has_left_the_text_is_gone_and_who_comes_has_its_own_state(
    edited: Edited,
) -> None:
    edited.drive(1.0)
    late = "agent late is car on main at 120m { start_speed: 3m/s, drive with stanley }\n"
    edited.edit(lambda text: late + re.sub(r"agent ego .*\n", "", text))
    _, now = edited.now()
    assert set(now) == {"late", "lead", "other", "child"}
    assert now["late"][0] == pytest.approx(120.0, abs=2.0)


def test_whoever_drives_on_a_surface_that_was_edited_has_its_grip(edited: Edited) -> None:
    """Braking with 8 m/s^2 on asphalt is 3 m/s^2 on snow, and less than 5.5 beside the road."""
    edited.edit(toggled_after("width: 8m, lanes: 2", ", surface: snow"))
    fast = "start_speed: 15m/s, drive with stanley { speed: 15m/s }"
    stop = "drive with brake { deceleration: 8m/s^2 }"
    ego_line = f"agent ego is car on main at 5m {{ {fast} {stop} }}\n"
    edited.edit(lambda text: re.sub(r"agent ego .*\n", ego_line, text))
    edited.drive(0.8)
    trace = edited.live.trace()
    assert trace is not None
    ego, time = trace.agents["ego"], trace.time
    assert ego.speed[0] > 10.0
    assert 1.0 < (ego.speed[0] - ego.speed[-1]) / (time[-1] - time[0]) < 5.5
