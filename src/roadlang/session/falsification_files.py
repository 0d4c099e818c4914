"""The files of a search for failures.

failures/0001.json ...   the distinct failures as scenes, worst first, with traces
failures/0001.svg ...    figures of the first of them, or of all
failures/index.json      what each violates, when and where
safe/0001.json ...       some scenes in which nothing is violated, in the same way
failing.csv, safe.csv    every scene that was driven
summary.json             counts, failure rate, coverage, how robustness went down
provenance.json          what all of this was made from
journal.jsonl            every evaluation
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..diagnostics import arguments
from ..falsification.journal import write_journal
from ..falsification.search_key import search_key
from ..files.journal import JOURNAL_FILE
from ..files.writing import write_all, write_set
from ..ir.result_files import (
    EXPLANATION,
    FAILURES,
    INDEX,
    SAFE,
    SCENE,
    SHRUNK,
    SHRUNK_FIGURE,
    SUMMARY,
    TRACE,
    TRACE_TABLE,
    numbered_stem,
)
from ..ir.results_record import RESULTS_FILE
from ..version import __version__
from .result_folders import refuse_results_of_others, remove_report
from .results_record import record_of_search
from .tables import columns_of, to_csv

if TYPE_CHECKING:
    from .drives import Drive
    from .falsification import Failure, Falsification

INDEX_SCHEMA = "roadlang.failures/1"
SAFE_SCHEMA = "roadlang.safe/1"
SUMMARY_SCHEMA = "roadlang.falsification/1"
FINDINGS = (SHRUNK, SHRUNK_FIGURE, EXPLANATION)
_FIGURE = ".svg"
_ENDINGS = (SCENE, TRACE_TABLE, TRACE, _FIGURE)


def write_falsification(search: Falsification, folder: Path, figures: int | None = None) -> None:
    """Write all files, each set of them whole or not at all; those of an earlier search that are
    not written again are removed. `figures`: how many failures have one, all where it is None."""
    drawn = len(search.failures)
    if figures is not None:
        drawn = arguments.whole_number("figures", figures, least=0)
    folder = folder.absolute()
    refuse_results_of_others(folder, "falsify")
    remove_report(folder)
    _write_failures(search, folder / FAILURES, drawn)
    _write_safe(search, folder / SAFE)
    failing = [outcome for outcome in search.driven if outcome.is_failure]
    safe = [outcome for outcome in search.driven if not outcome.is_failure]
    tables = {
        "failing.csv": to_csv(columns_of(search.rows(failing))),
        "safe.csv": to_csv(columns_of(search.rows(safe))),
        SUMMARY: _json(summary(search)),
        RESULTS_FILE: record_of_search(search),
    }
    write_all(folder, tables)
    key = search_key(search.evaluator.task, search.plan)
    write_journal(folder / JOURNAL_FILE, key, search.outcomes)


def summary(search: Falsification) -> dict[str, Any]:
    """The search in numbers."""
    driven = search.driven
    return {
        "schema": SUMMARY_SCHEMA,
        "roadlang": __version__,
        "name": search.loaded.scenario.header.name,
        "seed": search.plan.seed,
        "searcher": search.plan.entry.name,
        "expects": list(search.expects),
        "evaluations": len(search.outcomes),
        "valid": len(driven),
        "failing": sum(outcome.is_failure for outcome in driven),
        "distinct": len(search.failures),
        "first_failure": next((o.index for o in driven if o.is_failure), None),
        "failure_rate": dataclasses.asdict(search.rate),
        "coverage": {name: dataclasses.asdict(found) for name, found in search.coverage.items()},
        "best_robustness": {name: list(found) for name, found in search.best.items()},
    }


def _write_failures(search: Falsification, folder: Path, drawn: int) -> None:
    contents: dict[str, str | bytes] = {}
    for failure in search.failures:
        contents |= _drive_files(failure.rank, failure.drive, failure.rank <= drawn)
    records = [_record(failure) for failure in search.failures]
    axes = list(search.evaluator.task.axes)
    contents[INDEX] = _json({"schema": INDEX_SCHEMA, "axes": axes, "failures": records})
    write_set(folder, contents, INDEX, _files_of)


def _write_safe(search: Falsification, folder: Path) -> None:
    contents: dict[str, str | bytes] = {}
    records = []
    for number, drive in enumerate(search.safe_drives, 1):
        contents |= _drive_files(number, drive)
        robustness = {name: drive.verdicts[name].robustness for name in search.expects}
        record = {"evaluation": drive.scene.index, "robustness": robustness}
        records.append({"scene": f"{numbered_stem(number)}{SCENE}", **record})
    contents[INDEX] = _json({"schema": SAFE_SCHEMA, "safe": records})
    write_set(folder, contents, INDEX, _files_of)


def _drive_files(number: int, drive: Drive, is_drawn: bool = True) -> dict[str, bytes]:
    """As bytes: hundreds of texts would be in memory twice when they are written."""
    contents = {
        SCENE: drive.scene.to_json(),
        TRACE_TABLE: drive.to_csv(),
        TRACE: drive.to_json(),
        **({_FIGURE: drive.svg()} if is_drawn else {}),
    }
    return {f"{numbered_stem(number)}{end}": text.encode() for end, text in contents.items()}


def _record(failure: Failure) -> dict[str, Any]:
    outcome, drive = failure.outcome, failure.drive
    again = {name: drive.verdicts[name].robustness for name in outcome.expectations}
    controllers = [dataclasses.asdict(failure) for failure in outcome.controller_failures]
    return {
        "scene": f"{numbered_stem(failure.rank)}{SCENE}",
        "evaluation": outcome.index,
        "violated": list(outcome.violated),
        "robustness": dict(outcome.expectations),
        "replays": again == dict(outcome.expectations),
        "moment": None if outcome.moment is None else dataclasses.asdict(outcome.moment),
        "draws": dict(outcome.draws),
        "point": list(outcome.point),
        **({"controller_failures": controllers} if controllers else {}),
    }


def _files_of(marker: Path) -> Iterable[str]:
    """The files that an index names; none of one that is not ours."""
    try:
        record = json.loads(marker.read_text(encoding="utf-8"))
        listed = record["failures"] if "failures" in record else record["safe"]
        stems = [str(item["scene"]).removesuffix(SCENE) for item in listed]
    except (OSError, ValueError, KeyError, TypeError):
        return []
    names = [f"{stem}{ending}" for stem in stems for ending in (*_ENDINGS, *FINDINGS)]
    return [name for name in names if (marker.parent / name).exists()]


def _json(record: dict[str, Any]) -> str:
    return json.dumps(record, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
