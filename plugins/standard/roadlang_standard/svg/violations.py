"""Violated stretches: a colored band beside the road for each constraint that is broken."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from . import palette
from .markup import element, group, path_data, title

if TYPE_CHECKING:
    from roadlang.api import Scene, Verdict
    from roadlang.geometry import Floats

    from .ribbon import Ribbon

_BAND = 4.0
_SHORTEST = 2.0


def broken(scene: Scene) -> list[Verdict]:
    """The constraints that this scene violates, requirements before expectations."""
    return [
        verdict
        for verdict in (*scene.requirements, *scene.expectations)
        if verdict.satisfied is False
    ]


def violations(scene: Scene, ribbons: Mapping[str, Ribbon]) -> str:
    """Bands along the stretches, side by side where constraints are broken at the same place."""
    return group(_bands(scene, ribbons), class_="violations", fill="none")


def _bands(scene: Scene, ribbons: Mapping[str, Ribbon]) -> Iterator[str]:
    for index, verdict in enumerate(broken(scene)):
        color = palette.violation_color(index)
        for segment in verdict.violated:
            for ribbon in _named(segment.road, ribbons):
                part = ribbon.part(segment.start, segment.end, by_reference=True)
                hint = f"{verdict.name} violated: {segment.start:.1f} m to {segment.end:.1f} m"
                yield element(
                    "path",
                    title(hint),
                    d=path_data(_visible(part, _BAND * (index + 0.9))),
                    stroke=color,
                    stroke_width=_BAND - 0.8,
                    stroke_linecap="round",
                    stroke_opacity=0.9,
                )
                if index == 0:
                    yield element(
                        "path",
                        d=path_data(part.outline(), closed=True),
                        fill=color,
                        fill_opacity=0.28,
                    )


def _named(name: str, ribbons: Mapping[str, Ribbon]) -> list[Ribbon]:
    """The road, or every road of the network, of that name."""
    if name in ribbons:
        return [ribbons[name]]
    return [ribbon for key, ribbon in ribbons.items() if key.startswith(f"{name}/")]


def _visible(part: Ribbon, shift: float) -> Floats:
    """The band's line; a single station gets a short dash along the road."""
    import numpy as np

    line = part.line(1.0, shift)
    if np.hypot(*(line[-1] - line[0])) >= _SHORTEST or len(line) > 2:
        return line
    along = np.array([-part.left[0, 1], part.left[0, 0]])
    return np.stack([line[0] - _SHORTEST / 2 * along, line[0] + _SHORTEST / 2 * along])
