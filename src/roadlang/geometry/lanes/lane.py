"""One lane of a road."""

from __future__ import annotations

from dataclasses import dataclass

from ..curves.width import WidthProfile
from ..errors import GeometryError
from .lanes import DIRECTIONS, MARKINGS, Direction, Marking

_OPPOSITE: dict[Direction, Direction] = {
    "forward": "backward",
    "backward": "forward",
    "both": "both",
    "none": "none",
}


@dataclass(frozen=True, eq=False)
class Lane:
    """A strip of a road, `width` meters wide.

    `id` is that of OpenDRIVE: -1 the first to the right of the reference line, 1 the first to its
    left. `kind` is a name ("drive", "sidewalk", ...) that geometry does not interpret. `direction`
    is that of travel along the curve of the road; `drivable` means for motor vehicles;
    `speed_limit` is in m/s; `marking` is the line toward the outer neighbor; `users` says who may
    use it ("bus", "bicycle"), where that is known; `raised` lanes lie behind a curb. Raises
    GeometryError for the id 0, a word that is none of `DIRECTIONS` or `MARKINGS`, and a limit that
    is not positive.
    """

    id: int
    kind: str
    width: WidthProfile
    direction: Direction = "forward"
    drivable: bool = True
    speed_limit: float | None = None
    marking: Marking = "none"
    users: tuple[str, ...] = ()
    raised: bool = False

    def __post_init__(self) -> None:
        if self.id == 0:
            raise GeometryError("no lane has the id 0, which is the reference line's")
        if self.direction not in DIRECTIONS:
            raise GeometryError(f"a lane runs {', '.join(DIRECTIONS)}, not {self.direction}")
        if self.marking not in MARKINGS:
            raise GeometryError(f"a marking is {', '.join(MARKINGS)}, not {self.marking}")
        if self.speed_limit is not None and not 0.0 < self.speed_limit < float("inf"):
            raise GeometryError("a speed limit must be positive")

    @property
    def opposite_direction(self) -> Direction:
        """The direction as seen by who travels the road the other way."""
        return _OPPOSITE[self.direction]
