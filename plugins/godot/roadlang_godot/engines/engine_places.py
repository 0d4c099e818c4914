"""Where Godot usually is."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

_NAMES = ("godot4", "godot", "Godot", "godot4-bin")
_PLACES = (
    "/usr/local/bin",
    "/usr/bin",
    "/opt/godot",
    "/opt/godot4",
    "~/.local/bin",
    "~/bin",
    "/snap/bin",
    "/var/lib/flatpak/exports/bin",
    "/Applications/Godot.app/Contents/MacOS",
    "~/Applications/Godot.app/Contents/MacOS",
    "C:/Program Files/Godot",
)


def usual_executables() -> Iterator[str]:
    """Names to look for on PATH, then paths."""
    yield from _NAMES
    for place in _PLACES:
        for name in _NAMES:
            yield str(Path(place).expanduser() / name)
