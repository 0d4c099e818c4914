"""Which options of `roadlang render` go together: none is ignored."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import click

LEAST_SIDE, MOST_SIDE = 16, 8192
"""Pixels."""
_SCENE_IMAGES = frozenset(("picture", "clip"))
_APPLY_TO: Mapping[str, frozenset[str]] = {
    "count": frozenset(("dataset",)),
    "every": frozenset(("dataset",)),
    "clips": frozenset(("dataset",)),
    "scenes": frozenset(("dataset",)),
    "index": frozenset(("picture", "clip", "3D file")),
    "size": _SCENE_IMAGES | {"dataset"},
    "view": _SCENE_IMAGES,
    "agent": _SCENE_IMAGES,
    "camera": _SCENE_IMAGES,
    "scale": _SCENE_IMAGES,
    "duration": frozenset(("clip",)),
    "fps": frozenset(("clip",)),
}
"""What an option is for; all others are for everything that is rendered."""
_VIEW_OF = {"camera": "free", "scale": "top", "agent": "chase"}
"""The view that an option belongs to, and chooses where none is named."""
_WRITTEN = {
    "dataset": "a dataset (`--dataset DIR`)",
    "picture": "a picture (`-o FILE.png`)",
    "clip": "a clip (`-o FILE.mp4`)",
    "3D file": "a 3D file (`-o FILE.glb`)",
}


def refuse_unused(written: str) -> None:
    """`click.UsageError` for an option that does nothing for what is written: a "picture", "clip",
    "3D file" or "dataset"."""
    context = click.get_current_context()
    for parameter in context.command.params:
        name = parameter.name or ""
        for_these = _APPLY_TO.get(name, frozenset((written,)))
        if context.get_parameter_source(name) is not _GIVEN or written in for_these:
            continue
        goes_with = " or ".join(text for kind, text in _WRITTEN.items() if kind in for_these)
        raise click.UsageError(
            f"{parameter.opts[0]} is for {goes_with}; this is {_WRITTEN[written]}"
        )


_GIVEN = click.core.ParameterSource.COMMANDLINE


def chosen_view(options: Mapping[str, Any], has_agents: bool) -> str:
    """`chase`, `top` or `free`: as named, or as an option for one of them implies.

    Raises `click.UsageError` for options of different views.
    """
    view: str | None = options["view"]
    because = f"--view {view}"
    for name, belongs_to in _VIEW_OF.items():
        if options[name] is None:
            continue
        if view not in (None, belongs_to):
            raise click.UsageError(f"--{name} goes with --view {belongs_to}, not with {because}")
        view, because = belongs_to, f"--{name}"
    return view or ("chase" if has_agents else "top")


def image_size(text: str | None, default: str) -> tuple[int, int]:
    """Width and height in pixels. Raises `click.BadParameter`."""
    text = default if text is None else text
    width, _, height = text.partition("x")
    if not (width.isdecimal() and height.isdecimal()):
        _refuse_size(text, "write WIDTHxHEIGHT")
    if not all(LEAST_SIDE <= int(side) <= MOST_SIDE for side in (width, height)):
        _refuse_size(text, f"both are {LEAST_SIDE} to {MOST_SIDE} pixels")
    return int(width), int(height)


def _refuse_size(text: str, expected: str) -> None:
    message = f"`{text}` is not a size such as 1280x720: {expected}"
    raise click.BadParameter(message, param_hint="--size")


def camera_pose(text: str) -> tuple[float, ...]:
    """x, y, z in meters, yaw and pitch in degrees. Raises `click.BadParameter`."""
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != 5 or not all(map(math.isfinite, numbers)):
        expected = "write five numbers without units, x,y,z,yaw,pitch, such as 0,-20,8,90,-15"
        raise click.BadParameter(f"`{text}`: {expected}", param_hint="--camera")
    return numbers
