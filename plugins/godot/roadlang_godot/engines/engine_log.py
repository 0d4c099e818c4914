"""Log files of engines, each in a folder named after the process that started the engine."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

_LOG_FOLDER = "roadlang-godot-"


def new_log() -> Path:
    """A file in a new folder. Removes the folders of processes that ended before they could."""
    _remove_abandoned_logs()
    prefix = f"{_LOG_FOLDER}{os.getpid()}-"
    return Path(tempfile.mkdtemp(prefix=prefix)) / "engine.log"


def _remove_abandoned_logs() -> None:
    for folder in Path(tempfile.gettempdir()).glob(f"{_LOG_FOLDER}[0-9]*-*"):
        number = folder.name.removeprefix(_LOG_FOLDER).partition("-")[0]
        if number.isdigit() and not _exists(int(number)):
            shutil.rmtree(folder, ignore_errors=True)


def _exists(process: int) -> bool:
    if os.name == "nt":  # there a signal ends a process
        return True
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        pass
    return True
