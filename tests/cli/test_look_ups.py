"""`explain` and `schema`: a page or a format by any of its names."""

from __future__ import annotations

import json
from typing import Any

import pytest

from roadlang.cli.main import run


def printed(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    capsys.readouterr()
    assert run(list(words)) == 0
    return capsys.readouterr().out


@pytest.mark.parametrize("name", ["RL001", "rl001", "1", "001", "unexpected-token"])
def test_a_diagnostic_is_found_by_its_code_its_number_and_its_name(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert printed(capsys, "explain", name).startswith("RL001 unexpected-token: ")


def test_a_statement_is_explained_with_its_options(capsys: pytest.CaptureFixture[str]) -> None:
    shown = printed(capsys, "explain", "world")
    assert "time_of_day" in shown
    assert "friction" in shown


def schema(capsys: pytest.CaptureFixture[str], *words: str) -> Any:
    return json.loads(printed(capsys, "schema", *words))


def test_a_name_of_several_verbs_gives_the_schemas_of_all(
    capsys: pytest.CaptureFixture[str],
) -> None:
    titles = [found["title"] for found in schema(capsys, "distance")]
    assert sorted(titles) == ["drive_signal distance", "number distance", "signal distance"]
    assert schema(capsys, "signal", "distance")["title"] == "signal distance"
    assert schema(capsys, "standard.sine")["title"] == "perturb sine"


def test_a_kind_of_another_verb_is_not_meant(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["schema", "emit", "sine"]) == 2
    assert "there is no schema called `emit sine`" in capsys.readouterr().err
