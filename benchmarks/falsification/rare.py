"""Distinct failures where 8 numbers and 3 kinds of things are drawn, and about 0.4 % fail.

python -m benchmarks.falsification.rare [SEARCHER ...] [--seeds N] [--evaluations N]
"""

from .bent_road import HEAD, REQUIREMENTS, bent_road
from .comparison import compare

FAILS = f"""{HEAD}{bent_road(3)}{REQUIREMENTS}
param surface = choice(0.55, 0.6, 0.65, 0.7, 0.75)
param style = choice(4m/s^2, 4.5m/s^2, 5m/s^2)
agent ego is choice(car, van, truck, motorcycle) on bent at 5m..25m {{
  drive with stanley {{ speed: (50km/h)..(70km/h), lateral_acceleration: style }}
}}
world {{ friction: surface }}
"""
DISCRETE = ("ego/kind", "surface", "style")

if __name__ == "__main__":
    compare(FAILS, DISCRETE)
