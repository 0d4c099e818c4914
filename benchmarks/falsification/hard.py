"""Distinct failures of a lane keeper where 0.03 to 0.05 % of the roads drawn at random fail.

python -m benchmarks.falsification.hard [SEARCHER ...] [--seeds N] [--evaluations N]
"""

from .bent_road import lane_keeper
from .comparison import compare

FRICTION = 0.619

if __name__ == "__main__":
    compare(lane_keeper(FRICTION))
