"""The sampler of a scenario, and the draws as samplers see them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ..evaluate.candidates import fixed_candidate
from ..evaluate.evaluation import build
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import KindInstance
from ..ir.values import NO_OPTIONS, PassCall, RandomValue
from ..plugins.guard import wrong_result
from ..plugins.kinds import implements

Progress = Callable[[int, int], None]
"""Called with how much is done and how much there is to do."""


def sampler_of(scenario: IndexedScenario) -> KindInstance:
    """The `sample with` of the file, or the default."""
    call = scenario.source.sample or _default_call(scenario)
    return build(call, fixed_candidate(scenario), single=True)


def _default_call(scenario: IndexedScenario) -> PassCall:
    return PassCall("sample", scenario.registry.default("sample").qualified, NO_OPTIONS, "sample")


def is_steering(sampler: KindInstance) -> bool:
    """Whether a sampler proposes candidates from what is known of others."""
    return implements(type(sampler.kind), "steer")


@dataclass(frozen=True)
class DrawnPlace:
    """A draw that is made once for each scene, as samplers see it."""

    draw: RandomValue
    scenario: IndexedScenario

    @property
    def place(self) -> str:
        """The place in the source that the draw belongs to."""
        return self.draw.place

    def levels(self, steps: int) -> Sequence[float]:
        """Numbers in [0, 1] that a grid visits."""
        options = self.draw.call.options
        if self.scenario.dependencies.draws(*(value for value in options.values())):
            return [(step + 0.5) / steps for step in range(steps)]
        built = build(self.draw.call, fixed_candidate(self.scenario), single=True)
        with built.guarded:
            levels = [float(level) for level in built.kind.levels(steps)]
        if not levels or not all(0.0 <= level <= 1.0 for level in levels):
            raise wrong_result(built.entry, built.call.span, "gave no levels within [0, 1]")
        return levels


def drawn_values(scenario: IndexedScenario) -> tuple[DrawnPlace, ...]:
    """All draws made once for each scene, in the order of the scenario."""
    places = {draw.place: draw for draw in scenario.draws() if draw.per == "scene"}
    return tuple(DrawnPlace(draw, scenario) for draw in places.values())
