"""The sensors of agents: what each is called."""

from __future__ import annotations

from ...diagnostics import Code, Label, Span
from ...ir.scenario import ScenarioSensor
from ...ir.values import PassCall
from ...syntax.tree import nodes as ast
from ..checker import Checker


def sensors_of(
    checker: Checker, statement: ast.Actor, passes: tuple[PassCall, ...]
) -> tuple[ScenarioSensor, ...]:
    """The sensors among the passes of an agent, named as written or after their kinds. RL256 for a
    name that another has."""
    written = statement.block.passes if statement.block is not None else ()
    found: list[ScenarioSensor] = []
    first: dict[str, Span] = {}
    for item, call in zip(written, passes, strict=True):
        if call.verb != "sense":
            continue
        name = item.label.text if item.label is not None else item.kind.text.rpartition(".")[2]
        span = item.kind.span if item.label is None else item.label.span
        if name in first:
            labels = [Label(first[name], "the first one")]
            agent = statement.name.text
            checker.report(Code.DUPLICATE_SENSOR, span, labels=labels, name=agent, sensor=name)
        first.setdefault(name, span)
        found.append(ScenarioSensor(name, call))
    return tuple(found)
