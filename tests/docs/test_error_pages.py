"""Every page of the catalog is true: `wrong` examples give its code, `right` ones do not."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.cli.exit_codes import exit_code_of
from roadlang.diagnostics import Diagnostic, codes, page
from tests.docs.page_examples import (
    Follower,
    blocks,
    expected_lines,
    has_wrong_example,
    plugins_forgotten,
    reported,
)

WITHOUT_EXAMPLE = {
    "RL471": "takes a plugin that is removed between check and compile",
    "RL110": "takes 200 included files; see tests/semantics/test_includes.py",
    "RL475": "takes a perturbation that collapses a road, which earlier checks reject",
    "RL503": "takes two clients of one Godot; see tests/godot",
    "RL504": "takes a network that loses messages; see tests/godot/test_faulty_network.py",
    "RL505": "takes a Godot that is killed; see tests/godot",
    "RL516": "takes an installation without the package `websockets`",
    "RL612": "takes a count without known bounds, which `check` cannot compute",
    "RL724": "takes the journal of an earlier run; see tests/files/test_journal.py",
    "RL730": "from Python alone; see tests/envs/test_scene_env.py",
    "RL731": "from Python alone; see tests/envs/test_scene_env.py",
    "RL704": "takes ten seconds without an answer; see tests/falsification/test_cluster.py",
    "RL900": "is a bug in roadlang",
    "RL933": "takes a machine with little memory; see tests/cli/test_endings.py",
    "RL934": "takes a process that is killed; see tests/cli/test_endings.py",
}
"""Pages that cannot have a `wrong` example, and why."""


NEEDS_GODOT = {"RL510", "RL700"}

SHOWN = [
    pytest.param(code, marks=[pytest.mark.godot] if code in NEEDS_GODOT else [])
    for code in codes()
    if has_wrong_example(code)
]


@pytest.mark.parametrize("code", codes())
def test_a_page_has_a_title_a_message_an_explanation_and_an_example(code: str) -> None:
    entry = page(code)
    assert entry.title
    assert entry.message
    assert entry.severity in ("error", "warning", "note")
    assert "```" in entry.body
    assert len(entry.body.split("```")[0].split()) >= 8, "the explanation is too short"


def test_every_page_has_a_wrong_example_unless_it_is_listed_with_the_reason() -> None:
    assert {code for code in codes() if not has_wrong_example(code)} == set(WITHOUT_EXAMPLE)


@pytest.mark.parametrize("code", SHOWN)
def test_wrong_examples_give_the_code_and_right_ones_do_not(
    code: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path))
    follower = Follower(code, tmp_path, capsys)
    with plugins_forgotten():
        for block in blocks(code):
            if block.is_file:
                follower.save(block)
            elif block.word:
                printed = follower.output(block, code)
                errors = reported(printed, "error")
                if block.word == "wrong":
                    assert reported(printed).count(code) == 1, block.text + printed
                    assert set(errors) <= {code}, block.text + printed
                else:
                    assert not errors, block.text + printed
                    assert code not in reported(printed), block.text + printed
                for line in expected_lines(block):
                    starts = [text for text in printed.splitlines() if text.startswith(line)]
                    assert starts, f"{line}\nis not in\n{printed}"


@pytest.mark.parametrize("code", codes())
def test_an_error_has_an_exit_code(code: str) -> None:
    assert exit_code_of([Diagnostic(code, "error", "")]) in (1, 2, 3, 5, 70)
