"""Files that a name with `*` and `?` stands for."""

from __future__ import annotations

import fnmatch
import os
from pathlib import Path


def files_matching(path: Path) -> list[Path]:
    """The regular files that `path` names, by name.

    `*` and `?` in the last part of `path` stand for any characters and for any one character,
    unless there is a file of that very name. A path without them stands for itself, there or not.
    """
    if not ("*" in path.name or "?" in path.name) or os.path.exists(path):
        return [path]
    pattern = path.name.replace("[", "[[]")
    try:
        found = [each for each in path.parent.iterdir() if fnmatch.fnmatchcase(each.name, pattern)]
    except OSError:
        return []
    return sorted(each for each in found if os.path.isfile(each))
