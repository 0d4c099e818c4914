"""Installed distributions and their entry points, read as `importlib.metadata` reads them."""

from __future__ import annotations

import importlib.metadata
import os.path
import sys
import zipfile
from pathlib import Path

import pytest

from roadlang.plugins.installed import EntryPoint, entry_points

METADATA = """Metadata-Version: 2.1
Name: Acme-Roads
Version: 1.2
Requires-Dist: roadlang>=0.1
Requires-Dist: numpy>=1.24; extra == "fast"
Summary: of
 two lines
  Version: 9

Name: not.this
"""
POINTS = """
[console_scripts]
acme = acme:main

[roadlang.commands]
# a comment
hello = roadlang_acme.commands : Hello.command [extra]
"""


def _site(folder: Path, name: str = "acme_roads-1.2.dist-info") -> Path:
    metadata = folder / name
    metadata.mkdir(parents=True)
    (metadata / "METADATA").write_text(METADATA)
    (metadata / "entry_points.txt").write_text(POINTS)
    return folder


def _named(points: list[EntryPoint]) -> list[tuple[str, str, str]]:
    return [(point.group, point.name, point.value) for point in points]


def test_they_are_those_of_the_standard_library() -> None:
    theirs = {
        (point.group, point.name, point.value)
        for distribution in importlib.metadata.distributions()
        for point in distribution.entry_points
        if point.group.startswith("roadlang")
    }
    assert len(theirs) > 5
    assert set(_named(entry_points("roadlang"))) == theirs


def test_headers_of_a_distribution(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", [str(_site(tmp_path))])
    (point,) = entry_points("roadlang")
    assert (point.group, point.name) == ("roadlang.commands", "hello")
    assert point.module == "roadlang_acme.commands"
    assert (point.installed.name, point.installed.version) == ("Acme-Roads", "1.2")
    assert point.installed.requires == ["roadlang>=0.1", 'numpy>=1.24; extra == "fast"']


def test_what_is_installed_anew_or_taken_away_is_noticed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "path", [str(_site(tmp_path))])
    assert [point.name for point in entry_points("roadlang")] == ["hello"]
    file = tmp_path / "acme_roads-1.2.dist-info" / "entry_points.txt"
    fresh = file.with_name("fresh")
    fresh.write_text(POINTS.replace("hello", "jello"))
    fresh.replace(file)
    assert [point.name for point in entry_points("roadlang")] == ["jello"]
    file.unlink()
    assert entry_points("roadlang") == []


def test_the_first_of_a_path_is_the_one_that_counts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = _site(tmp_path / "first", "Acme.Roads-1.3.dist-info")
    second = _site(tmp_path / "second")
    folders = [str(tmp_path / "gone"), str(first), str(second)]
    monkeypatch.setattr(sys, "path", folders)
    (point,) = entry_points("roadlang")
    assert point.installed.folder.startswith(str(first))


def test_a_zip_file_is_read_by_the_standard_library(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    packed = tmp_path / "acme.zip"
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr("acme_roads-1.2.dist-info/METADATA", METADATA)
        archive.writestr("acme_roads-1.2.dist-info/entry_points.txt", POINTS)
    monkeypatch.setattr(sys, "path", [str(packed), *sys.path])
    found = next(p for p in entry_points("roadlang") if p.installed.name == "Acme-Roads")
    assert found.installed.version == "1.2"
    assert found.installed.requires[0] == "roadlang>=0.1"


@pytest.mark.parametrize("module", ["importlib.metadata", "importlib_metadata"])
@pytest.mark.parametrize("strange", [False, True])
def test_other_finders_find_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, module: str, strange: bool
) -> None:
    finder = pytest.importorskip(module).MetadataPathFinder
    if strange:  # one that we know nothing of: `importlib.metadata` is asked
        finder = type("Finder", (finder,), {})
    ours = [found for found in sys.meta_path if not hasattr(found, "find_distributions")]
    monkeypatch.setattr(sys, "meta_path", [*ours, finder()])
    whole = _site(tmp_path / "whole", "Acme.Roads-1.3.dist-info")
    bare = _site(tmp_path / "bare", "bare_roads-1.0.dist-info")
    (bare / "bare_roads-1.0.dist-info" / "METADATA").unlink()
    shadowed = _site(tmp_path / "shadowed", "acme_roads-1.1.dist-info")
    monkeypatch.setattr(sys, "path", [str(whole), str(bare), str(shadowed)])
    assert len(entry_points("roadlang")) == 2


def test_a_distribution_without_metadata(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (_site(tmp_path) / "acme_roads-1.2.dist-info" / "METADATA").unlink()
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    (point,) = entry_points("roadlang")
    assert (point.installed.name, point.installed.version) == ("acme_roads", "0")
    assert point.installed.requires == []


def test_loading_follows_the_attributes_of_the_module() -> None:
    installed = entry_points("roadlang")[0].installed
    assert EntryPoint("g", "n", "os:path.join", installed).load() is os.path.join
    assert EntryPoint("g", "n", "os.path", installed).load() is os.path
    with pytest.raises(AttributeError):
        EntryPoint("g", "n", "os:nothing", installed).load()
    with pytest.raises(ModuleNotFoundError):
        EntryPoint("g", "n", "os.nothing:x", installed).load()
