"""Distinct failures of a lane keeper where 1.0 to 1.2 % of the roads drawn at random fail.

python -m benchmarks.falsification.medium [SEARCHER ...] [--seeds N] [--evaluations N]
"""

from .bent_road import lane_keeper
from .comparison import compare

FRICTION = 0.579

if __name__ == "__main__":
    compare(lane_keeper(FRICTION))
