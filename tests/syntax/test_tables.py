"""The stored tables are those of the grammar, and the grammar is one that lark reads."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from roadlang.syntax.parsing import tables
from roadlang.syntax.parsing.generate import generate
from roadlang.syntax.parsing.grammar import grammar_text

SAMPLES = sorted((Path(__file__).parent / "samples").glob("*.rl"))


def test_tables_are_up_to_date() -> None:
    stored = json.loads(Path(tables.__file__).with_name("tables.json").read_text())
    assert stored == generate(grammar_text()), "run python -m roadlang.syntax.parsing.tables"


def test_stale_tables_are_built_anew_with_a_warning(monkeypatch: pytest.MonkeyPatch) -> None:
    edited = grammar_text() + "\n// an edit"
    monkeypatch.setattr(tables, "grammar_text", lambda: edited)
    with pytest.warns(RuntimeWarning, match=r"python -m roadlang\.syntax\.parsing\.tables"):
        built = tables.tables.__wrapped__()
    assert built.starts.keys() == {"file", "formula", "value"}


@pytest.fixture(scope="module")
def lark_parser() -> Any:
    lark = pytest.importorskip("lark")
    return lark.Lark(
        grammar_text(),
        parser="lalr",
        lexer="contextual",
        start=["file", "formula", "value"],
        maybe_placeholders=True,
        strict=False,
    )


@pytest.mark.parametrize("path", SAMPLES, ids=lambda path: path.stem)
def test_lark_reads_the_samples_with_the_same_grammar(lark_parser: Any, path: Path) -> None:
    tree = lark_parser.parse(path.read_text(), start="file")
    assert tree.data == "file"


def test_parsing_does_not_import_lark() -> None:
    code = (
        "import sys; from roadlang.syntax import parse; from roadlang.diagnostics import Source;"
        "parse(Source('a', 'let a = ')); print('lark' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
