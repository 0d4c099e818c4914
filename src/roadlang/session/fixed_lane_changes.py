"""Changes to a lane beside that of an agent at its start, where the road has no such lane."""

from __future__ import annotations

from collections.abc import Iterator

from ..diagnostics import Code, Diagnostic, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioActor
from ..ir.values import PassCall, TextValue
from ..plugins.kinds import Controller
from ..world.lane_plan import is_left

_SIDES = {"left": -1, "right": 1}
"""Steps in the list of lanes, which is from left to right."""


def lanes_not_beside(
    actor: ScenarioActor, lane: int, lanes: tuple[int, ...], scenario: IndexedScenario
) -> Iterator[Diagnostic]:
    """RL613 for `left` or `right` in the options of a controller that hold a lane
    (`Controller.lane_options`), where nothing is on that side of `lane`, in which the agent starts.

    Only where the agent changes lanes once and at once: otherwise it may be in another lane then.
    """
    maneuvers = [call for call in actor.drive if _leaves_open(call, scenario)]
    if lane not in lanes or not _drives_forward(actor, lane, scenario) or len(maneuvers) != 1:
        return
    call = maneuvers[0]
    kind = scenario.kind(call)[1]
    if not issubclass(kind, Controller) or call.common:
        return
    for option in kind.lane_options:
        side = _word(option, call, scenario)
        beside = lanes.index(lane) + _SIDES.get(side, 0)
        if not 0 <= beside < len(lanes):
            yield diagnose(
                Code.UNKNOWN_LANE,
                call.option_spans.get(option, call.span),
                road=actor.on,
                lane=f"to the {side} of {lane}",
                help=f"its lanes from left to right are {', '.join(map(str, lanes))}",
            )


def _leaves_open(call: PassCall, scenario: IndexedScenario) -> bool:
    """Whether the kind is a maneuver, which may leave the lane."""
    kind = scenario.kind(call)[1]
    return issubclass(kind, Controller) and bool(kind.leaves_open)


def _drives_forward(actor: ScenarioActor, lane: int, scenario: IndexedScenario) -> bool:
    """Whether it surely drives along its road: there lanes are listed as it sees them."""
    turned = actor.options.keys() & {"heading", "facing", "route"}
    return lane < 0 and not turned and not is_left(scenario)


def _word(option: str, call: PassCall, scenario: IndexedScenario) -> str:
    """The word that an option holds; empty for a number, and where draws decide."""
    if option not in call.options:
        known = {schema.name: schema.default for schema in scenario.kind(call)[0].options}
        return str(known[option])
    value = scenario.resolved(call.options[option])
    return value.value if isinstance(value, TextValue) else ""
