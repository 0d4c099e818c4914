"""The files of a search for failures.

failures/0001.json ...   the distinct failures as scenes, worst first, with trace and figure
failures/index.json      what each violates, when and where
failing.csv, safe.csv    every scene that was driven
summary.json             counts, failure rate, coverage, how robustness went down
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..files.writing import write_all, write_set
from ..version import __version__
from .tables import columns_of, to_csv

if TYPE_CHECKING:
    from .falsification import Failure, Falsification

FAILURES = "failures"
INDEX = "index.json"
INDEX_SCHEMA = "roadlang.failures/1"
SUMMARY_SCHEMA = "roadlang.falsification/1"


def write_falsification(search: Falsification, folder: Path) -> None:
    """Write all files, each set of them whole or not at all; failures of an earlier search that
    are not written again are removed."""
    folder = folder.absolute()
    contents: dict[str, str | bytes] = {}
    records = [_write_failure(failure, contents) for failure in search.failures]
    contents[INDEX] = _json({"schema": INDEX_SCHEMA, "failures": records})
    write_set(folder / FAILURES, contents, INDEX, _files_of)
    failing = [outcome for outcome in search.driven if outcome.is_failure]
    safe = [outcome for outcome in search.driven if not outcome.is_failure]
    tables = {
        "failing.csv": to_csv(columns_of(search.rows(failing))),
        "safe.csv": to_csv(columns_of(search.rows(safe))),
        "summary.json": _json(summary(search)),
    }
    write_all(folder, tables)


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


def _write_failure(failure: Failure, contents: dict[str, str | bytes]) -> dict[str, Any]:
    """Add the files of a failure; gives its record."""
    stem = f"{failure.rank:04d}"
    drive = failure.drive
    contents[f"{stem}.json"] = failure.scene.to_json()
    contents[f"{stem}.trace.csv"] = drive.to_csv()
    contents[f"{stem}.trace.json"] = drive.to_json()
    contents[f"{stem}.svg"] = drive.svg()
    outcome = failure.outcome
    again = {name: drive.verdicts[name].robustness for name in outcome.expectations}
    return {
        "scene": f"{stem}.json",
        "evaluation": outcome.index,
        "violated": list(outcome.violated),
        "robustness": dict(outcome.expectations),
        "replays": again == dict(outcome.expectations),
        "moment": None if outcome.moment is None else dataclasses.asdict(outcome.moment),
        "draws": dict(outcome.draws),
    }


def _files_of(marker: Path) -> Iterable[str]:
    """The files that an index names; none of one that is not ours."""
    try:
        record = json.loads(marker.read_text(encoding="utf-8"))
        stems = [str(item["scene"]).removesuffix(".json") for item in record["failures"]]
    except (OSError, ValueError, KeyError, TypeError):
        return []
    names = [f"{stem}{ending}" for stem in stems for ending in _ENDINGS]
    return [name for name in names if (marker.parent / name).exists()]


_ENDINGS = (".json", ".trace.csv", ".trace.json", ".svg")


def _json(record: dict[str, Any]) -> str:
    return json.dumps(record, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
