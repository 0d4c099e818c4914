"""The statements: what the block of each takes, and what it becomes in the scenario."""

from __future__ import annotations

from ...plugins.common_options import (
    AgentOptions,
    ControlOptions,
    DriveOptions,
    FalsifyOptions,
    NetworkPerturbOptions,
    PerturbOptions,
    PlacementOptions,
    SenseOptions,
)
from ...plugins.world_options import WorldOptions
from ..infer.statement_options import (
    FormulaOptions,
    ImageOptions,
    NetworkOptions,
    RoadOptions,
)
from ..infer.statement_spec import StatementSpec
from .actors import lower_actor
from .constraints import lower_constraint
from .geometry import lower_geometry
from .named_values import lower_value
from .run import lower_emit, lower_run_step
from .settings import lower_settings

_ROAD = "road main { draw with waypoints { points: [(0m, 0m), (160m, 0m)] } }\n"

_SPECS = (
    StatementSpec(
        "param",
        "values",
        lower_value,
        form="param NAME = value",
        help=(
            "A value that can be set from outside: by `--set NAME=value`, or by a file that "
            "includes this one."
        ),
        example="param reach = 8m",
    ),
    StatementSpec(
        "let",
        "values",
        lower_value,
        form="let NAME = value",
        help="A name for a number, a signal or a formula. It cannot be set from outside.",
        example=_ROAD + "let bend = abs(curvature(main))\nrequire gentle: always (bend < 0.1/m)",
    ),
    StatementSpec(
        "image",
        "images",
        lower_geometry,
        form="image NAME from SOURCE { ... }",
        help=(
            "An image of roads from above: a file, a text between triple quotes, or another image."
        ),
        example=(
            'image plan from """\n  ####T\n""" { scale: 8m/px, legend: { "#": road, "T": tree } }'
        ),
        options=ImageOptions,
        verbs={"read": None, "adjust": None},
    ),
    StatementSpec(
        "network",
        "networks",
        lower_geometry,
        form="network NAME from SOURCE { ... }",
        help=(
            "A road network: extracted from an image, read from a file, or derived from another"
            " network."
        ),
        example='image photo from "hairpin.jpg" { scale: 0.35m/px }\nnetwork town from photo',
        options=NetworkOptions,
        verbs={
            "extract": None,
            "read": None,
            "perturb": NetworkPerturbOptions,
            "control": ControlOptions,
        },
    ),
    StatementSpec(
        "road",
        "roads",
        lower_geometry,
        form="road NAME from SOURCE { ... }",
        help=(
            "A single road: selected from a network, read from a file, derived from another "
            "road, or, without `from`, drawn."
        ),
        example=(
            _ROAD
            + "road bent from main {\n  perturb with sine { amplitude: 0m..4m, wavelength: 90m }"
            "\n  width: 7m\n}"
        ),
        options=RoadOptions,
        verbs={"draw": None, "read": None, "perturb": PerturbOptions},
    ),
    StatementSpec(
        "require",
        "requirements",
        lower_constraint,
        form="require NAME: formula { ... }",
        help=(
            "A requirement: only scenes that satisfy it are generated. The block is optional. "
            "`require NAME with KIND { ... }` uses a monitor of a plugin."
        ),
        example=_ROAD + "require gentle: always (abs(curvature(main)) < 0.1/m)",
        options=FormulaOptions,
        as_written=True,
    ),
    StatementSpec(
        "expect",
        "expectations",
        lower_constraint,
        form="expect NAME: formula { ... }",
        help=(
            "An expectation of the system under test: evaluated over roads when scenes are "
            "generated, and over drives when they are driven. The block is optional. `expect "
            "NAME with KIND { ... }` uses a monitor of a plugin."
        ),
        example=(
            _ROAD + "agent ego is car on main at 5m { drive with pure_pursuit }\n"
            "expect arrives: eventually[0s, 90s] (ego.progress > 95%)"
        ),
        options=FormulaOptions,
        as_written=True,
    ),
    StatementSpec(
        "agent",
        "agents",
        lower_actor,
        form="agent NAME is KIND on ROAD at POSITION { ... }",
        help=(
            "Something that moves. `at` is an arc length, a percentage of the length of the "
            "road, `random`, a position relative to another agent or object (`ahead_of(lead, "
            "20m)`), or, without `on`, a point. `on` may also be a network, where a `route` may "
            "replace `at`."
        ),
        example=_ROAD + "agent ego is car on main at 5m { lane: -1, drive with lane_follow }",
        options=AgentOptions,
        verbs={"drive": DriveOptions, "sense": SenseOptions},
    ),
    StatementSpec(
        "object",
        "objects",
        lower_actor,
        form="object NAME is KIND on ROAD at POSITION { ... }",
        help=(
            "Something that does not move. `at` is an arc length, a percentage of the length of"
            " the road, or, without `on`, a point."
        ),
        example=(
            _ROAD
            + "object trees is tree on main at 0%..100% { count: 12, side: left, offset: 2m..6m }"
        ),
        options=PlacementOptions,
    ),
    StatementSpec(
        "world",
        "world",
        lower_settings,
        form="world { ... }",
        help="Light, weather, friction and the side of traffic. At most one.",
        example="world { time_of_day: 14h, weather: rain, rain: 5mm/h, friction: 0.4..0.9 }",
        options=WorldOptions,
        once=True,
    ),
    StatementSpec(
        "sample",
        "sample",
        lower_run_step,
        form="sample with KIND { ... }",
        help=(
            "How random values are drawn: `random` (the default), `grid`, `halton` or `guided`."
            " At most one."
        ),
        example="param width = 6m..9m\nsample with grid { steps: 4 }",
        once=True,
    ),
    StatementSpec(
        "simulate",
        "simulate",
        lower_run_step,
        form="simulate with KIND { ... }",
        help="The simulator in which `roadlang run` drives scenes. At most one.",
        example=_ROAD + "simulate with godot { duration: 30s }",
        once=True,
        default_kind="builtin",
    ),
    StatementSpec(
        "falsify",
        "falsify",
        lower_run_step,
        form="falsify with KIND { ... }",
        help=(
            "How `roadlang falsify` searches for scenes that violate an expectation: `cma` (the"
            " default), `elites`, `random`, `halton` or `grid`. At most one."
        ),
        example=(
            _ROAD
            + "agent ego is car on main at 5m { drive with pure_pursuit { speed: 8m/s..20m/s } }\n"
            "expect in_lane: always (abs(ego.cross_track_error) < 1.5m)\n"
            "falsify with cma { expects: in_lane, evaluations: 500 }"
        ),
        options=FalsifyOptions,
        once=True,
    ),
    StatementSpec(
        "emit",
        "emits",
        lower_emit,
        form="emit KIND { ... }",
        help=(
            "An output. A file without any `emit` writes JSON and SVG. `roadlang compile` "
            "writes the files of scenes, `roadlang run` those of drives."
        ),
        example=_ROAD + "emit svg { size: 800px }",
        as_written=True,
    ),
)
STATEMENTS: dict[str, StatementSpec] = {spec.word: spec for spec in _SPECS}
