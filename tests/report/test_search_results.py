"""The results of a search, read from the files that it wrote."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import msgspec
import pytest

from roadlang.diagnostics import DiagnosticError
from roadlang.falsification.outcome import Moment, Outcome
from roadlang.files.journal import JOURNAL_FILE, SCHEMA
from roadlang.ir.results_record import ResultsRecord
from roadlang.report.results import Results
from roadlang.report.search_results import read_search
from roadlang.testing import registry_with

RECORD = ResultsRecord(
    "falsify", "roadlang falsify a.rl", "town", "", "a.rl", 7, "1.0", sampler="cma",
    expects=("apart",), params={}, inputs={}, plugins={},
)  # fmt: skip


def outcome(index: int, rho: float | None, **changes: Any) -> Outcome:
    violated = ("apart",) if rho is not None and rho < 0.0 else ()
    plain: dict[str, Any] = {
        "requirements": {}, "expectations": {"apart": rho}, "violated": violated,
        "draws": {"speed": 9.0 + index}, "measures": {"gap": float(index)},
    }  # fmt: skip
    is_random = bool(changes.pop("is_random", False))
    return Outcome(index, (0.1, 0.2), is_random, None, **{**plain, **changes})


def written(folder: Path, evaluations: int, *outcomes: Outcome) -> Path:
    lines = [json.dumps({"schema": SCHEMA, "key": "k"})]
    lines += [msgspec.json.encode(each).decode() for each in outcomes]
    (folder / JOURNAL_FILE).write_text("\n".join(lines) + "\n")
    (folder / "summary.json").write_text(json.dumps({"evaluations": evaluations}))
    (folder / "failures").mkdir()
    index = {"axes": ["speed", "bent/perturb 1:0"], "failures": []}
    (folder / "failures" / "index.json").write_text(json.dumps(index))
    return folder


def read(folder: Path) -> Results:
    return read_search(folder, RECORD, registry_with())


def test_what_was_driven_has_a_row_with_its_draws(tmp_path: Path) -> None:
    moment = Moment("apart", 1.5, "ego", 2.0, 3.0)
    folder = written(
        tmp_path, 4, outcome(0, 3.0), Outcome(1, (0.5, 0.6), False, 2.0),
        outcome(2, -1.0, moment=moment), outcome(3, 1.0),
    )  # fmt: skip
    found = read(folder)
    assert [(row.number, row.has_failed) for row in found.rows] == [
        (0, False), (2, True), (3, False),
    ]  # fmt: skip
    assert found.evaluations == 4
    first, failing, _ = found.rows
    assert first.draws == failing.draws == ("speed", "bent/perturb 1:0")
    assert (first.values["speed"], first.values["bent/perturb 1:0"]) == (9.0, 0.2)
    assert failing.values["violation time"] == 1.5
    assert failing.robustness == {"apart": -1.0}
    assert (found.record, found.expects, found.drives) == (RECORD, ("apart",), [])
    assert found.best == {"apart": [(0, 3.0), (2, -1.0)]}
    assert found.rate is None
    assert found.coverage["gap"].low == 0.0
    assert found.coverage["gap"].high == 3.0


def test_what_came_after_the_last_evaluation_does_not_count_and_the_last_line_of_each_does(
    tmp_path: Path,
) -> None:
    """As where a search was resumed that had been cut off in a batch."""
    folder = written(
        tmp_path, 2, outcome(1, 5.0), outcome(0, 3.0), outcome(2, -9.0), outcome(1, 4.0)
    )
    found = read(folder)
    assert [(row.number, row.robustness["apart"]) for row in found.rows] == [(0, 3.0), (1, 4.0)]
    assert found.evaluations == 2


def test_random_candidates_tell_the_rate(tmp_path: Path) -> None:
    parts = [outcome(n, -1.0 if n == 1 else 1.0, is_random=n < 3) for n in range(5)]
    rate = read(written(tmp_path, 5, *parts)).rate
    assert rate is not None
    assert (rate.failures, rate.scenes) == (1, 3)


def test_a_line_that_is_no_outcome_is_named(tmp_path: Path) -> None:
    folder = written(tmp_path, 1, outcome(0, 1.0))
    with (folder / JOURNAL_FILE).open("a") as file:
        file.write('{"index": "x"}\n')
    with pytest.raises(DiagnosticError, match=r"RL721(.|\n)*journal.jsonl"):
        read(folder)
