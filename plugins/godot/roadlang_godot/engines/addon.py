"""The Godot project of roadlang as an addon of another Godot project."""

from __future__ import annotations

import os
import shutil
from configparser import ConfigParser, Error
from pathlib import Path

from .engine import project

FOLDER = Path("addons", "roadlang")
_PROJECT_FILE = "project.godot"
_PLUGIN_FILE = "plugin.cfg"
_ONLY_OF_OUR_PROJECT = shutil.ignore_patterns(
    _PROJECT_FILE, ".*", "tests", "gdlintrc", "*.sh", "*.uid", "*.import"
)
"""A folder with a project file is invisible to the project around it; tests and tools stay."""


def is_project(folder: Path) -> bool:
    """Whether this is the folder of a Godot project."""
    return (folder / _PROJECT_FILE).is_file()


def is_foreign(folder: Path) -> bool:
    """Whether there is something else than this addon where it would be."""
    place = folder / FOLDER
    if not os.path.lexists(place):
        return False
    config = ConfigParser()
    try:
        config.read_string((place / _PLUGIN_FILE).read_text(encoding="utf-8"))
    except (OSError, ValueError, Error):
        return True
    return config.get("plugin", "name", fallback="").strip('"') != "roadlang"


def install_addon(folder: Path) -> Path:
    """Copy the addon into a Godot project, in place of an earlier one; returns where it is.

    What was there is there until the new one is complete. Raises `OSError`.
    """
    place = folder / FOLDER
    place.parent.mkdir(exist_ok=True)
    new = place.with_name(f".roadlang-new-{os.getpid()}")
    old = place.with_name(f".roadlang-old-{os.getpid()}")
    try:
        shutil.copytree(project(), new, ignore=_ONLY_OF_OUR_PROJECT)
        if place.exists():
            place.rename(old)
        new.rename(place)
    except BaseException:  # an interrupt, too
        if old.exists() and not place.exists():
            old.rename(place)
        raise
    finally:
        shutil.rmtree(new, ignore_errors=True)
        shutil.rmtree(old, ignore_errors=True)
    return place
