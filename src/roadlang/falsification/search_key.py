"""A digest of all that the outcomes of a search depend on: only its own journal can be resumed."""

from __future__ import annotations

import dataclasses
import hashlib
import json
from pathlib import Path
from typing import Any

from ..ir.scenario import FileSource, Scenario, ScenarioImage, ScenarioNetwork, ScenarioRoad
from ..ir.scenario_json import scenario_to_json
from .evaluator import Task
from .plan import Plan

_STOP_RULES = ("evaluations", "failures", "seconds")


def search_key(task: Task, plan: Plan) -> str:
    """Stop rules are left out: a finished search can be resumed with others."""
    settings = {
        field.name: getattr(plan, field.name)
        for field in dataclasses.fields(plan)
        if field.name not in (*_STOP_RULES, "searcher", "entry", "span")
    }
    searcher = {"kind": plan.entry.qualified, "options": dataclasses.asdict(plan.searcher)}  # type: ignore[call-overload]
    return digest(
        task.scenario,
        {
            **settings,
            "searcher": searcher,
            "expects": task.expects,
            "engine": task.engine,
            "options": dict(task.options),
        },
    )


def digest(scenario: Scenario, settings: dict[str, Any]) -> str:
    """SHA-256 of a scenario, its input files and the settings of a run."""
    record = scenario_to_json(scenario)
    text = json.dumps([_without_places(record), settings], sort_keys=True, default=str)
    content = hashlib.sha256(text.encode())
    declarations: tuple[ScenarioImage | ScenarioNetwork | ScenarioRoad, ...] = (
        *scenario.images, *scenario.networks, *scenario.roads
    )  # fmt: skip
    for declaration in declarations:
        source = declaration.source
        if isinstance(source, FileSource):
            path = Path(source.resolved)
            content.update(path.read_bytes() if path.is_file() else b"")
    return content.hexdigest()


_PLACES = ("span", "option_spans", "resolved")


def _without_places(value: Any) -> Any:
    """The record without places in the source, which change with every comment."""
    if isinstance(value, dict):
        return {k: _without_places(v) for k, v in value.items() if k not in _PLACES}
    if isinstance(value, list | tuple):
        return [_without_places(item) for item in value]
    return value
