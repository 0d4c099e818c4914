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
from ..infer.statement_options import (
    FormulaOptions,
    ImageOptions,
    NetworkOptions,
    RoadOptions,
    WorldOptions,
)
from ..infer.statement_spec import StatementSpec
from .actors import lower_actor
from .constraints import lower_constraint
from .geometry import lower_geometry
from .named_values import lower_value
from .run import lower_emit, lower_run_step
from .settings import lower_settings

_SPECS = (
    StatementSpec("param", "values", lower_value),
    StatementSpec("let", "values", lower_value),
    StatementSpec("image", "images", lower_geometry, ImageOptions, {"read": None, "adjust": None}),
    StatementSpec(
        "network", "networks", lower_geometry, NetworkOptions,
        {"extract": None, "read": None, "perturb": NetworkPerturbOptions,
         "control": ControlOptions},
    ),
    StatementSpec(
        "road", "roads", lower_geometry, RoadOptions,
        {"draw": None, "read": None, "perturb": PerturbOptions},
    ),
    StatementSpec("require", "requirements", lower_constraint, FormulaOptions, as_written=True),
    StatementSpec("expect", "expectations", lower_constraint, FormulaOptions, as_written=True),
    StatementSpec(
        "agent", "agents", lower_actor, AgentOptions,
        {"drive": DriveOptions, "sense": SenseOptions},
    ),
    StatementSpec("object", "objects", lower_actor, PlacementOptions),
    StatementSpec("world", "world", lower_settings, WorldOptions, once=True),
    StatementSpec("sample", "sample", lower_run_step, once=True),
    StatementSpec("simulate", "simulate", lower_run_step, once=True, default_kind="builtin"),
    StatementSpec("falsify", "falsify", lower_run_step, FalsifyOptions, once=True),
    StatementSpec("emit", "emits", lower_emit, as_written=True),
)  # fmt: skip
STATEMENTS: dict[str, StatementSpec] = {spec.word: spec for spec in _SPECS}
