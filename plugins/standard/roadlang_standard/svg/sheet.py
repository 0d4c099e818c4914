"""Many scenes on one sheet, all at one scale, to compare them at a glance."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence, Sized
from itertools import islice
from typing import TYPE_CHECKING

from . import furniture, palette
from .drawing import Style, document, map_of
from .markup import element, group, rho, text
from .profiles import number_text
from .viewport import BoundingBox, Viewport, bounds, within
from .wrapping import letters, wrapped

if TYPE_CHECKING:
    from collections.abc import Iterable

    from roadlang.api import Scene

MOST_SCENES = 48
_GAP = 14.0
_LINE = 1.2
_SMALL = 0.85
_MOST_LINES = 3


def contact_sheet(scenes: Iterable[Scene], size: float) -> str | None:
    """The first `MOST_SCENES` scenes in a grid; None where there are fewer than two."""
    stream = iter(scenes)
    shown = list(islice(stream, MOST_SCENES))
    rest = len(scenes) - len(shown) if isinstance(scenes, Sized) else sum(1 for _ in stream)
    if len(shown) < 2:
        return None
    box = _around(shown)
    columns = _columns(len(shown), box)
    cell = (size - _GAP * (columns + 1)) / columns
    tall = cell * min(max(box.height / max(box.width, 1e-9), 0.35), 1.3)
    font = max(size / 90, 8.0)
    notes = _notes(shown, letters(cell, _SMALL * font))
    head, caption = 3.2 * font, (1.6 + _LINE * max(map(len, notes))) * font
    parts = [_heading(shown[0], len(shown), rest, _GAP, 1.9 * font, font)]
    for index, (scene, note) in enumerate(zip(shown, notes, strict=True)):
        row, column = divmod(index, columns)
        x = _GAP + column * (cell + _GAP)
        y = head + row * (tall + caption + _GAP)
        frame = Viewport(box, x, y, cell, tall)
        parts.append(_cell(scene, within(box, frame), f"cell-{index}", font, note))
    rows = math.ceil(len(shown) / columns)
    height = head + rows * (tall + caption + _GAP)
    return document(parts, size, height, f"{shown[0].title or shown[0].name}: contact sheet")


def _notes(scenes: Sequence[Scene], most: int) -> list[list[str]]:
    """Below each scene, in lines of at most `most` letters: the nearest miss and the draws."""
    names = _varying(scenes)
    return [
        [
            *(wrapped(outcome, most) if (outcome := _outcome(scene)[1]) else ()),
            *wrapped(_draws(scene, names, (_MOST_LINES + 1) * (most + 1)), most)[:_MOST_LINES],
        ]
        for scene in scenes
    ]


def _varying(scenes: Sequence[Scene]) -> dict[str, str]:
    """The draws that differ between scenes, by place, with the shortest name that is unique."""
    places = dict.fromkeys(place for scene in scenes for place in scene.draws)
    differing = [place for place in places if _differs(place, scenes)]
    ends = [place.rpartition("/")[2] for place in differing]
    count = Counter(ends)
    return {
        place: end if count[end] == 1 else place for place, end in zip(differing, ends, strict=True)
    }


def _differs(place: str, scenes: Sequence[Scene]) -> bool:
    first = repr(scenes[0].draws.get(place))
    return any(repr(scene.draws.get(place)) != first for scene in scenes)


def _draws(scene: Scene, names: Mapping[str, str], most: int) -> str:
    """The first of them, of `most` letters or a little more."""
    shown = ""
    for place, name in names.items():
        if place in scene.draws:
            value = _value(scene.draws[place], scene.units.get(place, ""))
            shown += f"{', ' if shown else ''}{name}\N{NO-BREAK SPACE}{value}"
        if len(shown) > most:
            break
    return shown


def _value(value: object, unit: str) -> str:
    if not isinstance(value, float):
        return str(value)
    if unit == "rad":
        return f"{number_text(math.degrees(value))}°"
    return f"{number_text(value)}\N{NO-BREAK SPACE}{unit}" if unit else number_text(value)


def _around(scenes: Sequence[Scene]) -> BoundingBox:
    box = bounds(scenes[0])
    for scene in scenes[1:]:
        box = box.around(bounds(scene))
    return box


def _columns(count: int, box: BoundingBox) -> int:
    """As many as make the sheet about as wide as tall, for cells of the shape of `box`."""
    shape = min(max(box.height / max(box.width, 1e-9), 0.35), 1.3)
    return max(1, min(count, round(math.sqrt(count * (shape + 0.15) * 1.3))))


def _heading(scene: Scene, shown: int, rest: int, x: float, base: float, font: float) -> str:
    count = f"{shown} scenes" if not rest else f"the first {shown} of {shown + rest} scenes"
    title = f"{scene.title or scene.name}: {count}, seed {scene.provenance.seed}"
    return text(title, x, base, font_size=1.35 * font, font_weight="700", fill=palette.INK)


def _cell(scene: Scene, viewport: Viewport, clip: str, font: float, note: Sequence[str]) -> str:
    style = Style(viewport.width, labels=False, legend=False, stations=False, profiles=False)
    base = viewport.y + viewport.height + 1.35 * font
    color, outcome = _outcome(scene)
    lines = [
        text(
            line,
            viewport.x,
            base + (index + 1) * _LINE * font,
            font_size=_SMALL * font,
            fill=color if outcome.startswith(line) else palette.MUTED_INK,
        )
        for index, line in enumerate(note)
    ]
    return group(
        [
            element("defs", furniture.clip(viewport, clip)),
            map_of(scene, viewport, style, clip),
            furniture.frame(viewport),
            text(f"scene {scene.index}", viewport.x, base, font_size=font, font_weight="600",
                 fill=palette.INK),
            *lines,
        ],
        class_="cell",
    )  # fmt: skip


def _outcome(scene: Scene) -> tuple[str, str]:
    """The constraint that came nearest to failing, or that failed worst."""
    verdicts = (*scene.requirements, *scene.expectations)
    judged = [(v.robustness, v.name) for v in verdicts if v.robustness is not None]
    if not judged:
        return palette.MUTED_INK, ""
    worst, name = min(judged)
    failed = any(verdict.satisfied is False for verdict in verdicts)
    color = palette.VIOLATIONS[0] if failed else palette.MUTED_INK
    return color, f"{name}: {rho(worst)}"
