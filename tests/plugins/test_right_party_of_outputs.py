"""Faults of backends, readers and their files are blamed on whoever made them."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import pytest

from roadlang import testing
from roadlang.api import (
    Backend,
    Code,
    Diagnostic,
    DiagnosticError,
    Reader,
    diagnose,
)
from tests.plugins.odd_kinds import BENT, backend, fault, perturber, raising
from tests.straight_road import STRAIGHT


def emitted(odd: type[Backend], folder: Path) -> Diagnostic:
    scenes = testing.sample(STRAIGHT + "emit odd\n", kinds=[odd])
    with pytest.raises(DiagnosticError) as caught:
        scenes.emit(folder)
    assert not folder.exists()
    [found] = caught.value.diagnostics
    return found


@pytest.mark.parametrize(
    ("files", "says"),
    [
        ({"txt": "\udc80"}, "gave text as the content of `txt` that UTF-8 cannot hold"),
        ({"txt": 3}, "gave a int as the content of `txt`"),
        ({"../txt": ""}, "gave a file the name '../txt'"),
        ({"a/b": ""}, "gave a file the name 'a/b'"),
        ({"": ""}, "gave a file the name ''"),
        ({3: ""}, "gave a file the name 3"),
        (["txt"], "gave a list, not a map of contents"),
        (None, "gave a NoneType, not a map of contents"),
    ],
)
def test_contents_that_are_none(files: Any, says: str, tmp_path: Path) -> None:
    found = emitted(backend(files=files), tmp_path / "out")
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert says in found.message


@pytest.mark.parametrize("name", ["manifest.json", "Manifest.JSON"])
def test_the_manifest_is_roadlangs_own(name: str, tmp_path: Path) -> None:
    found = emitted(backend(collection={name: "{}"}), tmp_path / "out")
    assert found.code == Code.WRONG_PLUGIN_RESULT
    assert "is that of the manifest" in found.message


def test_a_readers_own_diagnostic_has_the_place_of_the_file(tmp_path: Path) -> None:
    @dataclass(frozen=True)
    class Odd(Reader):
        """Says what is wrong with the file."""

        name: ClassVar[str] = "odd"
        suffixes: ClassVar[tuple[str, ...]] = (".odd",)
        reads: ClassVar[tuple[str, ...]] = ("road", "network", "image")

        def read(self, path: Path) -> Any:
            raise DiagnosticError(Diagnostic("ODD01", "error", f"{path.name} has no line"))

    (tmp_path / "line.odd").write_text("nothing")
    for text, place in (
        ('road main from "line.odd"\n', '"line.odd"'),
        ('road main from "line.odd" { read with odd }\n', "read with odd"),
        ('network n from "line.odd"\nroad main from n\n', '"line.odd"'),
        (
            'image i from "line.odd" { scale: 1m/px, read with odd }\n'
            "network n from i\nroad r from n\n",
            "read with odd",
        ),
    ):
        found = fault(text, Odd, folder=tmp_path)
        assert found.code == "ODD01"
        assert found.span is not None
        assert place in found.span.text


def test_a_plugin_that_changes_the_folder_changes_no_output(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "elsewhere").mkdir()

    def go(road: Any) -> Any:
        os.chdir(tmp_path / "elsewhere")
        return 0 * road.stations

    scenes = testing.sample(BENT + "emit json\n", kinds=[perturber(go)])
    os.chdir(tmp_path)
    goes = backend(files={})

    def files(self: Any, scene: Any) -> Any:
        os.chdir(tmp_path / "elsewhere")
        return {"txt": ""}

    goes.files = files  # type: ignore[method-assign]
    scenes = testing.sample(STRAIGHT + "emit json\nemit odd\n", kinds=[goes])
    scenes.emit("out")
    assert (tmp_path / "out" / "scene-0000.json").exists()
    assert not (tmp_path / "elsewhere" / "out").exists()


def test_diagnostics_of_a_plugin_may_use_our_codes() -> None:
    found = fault(
        BENT, perturber(raising(DiagnosticError(diagnose(Code.GRID_TOO_LARGE, most="3"))))
    )
    assert found.code == Code.GRID_TOO_LARGE
    assert found.span is not None
