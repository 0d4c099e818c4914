"""Names of agents, objects and roads on the map, clear of each other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import palette
from .actors import SHORTEST_AGENT
from .markup import group, text
from .wrapping import BOLD_LETTER

if TYPE_CHECKING:
    from roadlang.api import Scene, SceneActor
    from roadlang.geometry import Floats

    from .ribbon import Ribbon
    from .viewport import Viewport

_UNLABELED = ("tree", "bush", "building")
_MOST_LABELED_OBJECTS = 12
_MOST_COPIES_LABELED = 4
_GAP = 0.2
"""Font sizes, to either side of a label"""
_HEIGHT = 1.1
"""Font sizes from one line of text to the next"""


@dataclass(frozen=True)
class PixelBox:
    """A rectangle on the page, in pixels; y grows downward."""

    left: float
    top: float
    right: float
    bottom: float

    @classmethod
    def around(cls, x: float, base: float, width: float, size: float) -> PixelBox:
        """The box of text that is centered at `x`, with its baseline at `base`."""
        half, middle = 0.5 * _HEIGHT * size, base - 0.35 * size
        return cls(x - width / 2, middle - half, x + width / 2, middle + half)

    def overlaps(self, other: PixelBox) -> bool:
        """Whether both take up some of the same pixels; never where a coordinate is NaN."""
        return (
            self.left < other.right
            and other.left < self.right
            and self.top < other.bottom
            and other.top < self.bottom
        )


def actor_labels(
    scene: Scene, viewport: Viewport, size: float, taken: Iterable[PixelBox] = ()
) -> str:
    """Names beside agents and the objects worth naming, with a halo; where possible clear of each
    other, of what is `taken`, and of what they do not name."""
    actors = list(scene.agents)
    worthy = [actor for actor in scene.objects if actor.category not in _UNLABELED]
    if len(worthy) <= _MOST_LABELED_OBJECTS:
        actors += worthy
    return group(
        _labels(actors, viewport, size, list(taken)),
        class_="labels",
        font_size=size,
        font_weight="600",
        fill=palette.INK,
        stroke="#ffffff",
        stroke_width=3.2,
        stroke_opacity=0.92,
        paint_order="stroke",
        stroke_linejoin="round",
    )


def _named(actors: Sequence[SceneActor]) -> list[tuple[SceneActor, str]]:
    """Each thing with its label; a group with many copies gets one, with their number."""
    sizes = Counter(actor.group for actor in actors)
    labeled: list[tuple[SceneActor, str]] = []
    seen: set[str] = set()
    for actor in actors:
        if sizes[actor.group] <= _MOST_COPIES_LABELED:
            labeled.append((actor, actor.name))
        elif actor.group not in seen:
            seen.add(actor.group)
            labeled.append((actor, f"{actor.group} ({sizes[actor.group]})"))
    return labeled


def _labels(
    actors: Sequence[SceneActor], viewport: Viewport, size: float, taken: list[PixelBox]
) -> Iterator[str]:
    import numpy as np

    drawn = [_square(actor, viewport) for actor in actors]
    centers = viewport.place(np.reshape([(actor.x, actor.y) for actor in actors], (-1, 2)))
    groups = np.array([actor.group for actor in actors])
    for actor, label in _named(actors):
        x, y = viewport.place([actor.x, actor.y]).tolist()
        reach = _reach(actor, viewport)
        drop = reach + 0.6 * size
        wide = (BOLD_LETTER * len(label) + 2 * _GAP) * size
        beside = reach + 0.2 * size + wide / 2
        spots = [
            (x, y - drop),
            (x, y + drop + 0.7 * size),
            (x - beside, y + 0.35 * size),
            (x + beside, y + 0.35 * size),
            *((x, y - drop - step * 1.15 * size) for step in (1, 2, 3)),
        ]
        boxes = [PixelBox.around(*spot, wide, size) for spot in spots]
        readable = [not any(box.overlaps(other) for other in taken) for box in boxes]
        clear = [
            free and not any(box.overlaps(other) for other in drawn)
            for free, box in zip(readable, boxes, strict=True)
        ]
        others = centers[groups != actor.group] if label != actor.name else centers
        own = _are_nearest(spots, actor, others, viewport, size)
        wishes = [[a and b for a, b in zip(free, own, strict=True)] for free in (clear, readable)]
        chosen = next((free.index(True) for free in (*wishes, clear, readable) if any(free)), 0)
        taken.append(boxes[chosen])
        yield text(label, *spots[chosen], text_anchor="middle")


def _are_nearest(
    spots: Sequence[tuple[float, float]],
    actor: SceneActor,
    others: Floats,
    viewport: Viewport,
    slack: float,
) -> list[bool]:
    """Whether a label at each spot is nearer to what it names than to all `others` (n, 2), but for
    `slack` pixels."""
    import numpy as np

    off = np.array(spots)[:, None] - np.concatenate([viewport.place([[actor.x, actor.y]]), others])
    away = np.hypot(off[..., 0], off[..., 1])
    return [bool(near) for near in away[:, 0] <= away.min(axis=1) + slack]


def _reach(actor: SceneActor, viewport: Viewport) -> float:
    """Pixels from the middle of an agent or object to its end."""
    return max(max(actor.length, actor.width) * viewport.pixels_per_meter, SHORTEST_AGENT) / 2


def _square(actor: SceneActor, viewport: Viewport) -> PixelBox:
    """Around an agent or object, however it is turned."""
    x, y = viewport.place([actor.x, actor.y]).tolist()
    reach = _reach(actor, viewport)
    return PixelBox(x - reach, y - reach, x + reach, y + reach)


def road_names(roads: Iterable[Ribbon], size: float) -> str:
    """The names of roads where they end, of several that are drawn in full."""
    shown = list(roads)
    if len(shown) < 2:
        return ""
    labels = [end_label(ribbon, shown[:i], size, palette.INK) for i, ribbon in enumerate(shown)]
    return group(labels, class_="road-names")


def end_label(ribbon: Ribbon, before: Sequence[Ribbon], size: float, color: str) -> str:
    """The name of a road a little beyond its end, clear of those of roads that end there too."""
    x, y = ribbon.center[-1].tolist()
    left_x, left_y = ribbon.left[-1].tolist()
    crowd = sum(bool(abs(other.center[-1] - (x, y)).max() < 2 * size) for other in before)
    ahead = (1.3 * crowd + 1.3) * size
    return text(ribbon.name, x - ahead * left_y, y + ahead * left_x + 0.35 * size,
                text_anchor="middle", font_size=size, font_weight="600", fill=color,
                stroke=palette.GROUND, stroke_width=3.0, paint_order="stroke")  # fmt: skip
