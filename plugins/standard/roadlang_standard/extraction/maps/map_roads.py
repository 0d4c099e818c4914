"""Which colors of a rendered map are its roads: by exact colors, or with their smoothed edges."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..colors.tones import Image
from .map_lines import THIN, with_line_colors, without_outlines
from .map_styles import MapStyle
from .map_tones import MapTone, Tolerance, map_tones
from .map_water import KnownWater, without_water
from .road_tones import road_tones
from .shared_colors import with_streets_alone

_MORE = 0.2
"""Colors of thin streets are added if these are at least this long, as a share of the main
roads."""


@dataclass(frozen=True)
class MapRoads:
    """The colors of roads on a map without letters; all its tones, in which water and houses may
    have the color of streets; and its tones without these."""

    all_tones: list[MapTone]
    tones: list[MapTone]
    roads: list[MapTone]
    styled: bool = False
    """whether the style of the map is known"""

    @property
    def land(self) -> MapTone:
        """The tone that covers most."""
        return max(self.all_tones, key=lambda tone: np.count_nonzero(tone.mask))

    def adds_streets(self, other: MapRoads) -> bool:
        """Whether these are the roads of another one, if it has any, and some of thin colors."""
        if not other.roads:
            return True
        known, also = ([tone.color.tolist() for tone in one.roads] for one in (other, self))
        added = [tone for tone in self.roads if tone.color.tolist() not in known]
        return (
            known[0] == also[0]
            and all(color in also for color in known)
            and all(tone.width < THIN for tone in added)
            and sum(tone.steady_length for tone in added) > _MORE * other.roads[0].steady_length
        )

    def width(self, of: Callable[[MapTone], float]) -> float:
        """Usual width of the roads, pixels, given that of each tone."""
        lengths = np.array([max(1.0, tone.steady_length) for tone in self.roads])
        return float(lengths @ [of(tone) for tone in self.roads] / lengths.sum())


def chosen_roads(
    plain: Image,
    colors: list[NDArray[np.float64]],
    tolerance: Tolerance,
    style: MapStyle | None = None,
) -> tuple[MapRoads, bool]:
    """The roads of a map (h, w, 3) without letters, and whether its tones have smoothed edges; of a
    map in a known `style` by its colors."""
    if style is not None:
        found = _styled_roads(plain, colors, tolerance, style)
        if found is not None:
            return found
    water = KnownWater()
    fine_tones = map_tones(plain, with_line_colors(plain, colors), tolerance, smooth=True)
    fine = _fine_roads(fine_tones, water)
    if fine is not None and fine.width(lambda tone: tone.width) < THIN:
        return fine, True
    all_tones = [tone.measured_in(fine_tones) for tone in map_tones(plain, colors, tolerance)]
    tones = without_water(all_tones, water)
    chosen = MapRoads(all_tones, tones, road_tones(with_streets_alone(tones), min(plain.shape[:2])))
    # Names on streets leave less of them even than what is known of their edges.
    if fine is not None and fine.adds_streets(chosen):
        return fine, True
    return chosen, False


def _fine_roads(all_tones: list[MapTone], water: KnownWater) -> MapRoads | None:
    """The roads of a map whose tones have smoothed edges."""
    tones = without_water(all_tones, water)
    streets = without_outlines(with_streets_alone(tones))
    found = MapRoads(all_tones, tones, road_tones(streets, min(all_tones[0].mask.shape)))
    return found if found.roads else None


def _styled_roads(
    plain: Image, colors: list[NDArray[np.float64]], tolerance: Tolerance, style: MapStyle
) -> tuple[MapRoads, bool] | None:
    """The roads of a map (h, w, 3) in a known style, by their colors alone: in a small picture,
    few of them are long enough to be told by their shape."""
    tones = map_tones(plain, colors, tolerance)
    found = MapRoads(tones, tones, style.roads_among(tones, tolerance), styled=True)
    if not found.roads:
        return None
    if found.width(lambda tone: tone.width) >= THIN:
        return found, False
    tones = map_tones(plain, with_line_colors(plain, colors), tolerance, smooth=True)
    return MapRoads(tones, tones, style.roads_among(tones, tolerance), styled=True), True
