"""Where lanes change their widths, agents follow the middles of their lanes in Godot as well."""

from __future__ import annotations

import numpy as np
import pytest

from roadlang import testing
from tests.godot.godot_engines import require_engine

TEXT = """
road wide { draw with segments { pieces: [straight(70m)] }, left: [drive(3.5m)],
  right: [drive(3.5m)] }
road narrow { draw with segments { pieces: [straight(50m), arc(80m, 30deg), straight(40m)] },
  left: [drive(2.75m)], right: [drive(2.75m)] }
road street from wide { then: narrow, taper: 30m }
agent follows is car on street at 20m { drive with lane_follow { speed: 40km/h } }
agent pursues is car on street at 45m { drive with pure_pursuit { speed: 40km/h } }
agent steers is car on street at 70m { drive with stanley { speed: 40km/h } }
agent back is car on street at 180m { facing: back, drive with lane_follow { speed: 40km/h } }
"""


@pytest.mark.godot
def test_agents_stay_in_the_middle_of_lanes_that_narrow() -> None:
    require_engine()
    (drive,) = testing.sample(TEXT, 1).run("godot", duration=12.0)
    for name, agent in drive.trace.agents.items():
        straight = (agent.station < 110.0) & (agent.station > 10.0)
        assert np.abs(agent.lane_offset[straight]).max() < 0.08, name
        assert np.abs(agent.lane_offset).max() < 0.3, name
        assert np.abs(agent.cross_track_error - agent.lane_offset).max() < 0.1, name
        assert agent.off_road.max() < 0.0, name
