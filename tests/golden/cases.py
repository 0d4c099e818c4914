"""The golden cases: a name, what makes its lines, and how far its numbers may be off."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Any

from tests.golden.command_views import SEQUENCES, sequence_lines
from tests.golden.comparing import FIGURE, NUMBERS
from tests.golden.constant_views import PACKAGES, constant_lines
from tests.golden.engine_views import layout_lines
from tests.golden.extraction_views import evidence_lines, picture_lines
from tests.golden.file_views import file_lines
from tests.golden.fold_views import fold_lines
from tests.golden.formula_views import (
    formula_lines,
    mining_lines,
    online_lines,
    plot_lines,
    range_lines,
)
from tests.golden.geometry_views import curve_lines, junction_lines, rectangle_lines
from tests.golden.habit_views import checked_habit_lines, fault_of_sample_lines, habit_lines
from tests.golden.handle_views import edit_lines, handle_lines
from tests.golden.interface_views import interface_lines
from tests.golden.language_views import command_output, fault_lines, kind_lines, scenario_lines
from tests.golden.map_views import (
    broken_map_lines,
    opendrive_lines,
    place_lines,
    street_map_lines,
    written_map_lines,
)
from tests.golden.mistake_views import edited_mistake_lines, mistake_lines, set_lines
from tests.golden.object_views import scene_object_lines, search_object_lines
from tests.golden.odd_kind_views import odd_kind_lines
from tests.golden.random_views import mapped_lines, random_lines, town_lines
from tests.golden.road_views import joined_lines, network_lines, section_lines
from tests.golden.scene_views import (
    console_lines,
    drive_lines,
    figure_lines,
    sampled,
    scene_lines,
)
from tests.golden.search_views import command_lines, environment_lines, search_lines, vector_lines
from tests.golden.traffic_views import option_lines, street_lines, traffic_lines
from tests.golden.tweaked_views import tweaked_lines
from tests.golden.written_views import ROUNDED, written_lines


@dataclass(frozen=True)
class Case:
    """Lines that are stored in `expected/NAME.txt`; `room` is the test file that compares them."""

    room: str
    name: str
    lines: Callable[[], Iterable[str]]
    absolute: float = NUMBERS


STILL = {
    "pieces": 1,
    "bent": 2,
    "values": 3,
    "picture": 2,
    "table": None,
    "grid": None,
    "guided": 3,
    "halton": 3,
    "places": 2,
    "right_places": 2,
    "drawn": 4,
    "approaches": 1,
    "copies": 3,
}
TOWNS = ("town", "cross_right", "cross_signals", "cross_stop", "cross_all_way", "cross_yield")
DRIVEN = (
    "controllers",
    "lane_changes",
    "overtake",
    "replay",
    "conditions",
    "lap",
    "roundabout",
    "joined",
    "tour",
    *TOWNS,
)
FIGURES = (
    "pieces",
    "bent",
    "values",
    "picture",
    "town",
    "cross_signals",
    "roundabout",
    "conditions",
    "lap",
    "joined",
    "drawn",
    "tour",
)
OTHER_FIGURES: dict[str, dict[str, Any]] = {
    "bent": {"size": 300.0, "ghost": False, "profiles": False},
    "values": {"size": 260.0, "stations": False},
    "controllers": {"labels": False, "legend": False},
    "right_places": {"size": 400.0},
    "cross_stop": {"size": 2000.0, "labels": False},
    "copies": {"size": 150.0},
}
BUILT = (
    *("pieces", "values", "town", "cross_signals", "controllers", "picture", "roundabout"),
    *("joined", "tour"),
)
WRITTEN = (
    *("cross_signals", "cross_stop", "cross_right", "tour", "joined", "lap", "values", "pieces"),
    *("bent", "places", "right_places", "drawn"),
)
EXPORTED = ("values", "cross_signals", "conditions", "lap", "places")
HANDLED = (
    *("pieces", "bent", "values", "town", "picture", "controllers", "tour", "joined", "drawn"),
    *("copies", "lap", "places"),
)
SOURCES = (
    "pieces",
    "bent",
    "values",
    "town",
    "picture",
    "controllers",
    "lane_changes",
    "search",
    "cross_signals",
    "guided",
    "replay",
    "drawn",
    "tour",
)
TWEAKED = {
    "pieces": 6,
    "bent": 5,
    "values": 5,
    "town": 2,
    "places": 3,
    "right_places": 1,
    "picture": 2,
    "table": 4,
    "search": 4,
    "drawn": 1,
    "approaches": 4,
    "copies": 5,
    "joined": 4,
}
TWEAKED_TWICE = ("controllers", "lane_changes", "replay")
"""Until one of their changes can be driven."""
COMMANDS = (
    ("plugins", "show", "car"),
    ("plugins", "show", "segments"),
    ("plugins", "show", "world"),
    ("plugins", "show", "traffic"),
    ("plugins", "--verb", "emit"),
    ("plugins", "--verb", "drive", "--json"),
    ("explain", "RL206"),
    ("explain", "agent"),
    ("schema", "json"),
    ("schema", "segments"),
    ("schema", "drive", "traffic"),
    ("schema", "manifest"),
    ("schema", "trace"),
    ("schema", "scene"),
    ("schema", "scenario"),
    ("check", "--scenario", "grid.rl"),
    ("check", "--json", "bent.rl"),
    ("fmt", "--diff", "bent.rl"),
    ("fmt", "--check", "town.rl", "pieces.rl"),
    ("plugins", "show", "sign"),
    ("explain", "RL9999"),
    ("schema", "sing"),
)


def _scenes(name: str, count: int | None) -> Iterable[str]:
    return scene_lines(sampled(name, count))


def _drive(name: str) -> Iterable[str]:
    return drive_lines(sampled(name, 1)[0].run())


def _figure(name: str) -> Iterable[str]:
    return figure_lines(sampled(name, 1))


def _other_figure(name: str, options: dict[str, Any]) -> Iterable[str]:
    return figure_lines(sampled(name, 1), **options)


def _built(name: str, road: str) -> Iterable[str]:
    return layout_lines(sampled(name, 1)[0], road)


def _cases() -> Iterable[Case]:
    for name, count in STILL.items():
        yield Case("scenes", f"{name}.scenes", partial(_scenes, name, count))
    for name in DRIVEN:
        yield Case("drives", f"{name}.scene", partial(_scenes, name, 1))
        yield Case("drives", f"{name}.drive", partial(_drive, name))
    yield Case("drives", "traffic.drive", partial(traffic_lines, range(9), 10.0))
    yield Case("drives", "options.drive", partial(option_lines, 5.0))
    yield Case("drives", "streets.drive", partial(street_lines, 15.0))
    for first in range(0, 96, 24):
        yield Case("tweaks", f"random.{first}", partial(random_lines, range(first, first + 3)))
    for first in (0, 24):
        yield Case("towns", f"towns.{first}", partial(town_lines, range(first, first + 3)))
    yield Case("towns", "towns.mapped", partial(mapped_lines, range(3)))
    yield Case("mistakes", "odd_kinds", odd_kind_lines)
    for name in FIGURES:
        yield Case("scenes", f"{name}.figure", partial(_figure, name), FIGURE)
    for name, options in OTHER_FIGURES.items():
        yield Case("scenes", f"{name}.figure_with", partial(_other_figure, name, options), FIGURE)
    for name in BUILT:
        yield Case("engine", f"{name}.mesh", partial(_built, name, "mesh"))
    yield Case("engine", "picture.tiles", partial(_built, "picture", "tiles"))
    yield Case("scenes", "pieces.console", partial(console_lines, "pieces", "-n", "2"))
    yield Case("scenes", "table.console", partial(console_lines, "table", "-n", "4"))
    for name, changes in TWEAKED.items():
        yield Case("tweaks", f"{name}.tweaks", partial(tweaked_lines, name, changes))
    for name in (*TWEAKED_TWICE, "conditions", "lap", "cross_stop", "joined"):
        changes = 2 if name in TWEAKED_TWICE else 1
        yield Case("tweaks", f"{name}.driven", partial(tweaked_lines, name, changes, drive=True))
    yield Case("extraction", "evidence", partial(evidence_lines, 1, 2), FIGURE)
    yield Case("extraction", "pictures", partial(picture_lines, 1, 2), FIGURE)
    for first in (1, 2, 3):
        yield Case("geometry", f"junctions.{first}", partial(junction_lines, 100 * first, 10))
    yield Case("geometry", "curves", partial(curve_lines, 1, 16))
    yield Case("geometry", "rectangles", partial(rectangle_lines, 1, 8))
    yield Case("geometry", "sections", partial(section_lines, 1, 16))
    yield Case("geometry", "joined", partial(joined_lines, 1, 8))
    yield Case("geometry", "networks", partial(network_lines, 1, 3))
    yield Case("geometry", "folds", partial(fold_lines, 1, 9))
    yield Case("handles", "edits", edit_lines)
    for name in HANDLED:
        yield Case("handles", f"{name}.handles", partial(handle_lines, name))
    yield Case("maps", "places_on_earth", place_lines)
    yield Case("maps", "opendrive_maps", partial(opendrive_lines, 1, 9))
    yield Case("maps", "street_maps", partial(street_map_lines, 1, 6))
    yield Case("maps", "broken_maps", partial(broken_map_lines, 1))
    for name in WRITTEN:
        yield Case("maps", f"{name}.map", partial(written_map_lines, name))
    for name in EXPORTED:
        yield Case("maps", f"{name}.formats", partial(written_lines, name), ROUNDED)
    driven = partial(written_lines, "conditions", driven=True)
    yield Case("maps", "conditions.driven_formats", driven, ROUNDED)
    yield Case("formulas", "formulas", partial(formula_lines, 1, 50))
    yield Case("formulas", "ranges", partial(range_lines, 1000, 160))
    yield Case("formulas", "mining", mining_lines)
    late = partial(formula_lines, 501, 40, contextual=True)
    yield Case("formulas", "contextual_formulas", late)
    yield Case("formulas", "online", partial(online_lines, 1, 40))
    yield Case("formulas", "plot", plot_lines, FIGURE)
    for name in SOURCES:
        yield Case("language", f"{name}.faults", partial(fault_lines, name, 30))
        yield Case("language", f"{name}.scenario", partial(scenario_lines, name))
    yield Case("language", "mistakes", mistake_lines)
    yield Case("mistakes", "mistakes_edited", partial(edited_mistake_lines, 1))
    yield Case("mistakes", "habits", partial(habit_lines, 5))
    yield Case("mistakes", "habits_checked", partial(checked_habit_lines, 1))
    yield Case("mistakes", "faults_of_samples", partial(fault_of_sample_lines, 4))
    yield Case("language", "files", file_lines, FIGURE)
    yield Case("language", "kinds", kind_lines)
    yield Case("language", "set", set_lines)
    yield Case("language", "interface", interface_lines)
    for package in PACKAGES:
        yield Case("constants", f"{package}.constants", partial(constant_lines, package))
    yield Case("language", "commands", partial(command_output, COMMANDS))
    for name in SEQUENCES:
        yield Case("searches", f"{name}.commands", partial(sequence_lines, name), FIGURE)
    for name in ("values", "cross_signals", "tour"):
        yield Case("scenes", f"{name}.objects", partial(scene_object_lines, name))
    yield Case("searches", "search.objects", partial(search_object_lines, "search"))
    few = {"evaluations": 12, "batch": 6}
    for kind in ("cma", "elites", "random", "grid", "halton"):
        worst = kind == "cma"
        lines = partial(search_lines, "search", worst, searcher=kind, **few)
        yield Case("searches", f"search.{kind}", lines)
    falsify = ("falsify", "--evaluations", "12", "--seed", "5", "--batch", "6")
    yield Case("searches", "search.page", partial(command_lines, *falsify), FIGURE)
    yield Case("searches", "run.page", partial(command_lines, "run", "-n", "2"), FIGURE)
    yield Case("searches", "rival.env", partial(environment_lines, "rival", scenes=3))
    changed = partial(
        environment_lines, "rival", scenes=2, scene_seed=3, step=0.2, vehicle_step=0.02,
        acceleration=2.0, deceleration=3.0, distances=(3.0, 12.0), agents=1, off_road_ends=False,
        agent="rival",
    )  # fmt: skip
    yield Case("searches", "rival.changed", changed)
    side_by_side = partial(vector_lines, "rival", 5, scenes=6, duration=5.0)
    yield Case("searches", "rival.envs", side_by_side)
    alone = partial(vector_lines, "rival", 1, scenes=2, duration=3.0, reward="ego.speed < 9m/s")
    yield Case("searches", "rival.alone", alone)


CASES = {case.name: case for case in _cases()}
