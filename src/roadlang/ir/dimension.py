"""Dimensions of quantities: exponents of length, pixel, time, angle and mass."""

from __future__ import annotations

from dataclasses import dataclass, fields

_SYMBOLS = {"length": "m", "pixel": "px", "time": "s", "angle": "rad", "mass": "kg"}
_NAMES: dict[tuple[float, ...], str] = {
    (0, 0, 0, 0, 0): "a dimensionless number",
    (1, 0, 0, 0, 0): "a length",
    (2, 0, 0, 0, 0): "an area",
    (0, 1, 0, 0, 0): "a length in pixels",
    (0, 0, 1, 0, 0): "a time",
    (0, 0, 0, 1, 0): "an angle",
    (0, 0, 0, 0, 1): "a mass",
    (1, 0, -1, 0, 0): "a speed",
    (1, 0, -2, 0, 0): "an acceleration",
    (1, 0, -3, 0, 0): "a jerk",
    (-1, 0, 0, 0, 0): "a curvature",
    (1, -1, 0, 0, 0): "a scale",
    (0, 0, -1, 0, 0): "a frequency",
    (0, 0, -1, 1, 0): "an angular velocity",
    (1, 0, -2, 0, 1): "a force",
}


@dataclass(frozen=True, slots=True)
class Dimension:
    """Multiplied, divided and raised to powers like the quantities that have it."""

    length: float = 0
    pixel: float = 0
    time: float = 0
    angle: float = 0
    mass: float = 0

    @property
    def exponents(self) -> tuple[float, float, float, float, float]:
        """Exponents of length, pixel, time, angle and mass."""
        return (self.length, self.pixel, self.time, self.angle, self.mass)

    @property
    def is_pure(self) -> bool:
        """Whether this is the dimension of a plain number."""
        return not any(self.exponents)

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(*(a + b for a, b in zip(self.exponents, other.exponents, strict=True)))

    def __truediv__(self, other: Dimension) -> Dimension:
        return Dimension(*(a - b for a, b in zip(self.exponents, other.exponents, strict=True)))

    def __pow__(self, exponent: float) -> Dimension:
        return Dimension(*(a * exponent for a in self.exponents))

    @property
    def unit(self) -> str:
        """The SI unit as the language writes it: `m/s^2`, `1/m`; empty if dimensionless."""
        above: list[str] = []
        below: list[str] = []
        for part in fields(self):
            exponent = getattr(self, part.name)
            if exponent:
                power = "" if abs(exponent) == 1 else f"^{abs(exponent):g}"
                (above if exponent > 0 else below).append(_SYMBOLS[part.name] + power)
        if not above and not below:
            return ""
        return "*".join(above or ["1"]) + ("/" + "*".join(below) if below else "")

    def __str__(self) -> str:
        """In words: `a length`, `a speed`; other dimensions by their unit."""
        return _NAMES.get(self.exponents) or f"a quantity in {self.unit}"


PURE = Dimension()
LENGTH = Dimension(length=1)
AREA = Dimension(length=2)
PIXELS = Dimension(pixel=1)
TIME = Dimension(time=1)
ANGLE = Dimension(angle=1)
MASS = Dimension(mass=1)
SPEED = LENGTH / TIME
ACCELERATION = SPEED / TIME
JERK = ACCELERATION / TIME
CURVATURE = PURE / LENGTH
SCALE = LENGTH / PIXELS
FREQUENCY = PURE / TIME
FORCE = MASS * ACCELERATION
