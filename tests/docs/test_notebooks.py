"""Every notebook runs from its first cell to its last, and is committed without outputs."""

from __future__ import annotations

import ast
import json
import shutil
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))


def code_cells(notebook: Path) -> list[dict[str, Any]]:
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return [cell for cell in cells if cell["cell_type"] == "code"]


def run(source: str, names: dict[str, Any]) -> Any:
    """Run a cell and return the value of its last expression, as a notebook shows it."""
    *statements, last = ast.parse(source).body
    body = statements if isinstance(last, ast.Expr) else [*statements, last]
    exec(compile(ast.Module(body, []), "cell", "exec"), names)  # noqa: S102
    if not isinstance(last, ast.Expr):
        return None
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names)  # noqa: S307


def test_there_are_notebooks_whose_cells_have_names() -> None:
    """Of version 4.5, which wants an `id` of each cell."""
    assert NOTEBOOKS
    for notebook in NOTEBOOKS:
        record = json.loads(notebook.read_text(encoding="utf-8"))
        ids = [cell["id"] for cell in record["cells"]]
        assert (record["nbformat"], record["nbformat_minor"]) == (4, 5)
        assert len(ids) == len(set(ids))


@pytest.mark.slow
@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.name)
def test_a_notebook_runs(notebook: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for path in (ROOT / "examples").iterdir():
        if path.is_file():
            shutil.copy(path, tmp_path)
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    figures = 0
    for cell in code_cells(notebook):
        value = run("".join(cell["source"]), names)
        if hasattr(value, "_repr_svg_"):
            figures += "<svg" in value._repr_svg_()
    assert figures >= 2


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.name)
def test_a_notebook_is_committed_without_outputs(notebook: Path) -> None:
    for cell in code_cells(notebook):
        assert cell["outputs"] == []
        assert cell["execution_count"] is None
