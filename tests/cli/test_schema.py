"""`roadlang schema`: of a kind by its name, by its verb and name, and by its full name."""

from __future__ import annotations

import json
from typing import Any

import pytest

from roadlang.cli.main import run


def printed(capsys: pytest.CaptureFixture[str], *words: str) -> Any:
    assert run(["schema", *words]) == 0
    return json.loads(capsys.readouterr().out)


def test_a_name_of_two_verbs_gives_both_and_with_a_verb_one(
    capsys: pytest.CaptureFixture[str],
) -> None:
    both = printed(capsys, "halton")
    of_sample = printed(capsys, "sample", "halton")
    of_falsify = printed(capsys, "falsify", "halton")
    assert of_sample != of_falsify
    assert both in ([of_sample, of_falsify], [of_falsify, of_sample])


def test_a_kind_has_a_full_name(capsys: pytest.CaptureFixture[str]) -> None:
    assert printed(capsys, "standard.sine") == printed(capsys, "perturb", "sine")


def test_a_kind_of_another_verb_is_none(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["schema", "emit", "sine"]) == 2
    assert "sine" in capsys.readouterr().err
