"""Every page of the catalog is right: wrong examples give its code, mended ones do not."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from roadlang.cli.exit_codes import exit_code_of
from roadlang.cli.main import run
from roadlang.diagnostics import codes, page
from roadlang.semantics import check_text

ROOT = Path(__file__).parents[2]


def examples(code: str, kind: str) -> list[str]:
    return re.findall(rf"^```roadlang {kind}\n(.*?)^```$", page(code).body, re.M | re.S)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """A folder with what the examples name: pictures, tables and an included file."""
    folder = tmp_path_factory.mktemp("catalog")
    for path in (ROOT / "examples").iterdir():
        if path.is_file():
            shutil.copy(path, folder)
    return folder


@pytest.mark.parametrize("code", codes())
def test_a_page_has_a_title_a_message_an_explanation_and_an_example(code):
    entry = page(code)
    assert entry.title
    assert entry.message
    assert entry.severity in ("error", "warning", "note")
    assert "```" in entry.body
    assert len(entry.body.split("```")[0].split()) >= 8, "the explanation is too short"


@pytest.mark.parametrize("code", [c for c in codes() if examples(c, "wrong") and c < "RL4"])
def test_wrong_examples_give_the_code_and_right_ones_do_not(code, folder):
    for text in examples(code, "wrong"):
        _, found = check_text(text, folder / "wrong.rl")
        assert code in {diagnostic.code for diagnostic in found}, text
        assert {d.code for d in found if d.is_error} <= {code}, text
    for text in examples(code, "right"):
        _, found = check_text(text, folder / "right.rl")
        assert not [diagnostic for diagnostic in found if diagnostic.is_error], text


@pytest.mark.parametrize("code", [c for c in codes() if examples(c, "wrong") and c >= "RL4"])
def test_wrong_examples_give_the_code_when_they_are_compiled(code, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for kind in ("wrong", "right"):
        for text in examples(code, kind):
            (tmp_path / "scene.rl").write_text(text, encoding="utf-8")
            status = run(["compile", "scene.rl", "-o", "out", "--emit", "json"])
            said = capsys.readouterr().err
            assert (f"[{code}]" in said) == (kind == "wrong"), text + said
            assert (status == 0) == (kind == "right"), text + said


@pytest.mark.parametrize("code", codes())
def test_an_error_has_an_exit_code(code):
    from roadlang.diagnostics import Diagnostic

    error = Diagnostic(code, "error", "")
    assert exit_code_of([error]) in (1, 2, 3, 5, 70)
