"""Points that a searcher screens before they are evaluated, and what is wrong with a searcher."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import DiagnosticError
from roadlang.evaluate.candidates import CandidateBatch
from roadlang.falsification.evaluator import Evaluator, Proposal
from roadlang.geometry import Curve
from roadlang.geometry.arrays import Floats
from roadlang.ir.batch import RoadBatch
from roadlang.judging.acceptance import Acceptance, Measurements
from roadlang.plugins.kinds import Axis, Perturber, Search, Searcher
from roadlang.testing import scenario
from roadlang_standard.draw_segments import Segments
from tests.falsification.slider import FEW, PERTURBED, TEXT, Slider, slides


def test_what_fails_while_points_are_screened_is_not_the_searchers_fault(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def fails(self: Evaluator, points: Floats) -> Floats:
        raise ZeroDivisionError("no fault of a plugin")

    monkeypatch.setattr(Evaluator, "screen", fails)
    with pytest.raises(ZeroDivisionError, match="no fault of a plugin"):
        slides().falsify(**FEW)


@pytest.mark.parametrize("points", [None, 0.5, np.zeros(3), np.full((2, 1), 0.5), "x"])
def test_points_to_screen_that_are_none_are_the_searchers_fault(points: Any) -> None:
    class OddSearch(Search):
        screen: Callable[[Any], Floats]

        def screen_with(self, screen: Callable[[Floats], Floats]) -> None:
            self.screen = screen

        def ask(self, count: int) -> Floats:
            return self.screen(points)

    @dataclass(frozen=True)
    class Odd(Searcher):
        """Screens what are no points."""

        name: ClassVar[str] = "odd"

        def start(self, axes: Sequence[Axis], seed: int) -> Search:
            return OddSearch()

    with pytest.raises(DiagnosticError) as caught:
        scenario(TEXT, kinds=[Slider, Odd]).falsify(**FEW, searcher="odd")
    (found,) = caught.value.diagnostics
    assert found.code == "RL474"
    assert "`falsify tested.odd` (tested 0) gave points" in found.message


@pytest.mark.parametrize("size", [0, 21, 2.0, None])
def test_a_batch_size_that_is_none_is_the_searchers_fault(size: Any) -> None:
    class OddSearch(Search):
        def batch_size(self, most: int) -> int:
            assert most == 20
            return size  # type: ignore[no-any-return]

        def ask(self, count: int) -> Floats:
            raise AssertionError

    @dataclass(frozen=True)
    class Odd(Searcher):
        """Wants no number of candidates."""

        name: ClassVar[str] = "odd"

        def start(self, axes: Sequence[Axis], seed: int) -> Search:
            return OddSearch()

    with pytest.raises(DiagnosticError) as caught:
        scenario(TEXT, kinds=[Slider, Odd]).falsify(**(FEW | {"batch": 20}), searcher="odd")
    (found,) = caught.value.diagnostics
    assert found.code == "RL474"
    assert f"gave the batch size {size!r}, which is no whole number from 1 to 20" in found.message


@dataclass(frozen=True)
class Wander(Perturber):
    """Draws from a generator that no search chooses the numbers of."""

    name: ClassVar[str] = "wander"

    def displacement(self, road: RoadBatch, rng: np.random.Generator) -> Floats:
        wave = np.sin(road.stations / road.stations[-1] * np.pi)
        return np.asarray(wave * rng.uniform(-9.0, 9.0))


@pytest.mark.parametrize("kind", ["harmonics { modes: 6, amplitude: 30m }", "wander"])
def test_what_was_screened_gives_the_same_outcomes_and_is_measured_once(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = TEXT.replace("1 / 14m", "1 / 38m").replace(PERTURBED, f"perturb with {kind}")
    search = scenario(text, kinds=[Slider, Wander]).falsify(**FEW)
    task = search.evaluator.task
    proposals = [Proposal(index, search.outcomes[index].point) for index in range(60, 100)]
    alone = Evaluator(task).evaluate(proposals)
    screening = Evaluator(task)
    for part in (slice(0, 20), slice(20, 30)):  # the last ten are new
        screening.screen(np.array([proposal.point for proposal in proposals[part]]))
    measured: list[int] = []
    measure = Acceptance.measure

    def counted(
        self: Acceptance, candidates: CandidateBatch, *, last: bool = False
    ) -> Measurements:
        if not last:  # room for agents is looked at again
            measured.append(candidates.count)
        return measure(self, candidates, last=last)

    monkeypatch.setattr(Acceptance, "measure", counted)
    assert screening.evaluate(proposals) == alone
    # What depends on the number of the candidate as well is another one when it is evaluated.
    assert measured == ([40] if kind == "wander" else [10])


DRAWN_ROAD = """
road bent {
  draw with segments { pieces: [straight(40m), arc(25m..60m, 40deg), straight(30m..60m)] }
}
require radius: always (abs(curvature(bent)) < 1 / 26m)
agent ego is car on bent at 5m { drive with stanley { speed: 8m/s..16m/s } }
object tree is tree on bent at 10m..60m { side: left, offset: 1m..3m }
expect slow: always (ego.speed < 14m/s)
"""


def test_a_drawn_road_is_drawn_once_for_screening_and_driving(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    search = scenario(DRAWN_ROAD).falsify(evaluations=40, searcher="halton")
    evaluator = search.evaluator
    proposals = [Proposal(outcome.index, outcome.point) for outcome in search.outcomes]
    alone = [Evaluator(evaluator.task).evaluate([proposal])[0] for proposal in proposals]
    drawn: list[Segments] = []
    draw = Segments.draw

    def counted(self: Segments, closed: bool) -> Curve:
        drawn.append(self)
        return draw(self, closed)

    monkeypatch.setattr(Segments, "draw", counted)
    evaluator.screen(np.array([proposal.point for proposal in proposals]))
    assert evaluator.evaluate(proposals) == alone
    assert len(drawn) == len(proposals)


def test_what_only_the_search_for_room_draws_is_drawn_of_each_candidate() -> None:
    text = (
        DRAWN_ROAD.replace("at 10m..60m", "at 30m")
        .replace("25m..60m", "40m")
        .replace("straight(30m..60m)", "straight(50m)")
    )
    task = scenario(text).falsify(evaluations=20, searcher="halton").evaluator.task
    # The offset of the tree is no axis here, so that it is drawn by the number of the candidate.
    task = replace(task, axes=("ego/drive 1/speed",))
    proposals = [Proposal(index, (index / 20,)) for index in range(20)]
    alone = [Evaluator(task).evaluate([proposal])[0] for proposal in proposals]
    evaluator = Evaluator(task)
    evaluator.screen(np.array([proposal.point for proposal in proposals]))
    assert evaluator.evaluate(proposals) == alone
    assert len({outcome.draws["tree/offset"] for outcome in alone}) == 20
