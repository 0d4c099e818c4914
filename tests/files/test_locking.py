"""Whether somebody who is alive works in a folder."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from roadlang.files.locking import held_lock, may_be_held

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="folders cannot be locked there")


def test_a_lock_is_seen_while_it_is_held(tmp_path: Path) -> None:
    assert not may_be_held(tmp_path)
    with held_lock(tmp_path):
        assert may_be_held(tmp_path)
    assert not may_be_held(tmp_path)


def test_of_a_folder_that_cannot_be_opened_nobody_knows(tmp_path: Path) -> None:
    assert may_be_held(tmp_path / "none")
