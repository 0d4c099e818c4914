"""The lane keeper on a road that bends in many ways, of the problems `medium` and `hard`.

A road of 359 m is displaced by six harmonics, a sine and a cosine of each: 12 draws. About a third
of the roads satisfy the requirements. How many of these fail is a matter of the friction.
"""

from __future__ import annotations

LENGTH, AMPLITUDE = 360.0, 5.6
HEAD = """
road main {
  draw with waypoints { points: [(0m, 0m), (80m, 0m), (160m, 40m), (240m, 40m), (340m, 0m)] }
  width: 8m
}
"""
REQUIREMENTS = """
require near: always (abs(deviation(bent, main)) < 10m)
require inside: always (margin(bent, (-5m, -40m), (345m, 80m)) > 0m)
require radius: always (abs(curvature(bent)) < 1 / 14.4m)
expect in_lane: always (abs(ego.cross_track_error) < 2m)
"""


def lane_keeper(friction: float) -> str:
    """The scene file of `medium` and `hard`."""
    return f"""{HEAD}{bent_road(6)}{REQUIREMENTS}
agent ego is car on bent at 5m {{ drive with stanley {{ speed: 70km/h }} }}
world {{ friction: {friction} }}
"""


def bent_road(harmonics: int) -> str:
    """The road `bent`; harmonic k has a bound of the amplitude by the root of k."""
    waves = "".join(
        f"  perturb with sine {{ amplitude: {-AMPLITUDE / k**0.5:.4f}m..{AMPLITUDE / k**0.5:.4f}m,"
        f" wavelength: {LENGTH / k:.4f}m, phase: {phase}deg, over: [20m, 358m], taper: 30m }}\n"
        for k in range(1, harmonics + 1)
        for phase in (0, 90)
    )
    return f"road bent from main {{\n{waves}}}\n"
