"""Buildings beside the roads: houses with drives, blocks; planned, then painted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from training.rendering.frame import Floats, Image, Layer, PlannedRoad, ribbon
from training.rendering.layouts.curves import spline
from training.rendering.noise import blend
from training.rendering.parking_lots import Lot
from training.rendering.pavement import car, quad
from training.rendering.setting import Setting

_LARGE = (np.array([9.0, 8.0]), np.array([32.0, 22.0]))


@dataclass(frozen=True, slots=True)
class Building:
    """A footprint in meters: center, half sides, heading, height; where its drive meets a road."""

    center: Floats
    half: Floats
    heading: float
    height: float
    door: Floats
    large: bool = False


@dataclass(frozen=True, slots=True)
class Habit:
    """How a town builds, in meters: distance of neighbors, setback, sizes of houses and lots."""

    pitch: float
    setback: float
    stray: float
    clearance: float
    house: tuple[Floats, Floats]
    lot: tuple[Floats, Floats]


def _habit(rng: np.random.Generator, setting: Setting) -> Habit:
    if setting.dense:
        house = np.array([3.2, 4.5]), np.array([5.5, 9.0])
        lot = np.array([10.0, 9.0]), np.array([55.0, 35.0])
        return Habit(rng.uniform(9, 15), rng.uniform(1.5, 7), 0.6, 0.8, house, lot)
    house = np.array([4.5, 3.5]), np.array([9.0, 6.5])
    setback = rng.uniform(3, 12) if rng.random() < 0.65 else rng.uniform(10, 45)
    lot = np.array([9.0, 8.0]), np.array([42.0, 30.0])
    return Habit(rng.uniform(14, 28), setback, 3.0, 2.5, house, lot)


def settle(
    rng: np.random.Generator, setting: Setting, plan: list[PlannedRoad], near: Layer, water: Layer
) -> tuple[list[Building], list[Lot]]:
    """Choose places for buildings and lots along the streets, clear of roads and each other."""
    taken = np.zeros((*setting.frame.shape, 3), np.uint8)
    taken[..., 0] = np.where((near < 0.8) | (water > 0), 255, 0)
    buildings: list[Building] = []
    lots: list[Lot] = []
    habit = _habit(rng, setting)
    for road in plan:
        if road.manner != "street":
            continue
        for side in (-1, 1):
            station = rng.uniform(0, habit.pitch)
            while station < 2 * len(road.points) - 6:
                large = rng.random() < setting.city * 0.5
                park = large and rng.random() < 0.4
                sizes = habit.lot if park else _LARGE if large else habit.house
                half = rng.uniform(*sizes)
                index = int(station / 2)
                station += max(habit.pitch, 2 * half[0] + habit.clearance) * rng.uniform(0.95, 1.25)
                if rng.random() > setting.homes:
                    continue
                back = habit.setback * rng.uniform(0.7, 1.3) + rng.exponential(habit.stray)
                place = _place(rng, road, index, side, half, back)
                if not _free(setting, place, habit.clearance, taken):
                    continue
                if park:
                    lots.append(Lot(place.center, place.half, place.heading, place.door))
                else:
                    buildings.append(place)
                    _behind(rng, setting, place, taken, buildings)
    return buildings, lots


def _behind(
    rng: np.random.Generator, setting: Setting, front: Building, taken: Image, to: list[Building]
) -> None:
    """In dense towns, garages and more houses in the yard."""
    if not setting.dense:
        return
    inward = front.center - front.door
    inward = inward / max(1e-9, float(np.hypot(*inward)))
    depth = float(front.half[1])
    for _ in range(3):
        half = rng.uniform([2, 2], [5.5, 6])
        depth += half[1] + rng.uniform(1.5, 10)
        center = front.center + inward * depth + rng.normal(0, 1.5, 2)
        yard = Building(center, half, front.heading, rng.uniform(2.5, 7), center, False)
        if rng.random() < 0.65 and _free(setting, yard, 0.5, taken):
            to.append(yard)
        depth += half[1]


def _place(
    rng: np.random.Generator, road: PlannedRoad, index: int, side: int, half: Floats, setback: float
) -> Building:
    index = int(np.clip(index, 1, len(road.points) - 2))
    ahead = road.points[index + 1] - road.points[index - 1]
    ahead = ahead / max(1e-9, float(np.hypot(*ahead)))
    across = side * np.array([-ahead[1], ahead[0]])
    door = road.points[index] + across * road.width / 2
    center = door + across * (setback + half[1])
    heading = float(np.arctan2(ahead[1], ahead[0])) + rng.normal(
        0, 0.08 if rng.random() < 0.8 else 0.6
    )
    large = half[0] > 9
    height = rng.uniform(5, 25) if large else rng.uniform(3.5, 8)
    return Building(
        center, half, heading, height, door + ahead * half[0] * rng.uniform(-0.8, 0.8), large
    )


def _free(setting: Setting, it: Building, clearance: float, taken: Image) -> bool:
    """Whether the footprint lies clear of all that is taken; if so it is taken too."""
    frame = setting.frame
    reach = frame.length(float(np.hypot(*(it.half + clearance)))) + 2
    x, y = frame.pixels(it.center)
    if not (0 <= x < frame.size and 0 <= y < frame.size):
        return False
    low = np.maximum(0, np.floor((x - reach, y - reach)).astype(int))
    high = np.ceil((x + reach, y + reach)).astype(int) + 1
    window = (slice(low[1], high[1]), slice(low[0], high[0]))
    spot = np.zeros_like(taken[window])
    local = it.center - low * frame.meters_per_pixel
    quad(setting, spot, local, it.half + clearance, it.heading, np.ones(3))
    if (taken[window][spot[..., 0] > 127, 0] > 0).any():
        return False
    quad(setting, taken, it.center, it.half + 0.5 * clearance, it.heading, np.array([1.0, 0, 0]))
    return True


def lay_drives(
    rng: np.random.Generator,
    setting: Setting,
    image: Layer,
    buildings: list[Building],
) -> None:
    """Paint drives and service lanes, in place."""
    for house in buildings:
        if (house.door != house.center).any() and rng.random() < 0.75:
            _drive(rng, setting, image, house)
        if house.large and rng.random() < 0.4:
            _way_round(rng, setting, image, house)


def _drive(rng: np.random.Generator, setting: Setting, image: Layer, house: Building) -> None:
    """From the road to the house, straight or winding, sometimes with a yard at its end."""
    end = house.center + rng.normal(0, 2, 2)
    away = float(np.hypot(*(end - house.door)))
    bends = house.door + np.outer((0.35, 0.7), end - house.door)
    bends = bends + rng.normal(0, 0.02 + 0.07 * away, (2, 2))
    points = spline(np.vstack([house.door, bends, end]))
    _lane(rng, setting, image, points, rng.uniform(2.2, 4.4))
    if rng.random() < 0.3:
        yard = points[-max(2, int(rng.uniform(3, 7))) :]
        _lane(rng, setting, image, yard, rng.uniform(5, 10))


def _way_round(rng: np.random.Generator, setting: Setting, image: Layer, house: Building) -> None:
    """A service lane about a large building."""
    turns = np.linspace(0, 2 * np.pi, 9)[:-1]
    around = np.c_[np.cos(turns), np.sin(turns)] * (house.half + rng.uniform(5, 12)) * 1.2
    cosine, sine = np.cos(house.heading), np.sin(house.heading)
    ring = house.center + around @ np.array([[cosine, sine], [-sine, cosine]])
    _lane(rng, setting, image, spline(ring, closed=True), rng.uniform(3.5, 6))


def _lane(
    rng: np.random.Generator, setting: Setting, image: Layer, points: Floats, width: float
) -> None:
    """A strip of private asphalt or gravel: no road."""
    frame = setting.frame
    tone = np.clip(setting.asphalt * rng.uniform(0.55, 1.25), 0.12, 0.85)
    color = tone * rng.normal(1, 0.03, 3)
    if rng.random() < 0.15:
        color = np.array(setting.palette["soil"]) * rng.uniform(0.8, 1.2)
    window, alpha = ribbon(frame.pixels(points), frame.length(width), frame.shape)
    blend(image[window], tuple(np.clip(color, 0, 1)), alpha * rng.uniform(0.55, 1))


def build(
    rng: np.random.Generator,
    setting: Setting,
    image: Image,
    buildings: list[Building],
) -> None:
    """Paint roofs, pools and parked cars, in place."""
    for house in buildings:
        _roof(rng, setting, image, house)
        if not house.large and rng.random() < 0.08:
            behind = house.center + (house.center - house.door) * rng.uniform(0.5, 1)
            quad(
                setting,
                image,
                behind,
                rng.uniform([2, 1.5], [5, 3]),
                house.heading,
                np.array([0.85, 0.75, 0.4]),
            )
        if rng.random() < 0.3:
            beside = (house.center + house.door) / 2 + rng.normal(0, 1.5, 2)
            car(rng, setting, image, beside, house.heading + np.pi / 2)
        if rng.random() < 0.2:
            shed = house.center + rng.normal(0, 10, 2)
            quad(
                setting,
                image,
                shed,
                rng.uniform(1, 2.5, 2),
                house.heading,
                rng.uniform(0.15, 0.9, 3) * 0.6,
            )


def _roof(rng: np.random.Generator, setting: Setting, image: Image, house: Building) -> None:
    kind = rng.random()
    if kind < 0.5:
        color = np.full(3, rng.uniform(0.2, 0.5)) * rng.normal(1, 0.05, 3)
    elif kind < 0.8:
        color = np.full(3, rng.uniform(0.6, 0.95)) * rng.normal(1, 0.03, 3)
    else:
        color = np.array([0.34, 0.42, 0.5]) * rng.uniform(0.6, 1.6)
    quad(setting, image, house.center, house.half, house.heading, color)
    across = np.array([-np.sin(house.heading), np.cos(house.heading)])
    if house.large:
        if rng.random() < 0.5:
            rim = np.clip(color * rng.uniform(0.6, 1.5), 0, 1)
            quad(setting, image, house.center, house.half, house.heading, rim)
            quad(setting, image, house.center, house.half - 0.6, house.heading, color)
        for _ in range(int(rng.integers(0, 6))):
            at = house.center + rng.uniform(-0.7, 0.7, 2) * house.half.min()
            quad(
                setting,
                image,
                at,
                rng.uniform(0.8, 2.5, 2),
                house.heading,
                color * rng.uniform(0.5, 1.4),
            )
        return
    lit = float(across @ [np.cos(setting.sun), np.sin(setting.sun)])
    half = house.half * (1.0, 0.5)
    for sign in (-1, 1):
        tone = color * (1 - 0.45 * sign * lit * rng.uniform(0.4, 1))
        quad(setting, image, house.center + sign * across * half[1], half, house.heading, tone)
    if rng.random() < 0.5:
        wing = house.center + rng.choice([-1, 1]) * across * house.half[1] + rng.normal(0, 2, 2)
        quad(
            setting,
            image,
            wing,
            house.half * (0.5, 0.6),
            house.heading,
            color * rng.uniform(0.7, 1.3),
        )


def footprints(setting: Setting, buildings: list[Building], tall: bool) -> Image:
    """Mask of the large or the small buildings, for their shadows."""
    mask = np.zeros((*setting.frame.shape, 3), np.uint8)
    for house in buildings:
        if house.large == tall:
            quad(setting, mask, house.center, house.half, house.heading, np.ones(3))
    return mask[..., 0]
