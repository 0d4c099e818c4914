"""Which of several verdicts is the worst, of any drive and of one of a search."""

from __future__ import annotations

from pathlib import Path

import roadlang
from roadlang.ir.scene import Verdict
from roadlang.judging.badness import worst_of

TEXT = """
road main { draw with segments { pieces: [straight(200m)] }, lanes: 2 }
agent ego is car on main at 5m { lane: -1, drive with lane_follow { speed: 8m/s..12m/s } }
expect fast: always (ego.speed > 30m/s)
expect calm: always (ego.speed < 9m/s)
expect short: always (ego.station < 100m)
falsify with random { expects: [calm, short], evaluations: 8 }
"""


def verdict(name: str, robustness: float | None, satisfied: bool | None = None) -> Verdict:
    holds = satisfied if robustness is None else robustness > 0.0
    return Verdict(name, name, "drive", robustness, holds)


def named(found: Verdict | None) -> str:
    return "" if found is None else found.name


def test_without_a_search_the_least_robustness_is_the_worst() -> None:
    assert named(worst_of([verdict("a", 1.0), verdict("b", -1.0), verdict("c", -2.0)])) == "c"
    assert named(worst_of([verdict("a", None), verdict("b", 2.0), verdict("c", 1.0)])) == "c"
    assert worst_of([verdict("a", None)]) is None
    assert worst_of([]) is None


def test_of_a_search_the_first_violated_one_of_those_it_was_for_is() -> None:
    found = [verdict("a", 1.0), verdict("b", -1.0), verdict("c", -2.0), verdict("d", 0.5)]
    assert named(worst_of(found, ("a", "b"))) == "b"
    assert named(worst_of(found, ("b", "c"))) == "b"
    assert named(worst_of(found, ("c", "b"))) == "c"
    assert named(worst_of(found, ("a", "d"))) == "d"
    assert worst_of(found, ("gone",)) is None


def test_pages_and_figures_of_a_search_show_what_it_was_for(tmp_path: Path) -> None:
    search = roadlang.loads(TEXT).falsify(seed=1, folder=tmp_path)
    assert search.failures
    search.write(tmp_path)
    for failure in search.failures:
        first = failure.outcome.violated[0]
        worst, moment = failure.drive.worst, failure.drive.first_violation
        assert (named(worst), worst is None or worst.satisfied) == (first, False)
        assert failure.outcome.moment is not None
        assert moment is not None
        assert moment.actors[0].time[moment.sample] == failure.outcome.moment.time
        figure = (tmp_path / "failures" / f"{failure.rank:04}.svg").read_text(encoding="utf-8")
        assert f": {first}, robustness" in figure
        assert named(failure.shrink().drive.worst) == first
    page = roadlang.write_report(tmp_path).read_text(encoding="utf-8")
    assert "fast \N{MINUS SIGN}" not in page.split("<script")[0]
    assert f"{search.failures[0].outcome.violated[0]} \N{MINUS SIGN}" in page
