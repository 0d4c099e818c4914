"""Tests with the tools of other projects: skipped where a tool cannot be installed, or failed."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.formats import tool_environments, tool_installation

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="nothing is installed there")


@pytest.fixture(autouse=True)
def empty_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """No tool is installed, and there is no npm."""
    monkeypatch.setenv("ROADLANG_TEST_TOOLS", str(tmp_path))
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("ROADLANG_REQUIRE_TOOLS", raising=False)
    monkeypatch.setattr(tool_environments, "_unavailable", {})
    return tmp_path


def test_a_tool_that_cannot_be_installed_skips_with_the_reason() -> None:
    with pytest.raises(pytest.skip.Exception, match="gltf-validator is not available: npm is not"):
        tool_environments.tool_folder("gltf-validator")


def test_a_tool_that_is_required_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROADLANG_REQUIRE_TOOLS", "1")
    with pytest.raises(pytest.fail.Exception, match="npm is not installed"):
        tool_environments.tool_folder("gltf-validator")


def test_what_an_interrupted_installation_left_is_not_used(
    empty_cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    targets: list[Path] = []

    def install(pins: Path, target: Path) -> None:
        assert not (target / "half").exists()
        target.mkdir()
        targets.append(target)

    monkeypatch.setattr(tool_installation, "_install_npm", install)
    folder = tool_installation.installed_tool("gltf-validator")
    (folder / "half").touch()
    assert tool_installation.installed_tool("gltf-validator") == folder
    assert len(targets) == 1
    (folder / "ready").unlink()
    tool_installation.installed_tool("gltf-validator")
    assert targets == [folder, folder]


def test_without_space_nothing_is_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tool_installation, "_NEEDED_BYTES", 10**18)
    with pytest.raises(tool_installation.ToolUnavailableError, match="GB are free"):
        tool_installation.installed_tool("sumo")
