"""The search for failures, from a scenario to its outcomes, with a small simulator."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from copy import copy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roadlang import DiagnosticError, Falsification, Scene
from roadlang.cli.falsify import _note_figures, _print
from roadlang.evaluate.candidates import CandidateBatch
from roadlang.falsification.evaluator import Evaluator, Proposal
from roadlang.falsification.outcome import Outcome
from tests.falsification.slider import FEW, PERTURBED, TEXT, numbers_in_journal, slides


@pytest.fixture(scope="module")
def search() -> Falsification:
    return slides().falsify(**FEW)


def test_a_search_finds_failures_that_chance_seldom_finds() -> None:
    guided = slides().falsify(evaluations=400, seed=1)
    chance = slides().falsify(evaluations=400, seed=1, searcher="random")
    failing = [sum(o.is_failure for o in found.outcomes) for found in (guided, chance)]
    assert failing[0] > 5 * max(1, failing[1])
    assert len(guided.failures) > len(chance.failures)


def test_the_first_ten_failures_are_printed_and_the_rest_is_counted(
    search: Falsification, capsys: pytest.CaptureFixture[str]
) -> None:
    found = copy(search)  # other tests want all of its failures
    found.failures = (search.failures * 12)[:12]
    _print(found, Path("out"), as_json=False)
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines[:10]] == ["violated"] * 10
    assert lines[10] == "  ... and 2 more"
    assert lines[11].startswith("12 distinct of ")
    found.failures = found.failures[:10]
    _print(found, Path("out"), as_json=False)
    assert "more" not in capsys.readouterr().out


def test_every_random_number_is_an_axis(search: Falsification) -> None:
    axes = search.evaluator.task.axes
    assert "ego/drive 1/speed" in axes
    assert sum(name.startswith("bent/perturb 1:0:") for name in axes) == 12
    assert all(len(outcome.point) == len(axes) for outcome in search.outcomes)


@pytest.fixture(scope="module")
def strict() -> Falsification:
    """A search in which many candidates violate the requirement."""
    return slides(TEXT.replace("1 / 14m", "1 / 38m")).falsify(evaluations=240, seed=3)


def test_what_violates_a_requirement_is_not_driven_and_worth_less_than_any_that_is(
    strict: Falsification,
) -> None:
    invalid = [outcome for outcome in strict.outcomes if not outcome.is_valid]
    assert 0 < len(invalid) < len(strict.outcomes)
    for outcome in invalid:
        assert outcome.violation is not None
        assert outcome.violation > 0
        assert outcome.requirements["gentle"] is not None
        assert outcome.requirements["gentle"] < 0
        assert not outcome.expectations


def test_screening_judges_by_the_requirements_as_evaluating_does() -> None:
    text = TEXT.replace("1 / 14m", "1 / 38m")
    found = slides(text).falsify(**FEW, searcher="random")
    screened = found.evaluator.screen(np.array([outcome.point for outcome in found.outcomes]))
    violations = [outcome.violation for outcome in found.outcomes]
    np.testing.assert_array_equal(screened, [0.0 if v is None else 1.0 + v for v in violations])
    assert None in violations
    assert len(set(violations)) > 10
    few = found.evaluator.screen(np.array([outcome.point for outcome in found.outcomes[3:5]]))
    np.testing.assert_array_equal(few, screened[3:5])


def test_cma_evaluates_hardly_any_candidate_that_violates_a_requirement(
    strict: Falsification,
) -> None:
    later = [outcome for outcome in strict.outcomes[80:] if not outcome.is_random]
    assert sum(outcome.is_valid for outcome in later) > 0.95 * len(later)
    assert not all(outcome.is_valid for outcome in strict.outcomes if outcome.is_random)


def test_each_failure_replays_exactly(search: Falsification, tmp_path: Path) -> None:
    assert search.failures
    for failure in search.failures:
        path = failure.scene.save(tmp_path / "failure.json")
        again = Scene.from_json(path.read_text())
        drive = Scene(again.record, search.loaded).run()
        assert drive.verdicts["in_lane"].robustness == failure.robustness["in_lane"]
        assert drive.verdicts["in_lane"].satisfied is False
        assert drive.to_json() == failure.drive.to_json()


def test_the_worst_failures_alone_are_drawn_where_few_figures_are_wanted(
    search: Falsification, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert len(search.failures) > 2

    def drawn() -> list[str]:
        return sorted(file.name for file in (tmp_path / "failures").glob("*.svg"))

    search.write(tmp_path)
    assert len(drawn()) == len(search.failures)
    every = {file.name: file.read_bytes() for file in (tmp_path / "failures").iterdir()}
    search.write(tmp_path, figures=2)
    assert drawn() == ["0001.svg", "0002.svg"]
    few = {file.name: file.read_bytes() for file in (tmp_path / "failures").iterdir()}
    assert few == {name: text for name, text in every.items() if name in few}
    assert len(every) - len(few) == len(search.failures) - 2
    _note_figures(search, tmp_path, 2)
    assert "failures/0003.json" in capsys.readouterr().err
    _note_figures(search, tmp_path, len(search.failures))
    assert not capsys.readouterr().err
    with pytest.raises(ValueError, match="`figures` must be at least 0"):
        search.write(tmp_path, figures=-1)


def test_failures_are_ranked_by_how_badly_they_fail(search: Falsification) -> None:
    robustness = [failure.robustness["in_lane"] or 0.0 for failure in search.failures]
    assert robustness == sorted(robustness)
    assert [failure.rank for failure in search.failures] == list(range(1, len(robustness) + 1))


def test_safe_drives_begin_with_the_nearest_miss_also_beside_an_equality() -> None:
    """All that touch nothing keep `contacts == 0` equally well."""
    text = f"{TEXT}\nexpect untouched: always (ego.contacts == 0)\n"
    search = slides(text).falsify(evaluations=60, seed=3, expects=["untouched", "in_lane"])
    safe = [outcome for outcome in search.driven if not outcome.is_failure]
    nearest = min(safe, key=lambda outcome: outcome.expectations["in_lane"] or 0.0)
    first = search.safe_drives[0].verdicts["in_lane"].robustness
    assert first == nearest.expectations["in_lane"]


def test_the_moment_at_which_it_goes_wrong_is_known(search: Falsification) -> None:
    for failure in search.failures:
        moment = failure.outcome.moment
        assert moment is not None
        drive = failure.drive.to_dict()
        first = (abs(drive["ego.cross_track_error"]) >= 1.4).argmax()
        assert moment.time == drive["time"][first]
        assert moment.station == drive["ego.station"][first]
        assert moment.agent == "ego"


def test_nothing_depends_on_batches_of_the_evaluation(search: Falsification) -> None:
    """An outcome is the same, whatever is evaluated beside it."""
    some = search.outcomes[7:90:9]
    proposals = [Proposal(o.index, o.point, o.is_random) for o in some]
    assert search.evaluator.evaluate(proposals) == list(some)


def test_threads_and_any_executor_give_the_same_outcomes(
    search: Falsification, tmp_path: Path
) -> None:
    with ThreadPoolExecutor(2) as executor:
        threads = slides().falsify(**FEW, jobs=2, executor=executor, folder=tmp_path)
    assert threads.outcomes == search.outcomes
    assert numbers_in_journal(tmp_path) == list(range(120))
    assert [f.outcome for f in threads.failures] == [f.outcome for f in search.failures]


def test_a_search_that_was_interrupted_is_resumed(search: Falsification, tmp_path: Path) -> None:
    finished = []

    def interrupt(done: int, total: int) -> None:
        finished.append(done)
        if done >= 80:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        slides().falsify(**FEW, folder=tmp_path, progress=interrupt)
    journal = tmp_path / "journal.jsonl"
    with journal.open("ab") as file:
        file.write(b'{"index": 80, "poi')  # a line that a killed process has not finished
    counting = Counting()
    resumed = slides().falsify(**FEW, folder=tmp_path, resume=True, executor=counting)
    assert resumed.outcomes == search.outcomes
    assert 0 < counting.evaluated == 120 - finished[-1]
    assert len(journal.read_text().splitlines()) == 121


def test_a_search_goes_on_with_more_evaluations(search: Falsification, tmp_path: Path) -> None:
    slides().falsify(evaluations=60, seed=3, folder=tmp_path)
    counting = Counting()
    longer = slides().falsify(**FEW, folder=tmp_path, resume=True, executor=counting)
    assert longer.outcomes == search.outcomes
    assert counting.evaluated <= 80, "the rounds that were whole are not evaluated again"


def test_the_journal_of_another_search_is_refused(tmp_path: Path) -> None:
    slides().falsify(evaluations=40, seed=3, folder=tmp_path)
    with pytest.raises(DiagnosticError, match="RL702"):
        slides().falsify(evaluations=40, seed=4, folder=tmp_path, resume=True)
    with pytest.raises(DiagnosticError, match="RL702"):
        slides(limit="2m").falsify(evaluations=40, seed=3, folder=tmp_path, resume=True)
    commented = slides(TEXT.replace("param", "# a remark\nparam", 1))
    commented.falsify(evaluations=40, seed=3, folder=tmp_path, resume=True)


def test_enough_distinct_failures_end_the_search(search: Falsification) -> None:
    found = slides().falsify(**FEW, failures=2)
    assert len(found.failures) == 2
    assert found.outcomes[-1].is_failure
    assert found.outcomes == search.outcomes[: len(found.outcomes)]


def test_no_time_is_enough_for_nothing() -> None:
    found = slides().falsify(evaluations=200, seconds=1e-9)
    assert len(found.outcomes) == 0
    assert found.rate.high == 1.0


def test_the_random_share_tells_the_failure_rate(search: Falsification) -> None:
    drawn = [outcome for outcome in search.outcomes if outcome.is_random]
    assert len(drawn) == 6
    assert search.rate.scenes == sum(outcome.is_valid for outcome in drawn)
    chance = slides().falsify(**FEW, searcher="random")
    assert chance.rate.scenes == len(chance.driven)


def test_a_grid_ends_with_its_last_combination() -> None:
    text = TEXT.replace(PERTURBED, "")
    found = slides(text + "\nfalsify with grid { steps: 7, random: 0% }").falsify()
    assert len(found.outcomes) == 7
    speeds = [outcome.draws["ego/drive 1/speed"] for outcome in found.outcomes]
    assert speeds == pytest.approx([8 + 6 * (step + 0.5) / 7 for step in range(7)])


def test_the_file_says_how_to_search_and_arguments_come_before_it() -> None:
    text = TEXT + "\nfalsify with halton { evaluations: 60, random: 10%, expects: in_lane }"
    found = slides(text).falsify()
    assert found.plan.entry.name == "halton"
    assert len(found.outcomes) == 60
    assert sum(outcome.is_random for outcome in found.outcomes) == 6
    assert len(slides(text).falsify(evaluations=20, searcher="random").outcomes) == 20


def test_several_islands_search_side_by_side() -> None:
    one = slides().falsify(evaluations=100, seed=3)
    two = slides().falsify(evaluations=100, seed=3, islands=2)
    assert len(two.outcomes) == 100
    assert two.outcomes[:11] == one.outcomes[:11]  # the first batch of the first island
    assert two.outcomes[60:] != one.outcomes[60:]


@pytest.mark.parametrize(
    ("change", "code", "help"),
    [
        (lambda text: text.split("expect in_lane")[0] + "simulate with slider", "RL703", "add one"),
        (
            lambda text: text.replace("8m/s..14m/s", "9m/s").replace(PERTURBED, ""),
            "RL705",
            "write a range",
        ),
    ],
)
def test_what_cannot_be_searched_is_refused(
    change: Callable[[str], str], code: str, help: str
) -> None:
    with pytest.raises(DiagnosticError, match=code) as refused:
        slides(change(TEXT)).falsify(evaluations=10)
    assert help in refused.value.diagnostics[0].help[0]


def test_an_expectation_that_does_not_exist_is_refused() -> None:
    with pytest.raises(DiagnosticError, match="did you mean `in_lane`"):
        slides().falsify("in_lan", evaluations=10)


def test_the_more_important_expectation_ranks_first() -> None:
    text = TEXT + "\nexpect slow: always (ego.speed < 9m/s)"
    found = slides(text).falsify(["in_lane", "slow"], evaluations=120, seed=3)
    names = [failure.outcome.violated[0] for failure in found.failures]
    assert names == sorted(names)
    assert set(names) == {"in_lane", "slow"}


class Counting:
    """An executor that counts the candidates that it evaluates, and works in this process."""

    def __init__(self) -> None:
        self.evaluated = 0

    def submit(self, function: Callable[..., Any], /, *arguments: Any) -> Future[list[Outcome]]:
        _, work, candidates = arguments
        self.evaluated += len(candidates) if work is Evaluator.evaluate else 0
        future: Future[list[Outcome]] = Future()
        future.set_result(function(*arguments))
        return future


def test_candidates_are_freed_with_their_last_use(
    search: Falsification, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[weakref.ref[CandidateBatch]] = []
    batch = Evaluator._batch

    def noted(self: Evaluator, *arguments: Any) -> CandidateBatch:
        found = batch(self, *arguments)
        made.append(weakref.ref(found))
        return found

    monkeypatch.setattr(Evaluator, "_batch", noted)
    evaluator = Evaluator(search.evaluator.task)
    evaluator.evaluate([Proposal(index, search.outcomes[index].point) for index in range(20)])
    assert made
    assert all(found() is None for found in made)  # at once, with what they hold
