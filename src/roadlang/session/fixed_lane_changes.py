"""Changes to a lane beside that of an agent at its start, where there is none to change to."""

from __future__ import annotations

from collections.abc import Iterator

from ..diagnostics import Code, Diagnostic, Span, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import ScenarioActor
from ..ir.values import PassCall, TextValue
from ..plugins.guard import plugin_guard
from ..plugins.kinds import Controller
from ..world.lanes.lane_plan import is_left
from ..world.lanes.planned_lanes import PlannedLane
from .constant_kinds import constant_kind

_SIDES = ("left", "right")


def lanes_not_beside(
    actor: ScenarioActor, lane: int, lanes: tuple[PlannedLane, ...], scenario: IndexedScenario
) -> Iterator[Diagnostic]:
    """RL613 for `left` or `right` in the options of a controller that hold a lane
    (`Controller.lane_options`), where nothing is on that side of `lane`, in which the agent starts,
    or nothing that the controller takes (`Controller.takes_lane`).

    Only where the agent changes lanes once and at once: otherwise it may be in another lane then.
    """
    maneuvers = [call for call in actor.drive if _leaves_open(call, scenario)]
    ids = [each.id for each in lanes]
    if lane not in ids or not _drives_forward(actor, lane, scenario) or len(maneuvers) != 1:
        return
    call = maneuvers[0]
    kind = scenario.kind(call)[1]
    if not issubclass(kind, Controller) or call.common:
        return
    for option in kind.lane_options:
        side = _word(option, call, scenario)
        if side in _SIDES:
            place = ids.index(lane)
            beside = lanes[:place] if side == "left" else lanes[place + 1 :]
            if not any(_takes(call, each, scenario) for each in beside):
                name = scenario.kind(call)[0].name if beside else ""
                span = call.option_spans.get(option, call.span)
                yield _no_lane(actor, f"to the {side} of {lane}", name, lanes, span)


def _takes(call: PassCall, lane: PlannedLane, scenario: IndexedScenario) -> bool:
    """Whether the controller may change to a lane: yes where draws have a say."""
    controller = constant_kind(call, scenario)
    if controller is None:
        return True
    with plugin_guard(scenario.kind(call)[0], call.span, call.option_spans):
        return bool(controller.takes_lane(lane.kind, lane.direction == "backward"))


def _no_lane(
    actor: ScenarioActor,
    where: str,
    controller: str,
    lanes: tuple[PlannedLane, ...],
    span: Span | None,
) -> Diagnostic:
    """`controller`: which takes none of the lanes there, if there are any."""
    names = [str(lane.id) for lane in lanes]
    if controller:
        where += f" for `{controller}`"
        names = [f"{lane.id} (`{lane.kind.name}`{_against(lane)})" for lane in lanes]
    help_ = f"its lanes from left to right are {', '.join(names)}"
    return diagnose(Code.UNKNOWN_LANE, span, road=actor.on, lane=where, help=help_)


def _against(lane: PlannedLane) -> str:
    return ", oncoming" if lane.direction == "backward" else ""


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
