"""Paths as they are recorded in JSON, which holds text alone; names of files may hold any bytes."""

from __future__ import annotations

import os


def recorded_name(path: str | os.PathLike[str]) -> str:
    r"""The path; bytes of it that are not UTF-8 as `\xff`."""
    return os.fsencode(path).decode("utf-8", "backslashreplace")
