"""What a plugin raised, in one line with its place; never with a folder of this machine."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from roadlang.plugins.attribution import PluginFault, attributed
from roadlang.plugins.discovery import load_registry
from tests.plugins.installed import install


def reason_of(site: Path, files: Mapping[str, str]) -> str:
    """Why a plugin is broken that consists of these files."""
    install(site, "odd", "")
    (site / "roadlang_odd.py").unlink()
    for name, text in files.items():
        path = site / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    (broken,) = load_registry().broken
    return broken.reason


WRONG = "raise ValueError('two\\nlines')\n"


def test_the_place_is_told_from_the_package_on(site: Path) -> None:
    assert (
        reason_of(site, {"roadlang_odd.py": WRONG}) == "ValueError: two lines (roadlang_odd.py:1)"
    )


def test_a_place_in_a_package_is_told_with_its_folder(site: Path) -> None:
    reason = reason_of(site, {"roadlang_odd/__init__.py": f"\n{WRONG}"})
    assert reason == "ValueError: two lines (roadlang_odd/__init__.py:2)"


def test_a_place_in_a_module_of_a_package_is_told_with_all_folders(site: Path) -> None:
    files = {
        "roadlang_odd/__init__.py": "from roadlang_odd.kinds import wide\n",
        "roadlang_odd/kinds/wide.py": WRONG,
    }
    reason = reason_of(site, files)
    assert reason == "ValueError: two lines (roadlang_odd/kinds/wide.py:1)"


def test_the_place_is_the_last_in_the_plugin_not_in_a_library(site: Path) -> None:
    reason = reason_of(site, {"roadlang_odd.py": "import json\n\njson.loads('{')\n"})
    assert reason.startswith("JSONDecodeError: ")
    assert reason.endswith("(roadlang_odd.py:3)")


def test_what_is_not_implemented_is_told_in_the_plugin_s_words_if_it_has_any(site: Path) -> None:
    text = "def wide():\n    raise NotImplementedError{}\n\nwide()\n"
    said = reason_of(site, {"roadlang_odd.py": text.format("('no loops yet')")})
    assert said == "NotImplementedError: no loops yet (roadlang_odd.py:2)"


def test_an_error_without_words_is_told_by_its_name(site: Path) -> None:
    reason = reason_of(site, {"roadlang_odd.py": "raise KeyError\n"})
    assert reason == "KeyError (roadlang_odd.py:1)"


def test_a_method_that_is_not_implemented_is_named(site: Path) -> None:
    text = "def load():\n    raise NotImplementedError\n\nload()\n"
    assert reason_of(site, {"roadlang_odd.py": text}) == "it does not implement `load`"


def test_who_stops_a_command_is_not_a_fault_of_a_plugin() -> None:
    with pytest.raises(KeyboardInterrupt), attributed():
        raise KeyboardInterrupt
    with pytest.raises(PluginFault, match="SystemExit: 3"), attributed():
        raise SystemExit(3)
