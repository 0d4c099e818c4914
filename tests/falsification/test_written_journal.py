"""A search that kept no journal writes one with its results: the page of it, and going on with it,
need every evaluation."""

from __future__ import annotations

from pathlib import Path

import pytest

import roadlang
from roadlang.files.journal import JOURNAL_FILE

TEXT = """
road main { draw with segments { pieces: [straight(60m)] }, lanes: 2 }
agent ego is car on main at 5m { lane: -1, drive with lane_follow { speed: 8m/s..12m/s } }
expect calm: always (ego.speed < 10m/s)
falsify with random { evaluations: 12 }
"""


@pytest.fixture(scope="module")
def loaded() -> roadlang.LoadedScenario:
    return roadlang.loads(TEXT)


def test_what_python_writes_can_be_shown_and_gone_on_with(
    loaded: roadlang.LoadedScenario, tmp_path: Path
) -> None:
    kept, written = tmp_path / "kept", tmp_path / "written"
    loaded.falsify(folder=kept)
    loaded.falsify().write(written)
    assert roadlang.write_report(written).is_file()
    journal = (written / JOURNAL_FILE).read_bytes()
    assert journal == (kept / JOURNAL_FILE).read_bytes()
    more = loaded.falsify(folder=written, resume=True, evaluations=20)
    assert len(more.outcomes) == 20
    assert (written / JOURNAL_FILE).read_bytes().startswith(journal)


@pytest.mark.parametrize("before", [b"", b"another search\n", None])
def test_the_journal_of_another_search_is_replaced(
    before: bytes | None, loaded: roadlang.LoadedScenario, tmp_path: Path
) -> None:
    search = loaded.falsify(seed=1)
    search.write(tmp_path)
    path = tmp_path / JOURNAL_FILE
    whole = path.read_bytes()
    path.write_bytes(whole[: len(whole) // 2] if before is None else before)
    search.write(tmp_path)
    assert path.read_bytes() == whole


def test_a_journal_that_holds_more_stays(loaded: roadlang.LoadedScenario, tmp_path: Path) -> None:
    loaded.falsify(folder=tmp_path, evaluations=30)
    longer = (tmp_path / JOURNAL_FILE).read_bytes()
    loaded.falsify(folder=tmp_path, resume=True).write(tmp_path)
    assert (tmp_path / JOURNAL_FILE).read_bytes() == longer
