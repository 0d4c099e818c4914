"""The one way to read a file that a user names: a regular file, and no more of it than is meant."""

from __future__ import annotations

import os
import stat
from pathlib import Path

LARGEST_SCENE_FILE = 4_000_000
"""Bytes. A scene file is written by people; what is larger was not meant."""
LARGEST_INPUT = 400_000_000
"""Bytes of a picture, a table or a trace."""

_KINDS = (
    (stat.S_ISDIR, "it is a folder"),
    (stat.S_ISFIFO, "it is a pipe, not a file"),
    (stat.S_ISSOCK, "it is a socket, not a file"),
    (stat.S_ISCHR, "it is a device, not a file"),
    (stat.S_ISBLK, "it is a device, not a file"),
)


class UnreadableFile(Exception):
    """Why a file was not read, in words that follow its name.

    `is_missing` where there is none, `is_folder` for a folder, `size` in bytes where it is larger
    than the limit.
    """

    def __init__(
        self,
        reason: str,
        *,
        is_missing: bool = False,
        is_folder: bool = False,
        size: int | None = None,
    ) -> None:
        super().__init__(reason)
        self.reason = reason
        self.is_missing = is_missing
        self.is_folder = is_folder
        self.size = size


def read_file(path: Path, limit: int = LARGEST_INPUT) -> bytes:
    """The bytes of a regular file of at most `limit` bytes.

    Devices, pipes and the like are refused before they are opened, since they may have no end, or
    wait for ever. Raises `UnreadableFile`.
    """
    return _read(path, limit, must_fit=True)


def written_text(data: bytes) -> str:
    """The text of a file that somebody wrote, in UTF-8. Line ends of CR alone, as old Macs have
    them, become LF, so that places stay. Raises UnicodeDecodeError."""
    text = data.decode("utf-8-sig")
    return text if "\n" in text else text.replace("\r", "\n")


def read_start(path: Path, count: int) -> bytes:
    """The first `count` bytes of a regular file, or all where it has fewer.

    Raises `UnreadableFile`.
    """
    return _read(path, count, must_fit=False)


def read_ends(path: Path, first: int, last: int) -> tuple[bytes, bytes, int]:
    """The `first` and the `last` bytes of a regular file, which overlap where it has fewer, and how
    many it has. Raises `UnreadableFile`."""
    start = read_start(path, first)
    try:
        with path.open("rb") as file:
            size = file.seek(0, os.SEEK_END)
            file.seek(max(0, size - last))
            return start, file.read(last), size
    except OSError as error:
        raise UnreadableFile((error.strerror or str(error)).lower()) from None


def _read(path: Path, limit: int, *, must_fit: bool) -> bytes:
    try:
        refuse_others(os.stat(path))
        # Should it have become a pipe in the meantime, opening does not wait for its other end.
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | _BINARY)
        with os.fdopen(handle, "rb") as file:
            found = os.fstat(handle)
            refuse_others(found)
            content = file.read(limit + must_fit)
    except (OSError, ValueError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise UnreadableFile(reason, is_missing=isinstance(error, FileNotFoundError)) from None
    if len(content) > limit:
        size = max(found.st_size, len(content))
        reason = f"it has {size / 1e6:.1f} MB, and {limit / 1e6:.0f} MB can be read"
        raise UnreadableFile(reason, size=size)
    return content


_BINARY = getattr(os, "O_BINARY", 0)


def refuse_others(found: os.stat_result) -> None:
    """Raise `UnreadableFile` for what is no regular file."""
    if not stat.S_ISREG(found.st_mode):
        known = (words for is_kind, words in _KINDS if is_kind(found.st_mode))
        is_folder = stat.S_ISDIR(found.st_mode)
        raise UnreadableFile(next(known, "it is not a file"), is_folder=is_folder)
