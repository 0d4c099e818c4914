"""Which lanes the statements of a scenario give a road. Imports no numpy: `check` asks for it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from ...diagnostics import Code, DiagnosticError, diagnose
from ...evaluate.indexed_scenario import IndexedScenario
from ...geometry.lanes.lanes import Direction, lane_ids
from ...ir.scenario import LANE_OPTIONS, ScenarioNetwork, ScenarioRoad
from ...ir.values import Flag, Items, PassCall, TextValue, Value
from ...plugins.kinds import LaneKind


@dataclass(frozen=True)
class LanePlan:
    """What is written about the lanes of a road or network, there or in what it is made from.

    `owner` is the nearest statement that counts or lists lanes. Where it lists them, only what is
    said there or nearer counts, but for the speed limit; each of the others is the nearest.
    """

    owner: ScenarioRoad | ScenarioNetwork | None
    lanes: Value | None = None
    left: Value | None = None
    right: Value | None = None
    oneway: Value | None = None
    sidewalks: Value | None = None
    center_marking: Value | None = None
    speed_limit: Value | None = None
    source: ScenarioRoad | ScenarioNetwork | None = field(default=None, compare=False)
    """Whose lanes these are."""

    @property
    def has_lists(self) -> bool:
        """Whether the lanes are listed, rather than counted."""
        return self.left is not None or self.right is not None


def lane_plan(source: ScenarioRoad | ScenarioNetwork, scenario: IndexedScenario) -> LanePlan:
    """What holds for a road or network, its own statement before those that it is made from."""
    chain = [
        link for link in scenario.chain(source) if isinstance(link, ScenarioRoad | ScenarioNetwork)
    ]
    owner = next((link for link in chain if _names_lanes(link)), None)
    nearest = {name: _nearest(chain, name) for name in LANE_OPTIONS}
    if owner is not None and owner.options.keys() & {"left", "right"}:
        # Lists say everything: what is said further down was about other lanes.
        above = chain[: chain.index(owner) + 1]
        shape = ("left", "right", "oneway", "center_marking")
        nearest.update({name: _nearest(above, name) for name in shape}, lanes=None, sidewalks=None)
    elif owner is not None:
        nearest.update(left=None, right=None)
    return LanePlan(owner, **nearest, source=source)


def _names_lanes(link: ScenarioRoad | ScenarioNetwork) -> bool:
    return bool(link.options.keys() & {"lanes", "left", "right"})


def _nearest(chain: list[ScenarioRoad | ScenarioNetwork], name: str) -> Value | None:
    return next((link.options[name] for link in chain if name in link.options), None)


def lane_calls(value: Value | None, scenario: IndexedScenario) -> tuple[PassCall, ...] | None:
    """The calls of a list of lanes, from the middle outwards; None where they are drawn."""
    if value is None:
        return ()
    written = scenario.resolved(value)
    if not isinstance(written, Items):
        return None
    found = (scenario.resolved(item) for item in written.items)
    calls = tuple(call for call in found if isinstance(call, PassCall))
    return calls if len(calls) == len(written.items) else None


def is_fixed(plan: LanePlan, scenario: IndexedScenario) -> bool:
    """Whether all candidates have the same lanes, apart from their widths and speed limits."""
    lists = (lane_calls(value, scenario) for value in (plan.left, plan.right))
    words = (plan.lanes, plan.oneway, plan.center_marking, traffic_side(scenario))
    drawn = scenario.dependencies.draws(*(value for value in words if value is not None))
    return not drawn and None not in tuple(lists)


def traffic_side(scenario: IndexedScenario) -> Value:
    """`right` or `left`, as `world` says."""
    return dict(scenario.source.world).get("traffic", TextValue("right"))


def known_ids(plan: LanePlan, scenario: IndexedScenario) -> tuple[int, ...] | None:
    """The ids of the lanes from left to right; None where they differ between scenes, or where
    nothing is written of them."""
    if plan.owner is None or not is_fixed(plan, scenario):
        return None
    if plan.has_lists:
        left, right = (lane_calls(value, scenario) for value in (plan.left, plan.right))
        assert left is not None
        assert right is not None
        return (*range(len(left), 0, -1), *range(-1, -len(right) - 1, -1))
    assert plan.lanes is not None
    low, high = scenario.value_bounds.of(plan.lanes)
    if low != high:
        return None
    extra = 0 if plan.sidewalks is None else 1
    return counted_ids(round(low), plan.oneway == Flag(True), is_left(scenario), extra)


def is_left(scenario: IndexedScenario) -> bool:
    """Whether vehicles drive on the left, where that is no draw."""
    return traffic_side(scenario) == TextValue("left")


def counted_ids(count: int, oneway: bool, left_hand: bool, extra: int = 0) -> tuple[int, ...]:
    """The ids of this many driving lanes with `extra` lanes on either side, from left to right."""
    ids = tuple(range(-1, -count - 1, -1)) if oneway else lane_ids(count)
    left, right = sum(id > 0 for id in ids) + extra, sum(id < 0 for id in ids) + extra
    if left_hand:
        left, right = right, left
    return (*range(left, 0, -1), *range(-1, -right - 1, -1))


def side_directions(oneway: bool, left_hand: bool) -> tuple[Direction, Direction]:
    """Where traffic runs on the left and on the right of the middle of a road."""
    if oneway:
        return "forward", "forward"
    return ("forward", "backward") if left_hand else ("backward", "forward")


def default_lane_kind(scenario: IndexedScenario, *, drivable: bool) -> type[LaneKind]:
    """The shipped kind that `lanes` or `sidewalks` stand for. Raises RL471 if it is missing."""
    for entry in scenario.registry.defaults("lane"):
        kind: Any = entry.load()
        if kind.drivable == drivable:
            found: type[LaneKind] = kind
            return found
    raise DiagnosticError(diagnose(Code.KIND_NOT_INSTALLED, None, kind="lane"))
