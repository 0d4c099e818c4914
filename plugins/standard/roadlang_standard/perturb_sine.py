"""`perturb with sine`: the perturbation of the paper."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Angle, Length, Perturber, option

if TYPE_CHECKING:
    from roadlang.api import BatchRandom, RoadBatch
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Sine(Perturber):
    """Displace the road by a sine wave along its arc length."""

    name: ClassVar[str] = "sine"
    also_called: ClassVar[tuple[str, ...]] = ("sinusoid", "sinusoidal", "sin", "wave")
    is_random: ClassVar[bool] = False
    amplitude: Length = option(help="greatest displacement")
    wavelength: Length = option(
        above=0, help="arc length of one period; a closed road has a whole number"
    )
    phase: Angle = option(0.0, help="phase of the wave at the start of the road")

    def displacements(self, roads: RoadBatch, random: BatchRandom) -> Floats:
        """amplitude * sin(2 pi s / wavelength + phase)."""
        import numpy as np

        from roadlang.geometry import blocks

        wavelength = self.wavelength
        if roads.period is not None:
            wavelength = roads.period / np.maximum(np.rint(roads.period / wavelength), 1.0)
        rate, phase = np.broadcast_arrays(
            *(np.atleast_2d(column) for column in (2.0 * np.pi / wavelength, self.phase))
        )
        wave = np.empty((len(rate), len(roads.stations)))
        for rows in blocks(wave):
            np.multiply(rate[rows], roads.stations, out=wave[rows])
            wave[rows] += phase[rows]
            np.sin(wave[rows], out=wave[rows])
        amplitude = np.atleast_2d(self.amplitude)
        if len(wave) < len(amplitude):  # roads that differ in their amplitudes alone have one wave
            return np.asarray(wave * amplitude)
        wave *= amplitude
        return wave

    def displacement_bound(self) -> Floats | float:
        return abs(self.amplitude)

    def displacement_reached(self, length: float, closed: bool, gap: float) -> float:
        """The amplitude within half a wavelength, less what lies between two stations."""
        import math

        wavelength = self.wavelength
        if closed:
            wavelength = length / max(round(length / wavelength), 1)
        elif 2.0 * length < wavelength:
            return 0.0
        return float(abs(self.amplitude) * math.cos(min(math.pi * gap / wavelength, math.pi / 2)))

    def shortest_feature(self, length: float, closed: bool) -> Floats | float:
        """One period."""
        return self.wavelength
