"""What agents are: size, mass, grip and power, as columns of numbers over many agents."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np

from ...geometry.arrays import Booleans, Floats, Integers
from ...ir.scene import SceneActor
from ..lanes.surfaces import TireSurface
from .vehicle_dynamics import FRONT_STIFFNESS, GRAVITY, REAR_STIFFNESS, SLOW

AIR = 1.2
"""density, kg/m^3"""
WALKER_BASE = 0.5
"""Meters: wheelbase of who is on foot."""


@dataclass(frozen=True)
class Body:
    """Properties of a kind of agent that its options do not state. SI units and radians."""

    drag_area: float = 0.67
    """drag coefficient times frontal area, m^2"""
    power: float = 66.0
    """of the engine, W for each kilogram of the agent"""
    rolling: float = 0.012
    """rolling resistance for each newton of weight"""
    mass_height: float = 0.28
    """height of the center of mass, share of the height of the agent; 0 on two wheels, whose
    riders balance: load transfer would take grip from the rear wheel, so that they spin when they
    brake in a bend"""
    steering_lag: float = 0.1
    """time constant of the steering, seconds"""
    steering_rate: float = 1.2
    """rad/s of the front wheels, at most"""
    walks: bool = False
    """whether it walks: it moves in the direction of its heading, without tires"""


@dataclass(frozen=True)
class Bodies:
    """Columns (N,) over agents. A `tangent` is that of a steering angle."""

    length: Floats
    width: Floats
    wheelbase: Floats
    max_steering: Floats
    half_base: Floats
    friction: Floats
    front_slope: Floats
    """share of the slip at which the front axle slides, for each unit of slip"""
    rear_slope: Floats
    slow: Floats
    lag: Floats
    """share of a steering difference that one step closes"""
    rate: Floats
    """radians of steering for each step, at most"""
    power: Floats
    """W/kg"""
    grip: Floats
    """friction times gravity, m/s^2"""
    transfer: Floats
    """height of the center of mass over the wheelbase"""
    inertia: Floats
    """square of the radius of gyration, m^2"""
    drag: Floats
    """1/m: acceleration for each squared m/s"""
    rolling: Floats
    """m/s^2"""
    walks: Booleans

    @classmethod
    def of(
        cls,
        actors: Sequence[SceneActor],
        surfaces: Sequence[TireSurface],
        kinds: Mapping[str, Body],
        dt: float,
    ) -> Bodies:
        """`surfaces`: of the road below each; `kinds`: by the name of the kind."""
        known: dict[Any, tuple[float, ...]] = {}
        rows = []
        for actor, surface in zip(actors, surfaces, strict=True):
            # Scenes of one file share the options of agents that have the same.
            size = actor.length, actor.width, actor.height
            key = actor.kind, actor.category, id(actor.options), *size, surface
            if key not in known:
                known[key] = _row(actor, body_of(actor, kinds), surface, dt)
            rows.append(known[key])
        columns = np.ascontiguousarray(np.array(rows, dtype=np.float64).reshape(len(rows), -1).T)
        names = [field.name for field in fields(cls)]
        values: dict[str, Any] = dict(zip(names, columns, strict=True))
        values["walks"] = values["walks"] > 0.5
        return cls(**values)

    @cached_property
    def columns(self) -> tuple[Floats, ...]:
        """What `vehicle.driven` has to know of a car."""
        return tuple(getattr(self, name) for name in _STACKED[:-2])

    @cached_property
    def least_steering(self) -> Floats:
        """(N,) radians: as far to the right as to the left."""
        return -self.max_steering

    @cached_property
    def stacked(self) -> Floats:
        """(13, N) what the compiled motion has to know of a car."""
        return np.stack(self.in_order)

    def on_ground(self, rows: Integers, friction: Floats, rolling: Floats) -> Bodies:
        """The bodies, of which those of agents `rows` (R,) have this friction (R,) and this rolling
        resistance (R,), m/s^2."""
        stacked = self.stacked.copy()
        found = self._with({}, stacked)
        for name, values in self._ground(rows, friction, rolling).items():
            column = found.__dict__[name] = stacked[_STACKED.index(name)]
            column[rows] = values
        return found

    def where(self, rows: Booleans, friction: Floats, rolling: Floats) -> Bodies:
        """The same of traced columns: `rows`, friction and rolling resistance (N,) of all."""
        changed = self._ground(slice(None), friction, rolling)
        columns = {name: np.where(rows, new, getattr(self, name)) for name, new in changed.items()}
        return self._with(columns, None)

    @property
    def in_order(self) -> list[Floats]:
        """The columns of `stacked`, one by one."""
        return [getattr(self, name) for name in _STACKED]

    def _ground(self, rows: Any, friction: Floats, rolling: Floats) -> dict[str, Floats]:
        """The columns (R,) of agents on ground with this friction and this rolling resistance."""
        before = self.friction[rows]
        return {
            "friction": friction,
            "front_slope": self.front_slope[rows] * before / friction,
            "rear_slope": self.rear_slope[rows] * before / friction,
            "grip": friction * GRAVITY,
            "rolling": rolling,
        }

    def _with(self, columns: Mapping[str, Floats], stacked: Floats | None) -> Bodies:
        found = object.__new__(Bodies)  # `replace` takes longer, and drives do this at every step
        found.__dict__.update(self.__dict__, stacked=stacked, **columns)
        found.__dict__.pop("columns", None)
        return found

    def take(self, rows: Any) -> Bodies:
        """Those of some agents."""
        return Bodies(**{field.name: getattr(self, field.name)[rows] for field in fields(self)})


_STACKED = (
    "half_base", "friction", "front_slope", "rear_slope", "slow", "power", "grip", "transfer",
    "inertia", "drag", "rolling", "lag", "rate",
)  # fmt: skip
"""The columns of `stacked`; all but the last two are those of `columns`."""


def body_of(actor: SceneActor, kinds: Mapping[str, Body]) -> Body:
    """What is known of the kind of an agent, by its name; else of its category."""
    return kinds.get(actor.kind) or kinds.get(actor.category) or Body()


@dataclass(frozen=True)
class VehicleParameters:
    """Numbers of one agent that equations of motion need, in any engine. SI units and radians."""

    mass: float
    wheelbase: float
    max_steering: float
    mass_height: float
    """of the center of mass above the ground"""
    drag: float
    """1/m: acceleration for each squared m/s"""
    rolling: float
    """m/s^2"""
    power: float
    """W/kg"""
    front_stiffness: float
    """cornering stiffness for each newton of load, 1/rad"""
    rear_stiffness: float
    steering_lag: float
    steering_rate: float


def vehicle_parameters(actor: SceneActor, body: Body | None = None) -> VehicleParameters:
    """Those of an agent, whose kind is this: what its options say, else usual numbers."""
    options, body = actor.options, body or Body()
    default_wheelbase = WALKER_BASE if body.walks else 0.6 * actor.length
    mass = max(1e-3, _number(options.get("mass"), 1500.0))
    return VehicleParameters(
        mass=mass,
        wheelbase=max(0.05, _number(options.get("wheelbase"), default_wheelbase)),
        max_steering=min(1.5, _number(options.get("max_steering"), 0.61)),
        mass_height=body.mass_height * actor.height,
        drag=0.5 * AIR * body.drag_area / mass,
        rolling=body.rolling * GRAVITY,
        power=body.power,
        front_stiffness=FRONT_STIFFNESS,
        rear_stiffness=REAR_STIFFNESS,
        steering_lag=body.steering_lag,
        steering_rate=body.steering_rate,
    )


def _row(actor: SceneActor, body: Body, surface: TireSurface, dt: float) -> tuple[float, ...]:
    car = vehicle_parameters(actor, body)
    return (
        actor.length,
        actor.width,
        car.wheelbase,
        car.max_steering,
        0.5 * car.wheelbase,
        surface.friction,
        car.front_stiffness / (3.0 * surface.friction),
        car.rear_stiffness / (3.0 * surface.friction),
        SLOW * dt,
        1.0 if body.walks else dt / (car.steering_lag + dt),
        (1e3 if body.walks else car.steering_rate) * dt,
        car.power,
        surface.friction * GRAVITY,
        car.mass_height / car.wheelbase,
        (actor.length * actor.length + actor.width * actor.width) / 12.0,
        car.drag,
        car.rolling + surface.rolling * GRAVITY,
        float(body.walks),
    )


def _number(value: Any, default: float) -> float:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return float(value) if is_number else default
