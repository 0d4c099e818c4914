"""Whether somebody who is alive works in a folder."""

from __future__ import annotations

import gc
import os
import sys
from pathlib import Path

import pytest

from roadlang.files.locking import FileLock, folder_lock, held_lock, may_be_held

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="folders cannot be locked there")


def test_a_lock_is_seen_while_it_is_held(tmp_path: Path) -> None:
    assert not may_be_held(tmp_path)
    with held_lock(tmp_path):
        assert may_be_held(tmp_path)
    assert not may_be_held(tmp_path)


def test_of_a_folder_that_cannot_be_opened_nobody_knows(tmp_path: Path) -> None:
    assert may_be_held(tmp_path / "none")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system cannot fork")
def test_a_lock_ends_with_the_process_that_took_it_where_that_was_forked(tmp_path: Path) -> None:
    """A copy of the handle, in a process that lives on, would hold it."""
    import fcntl

    (ends, end), (begins, begin) = os.pipe(), os.pipe()
    with folder_lock(tmp_path):
        file_lock = FileLock(tmp_path / "file")
        child = os.fork()
        if child == 0:
            os.write(begin, b"x")
            os.read(ends, 1)
            os._exit(0)
    os.read(begins, 1)
    try:
        assert not may_be_held(tmp_path)
        del file_lock
        gc.collect()
        handle = os.open(tmp_path / "file", os.O_RDWR)
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        os.close(handle)
    finally:
        os.write(end, b"x")
        os.waitpid(child, 0)
        for each in (ends, end, begins, begin):
            os.close(each)
