"""What the reference says of each statement: its form, its meaning, its options, an example."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..plugins.options import OptionSchema
from .lower.statements import STATEMENTS


@dataclass(frozen=True, slots=True)
class StatementReference:
    """A statement as the reference and `roadlang explain` show it."""

    word: str
    form: str
    help: str
    example: str

    @property
    def options(self) -> tuple[OptionSchema, ...]:
        """The options of its block."""
        return STATEMENTS[self.word].schema if self.word in STATEMENTS else ()

    @property
    def passes(self) -> Mapping[str, tuple[OptionSchema, ...]]:
        """The verbs of the passes in its block, each with the options that all its kinds have."""
        if self.word not in STATEMENTS:
            return {}
        spec = STATEMENTS[self.word]
        return {verb: spec.common_options(verb) for verb in spec.verbs}


_ROAD = "road main { draw with waypoints { points: [(0m, 0m), (160m, 0m)] } }\n"

REFERENCE = (
    StatementReference(
        "scenario",
        'scenario NAME "title"',
        "Names the scenario. Optional; by default its name is that of the file.",
        'scenario hairpin "A hairpin, bent at random"',
    ),
    StatementReference(
        "include",
        'include "FILE" { PARAM: value }',
        "Adds the declarations of another scene file and sets its params. Paths are relative to "
        "this file.",
        'include "street.rl"',
    ),
    StatementReference(
        "override",
        "override NAME { ... }",
        "Replaces options and passes of an image, network, road, agent or object that an included "
        "file declares. An option replaces that option; passes of a verb (`drive with`, ...) "
        "replace all passes of that verb; the rest stays.",
        'include "street.rl" as left\noverride left.street { width: 6m }',
    ),
    StatementReference(
        "param",
        "param NAME = value",
        "A value that can be set from outside: by `--set NAME=value`, or by a file that includes "
        "this one.",
        "param reach = 8m",
    ),
    StatementReference(
        "let",
        "let NAME = value",
        "A name for a number, a signal or a formula. It cannot be set from outside.",
        _ROAD + "let bend = abs(curvature(main))\nrequire gentle: always (bend < 0.1/m)",
    ),
    StatementReference(
        "image",
        "image NAME from SOURCE { ... }",
        "An image of roads from above: a file, a text between triple quotes, or another image.",
        'image plan from """\n  ####T\n""" { scale: 8m/px, legend: { "#": road, "T": tree } }',
    ),
    StatementReference(
        "network",
        "network NAME from SOURCE { ... }",
        "A road network: extracted from an image, read from a file, or derived from another "
        "network.",
        'image photo from "hairpin.jpg" { scale: 0.35m/px }\nnetwork town from photo',
    ),
    StatementReference(
        "road",
        "road NAME from SOURCE { ... }",
        "A single road: selected from a network, read from a file, derived from another road, or, "
        "without `from`, drawn.",
        _ROAD + "road bent from main {\n  perturb with sine { amplitude: 0m..4m, wavelength: 90m }"
        "\n  width: 7m\n}",
    ),
    StatementReference(
        "require",
        "require NAME: formula { ... }",
        "A requirement: only scenes that satisfy it are generated. The block is optional. "
        "`require NAME with KIND { ... }` uses a monitor of a plugin.",
        _ROAD + "require gentle: always (abs(curvature(main)) < 0.1/m)",
    ),
    StatementReference(
        "expect",
        "expect NAME: formula { ... }",
        "An expectation of the system under test: judged over roads when scenes are generated, and "
        "over drives when they are driven. The block is optional. `expect NAME with KIND { ... }` "
        "uses a monitor of a plugin.",
        _ROAD + "agent ego is car on main at 5m { drive with pure_pursuit }\n"
        "expect arrives: eventually[0s, 90s] (ego.progress > 95%)",
    ),
    StatementReference(
        "agent",
        "agent NAME is KIND on ROAD at POSITION { ... }",
        "Something that moves. `at` is an arc length, a percentage of the length of the road, or, "
        "without `on`, a point. `on` also takes a network, in which a `route` may stand for `at`.",
        _ROAD + "agent ego is car on main at 5m { lane: -1, drive with lane_follow }",
    ),
    StatementReference(
        "object",
        "object NAME is KIND on ROAD at POSITION { ... }",
        "Something that does not move. `at` is an arc length, a percentage of the length of the "
        "road, or, without `on`, a point.",
        _ROAD
        + "object trees is tree on main at 0%..100% { count: 12, side: left, offset: 2m..6m }",
    ),
    StatementReference(
        "world",
        "world { ... }",
        "Light, weather and friction. At most one.",
        "world { time_of_day: 14h, weather: rain, rain: 5mm/h, friction: 0.4..0.9 }",
    ),
    StatementReference(
        "sample",
        "sample with KIND { ... }",
        "How random values are drawn: `random` (the default), `grid`, `halton` or `guided`. At "
        "most one.",
        "param width = 6m..9m\nsample with grid { steps: 4 }",
    ),
    StatementReference(
        "simulate",
        "simulate with KIND { ... }",
        "The simulator in which `roadlang run` drives scenes. At most one.",
        _ROAD + "simulate with godot { duration: 30s }",
    ),
    StatementReference(
        "falsify",
        "falsify with KIND { ... }",
        "How `roadlang falsify` searches for scenes that violate an expectation: `cma` (the "
        "default), `random`, `halton` or `grid`. At most one.",
        _ROAD
        + "agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s..20m/s } }\n"
        "expect in_lane: always (abs(ego.cross_track_error) < 1.5m)\n"
        "falsify with cma { expects: in_lane, evaluations: 500 }",
    ),
    StatementReference(
        "emit",
        "emit KIND { ... }",
        "An output. A file without any `emit` writes JSON and SVG. `roadlang compile` writes the "
        "files of scenes, `roadlang run` those of drives.",
        _ROAD + "emit svg { size: 800px }",
    ),
)
"""The statements in the order of the language reference."""

BY_WORD = {statement.word: statement for statement in REFERENCE}
