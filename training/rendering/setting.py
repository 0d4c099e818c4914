"""The mood of a picture: season, sun, palette, density; drawn once per scene."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from training.rendering.frame import Frame

Color = tuple[float, ...]

_PALETTES: dict[str, dict[str, Color]] = {
    "bare": {
        "wood": (0.28, 0.33, 0.37),
        "evergreen": (0.16, 0.23, 0.18),
        "lawn": (0.30, 0.43, 0.40),
        "field": (0.33, 0.45, 0.50),
        "soil": (0.42, 0.52, 0.60),
        "water": (0.20, 0.22, 0.15),
    },
    "green": {
        "wood": (0.16, 0.29, 0.21),
        "evergreen": (0.11, 0.21, 0.14),
        "lawn": (0.28, 0.50, 0.40),
        "field": (0.32, 0.55, 0.50),
        "soil": (0.45, 0.55, 0.65),
        "water": (0.30, 0.28, 0.16),
    },
    "dry": {
        "wood": (0.20, 0.29, 0.28),
        "evergreen": (0.14, 0.22, 0.16),
        "lawn": (0.40, 0.54, 0.58),
        "field": (0.46, 0.60, 0.68),
        "soil": (0.52, 0.62, 0.72),
        "water": (0.35, 0.30, 0.18),
    },
}

_DENSE = {
    "city": 1.0,
    "boulevard": 0.4,
    "grid": 0.5,
    "village": 0.3,
    "suburb": 0.25,
    "roundabout": 0.3,
}
"""Chance that the houses of a plan stand close together."""


@dataclass(frozen=True)
class Setting:
    """What every painter of one scene shares. Angles in picture axes, lengths in meters."""

    frame: Frame
    palette: dict[str, Color]
    sun: float
    """Direction in which shadows fall."""
    slant: float
    """Length of a shadow per meter of height."""
    dusk: float
    """How much light a full shadow takes away, 0..1."""
    woods: float
    """Bias of the wooded area: about -1.5 (none) to 1.5 (nearly all)."""
    leafless: bool
    trees: float
    """Single trees per hectare."""
    overhang: float
    """How far crowns reach over the road edge on average (negative: stay clear)."""
    homes: float
    """Chance that a lot beside a street is built on."""
    city: float
    """Share of large buildings and parking lots, 0..1."""
    asphalt: float
    """Gray of the road surface, 0..1."""
    asphalt_spread: float
    cars: float
    """Cars per 100 m of lane."""
    dense: bool
    """Houses stand close together and near the street, with yards behind."""
    footways: bool
    """Footways run beside the streets."""
    plain: bool = False
    """Open ground with the roads and nothing else."""

    def emptied(self) -> Setting:
        """The same without woods, trees, houses and footways."""
        return replace(self, woods=-9.0, trees=0.0, homes=0.0, footways=False, plain=True)

    def built_up(self, gray: float) -> Setting:
        """The same town with concrete and gravel for lawns and fields: a gray of 0..1."""
        stone = {
            name: tuple(gray * share * np.array([0.97, 1.0, 1.02]))
            for name, share in (("lawn", 1.0), ("field", 0.9), ("soil", 1.25))
        }
        return replace(self, palette={**self.palette, **stone}, woods=-9.0, cars=3 * self.cars)


def setting_of(
    rng: np.random.Generator,
    frame: Frame,
    plan: str,
    seasons: tuple[float, float, float] = (0.55, 0.3, 0.15),
) -> Setting:
    """A mood that suits the kind of plan; `seasons` are the chances of bare, green and dry land."""
    season = str(rng.choice(["bare", "green", "dry"], p=seasons))
    tint = rng.normal(1, 0.04, 3) * rng.uniform(0.85, 1.25)
    palette = {
        name: tuple(
            np.clip(np.array(c) * tint * rng.normal(1, 0.1) * rng.normal(1, 0.04, 3), 0.03, 1)
        )
        for name, c in _PALETTES[season].items()
    }
    wild = plan in ("rural", "curve", "bend", "motorway")
    dark = rng.random() < 0.3
    dense = bool(rng.random() < _DENSE.get(plan, 0.0))
    return Setting(
        frame=frame,
        palette=palette,
        sun=rng.uniform(0, 2 * np.pi),
        slant=rng.uniform(0.3, 1.1),
        dusk=rng.uniform(0.35, 0.75),
        woods=rng.normal(0.3 if wild else -0.9 if dense else -0.1, 0.7),
        leafless=season == "bare",
        trees=rng.uniform(0, 8) if wild else rng.uniform(0, 40),
        overhang=rng.normal(-1.5, 1.5),
        homes=rng.uniform(0.02, 0.35) if wild else rng.uniform(0.8 if dense else 0.35, 0.98),
        city=float(rng.choice([0.0, 0.1, 0.5], p=[0.45, 0.35, 0.2]))
        if plan not in ("grid", "city")
        else rng.uniform(0, 0.8),
        asphalt=rng.uniform(0.18, 0.42) if dark else rng.uniform(0.42, 0.8),
        asphalt_spread=rng.uniform(0.01, 0.09),
        cars=rng.uniform(0, 1.5) if wild else rng.uniform(0, 3),
        dense=dense,
        footways=bool(not wild and rng.random() < (0.7 if dense else 0.35)),
    )
