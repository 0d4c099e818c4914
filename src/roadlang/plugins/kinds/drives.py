"""Kinds of drives: controllers of agents, simulators."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from .base import Kind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...geometry.arrays import Floats
    from ...ir.actuation import ActuationBatch
    from ...ir.control import Control, ControlBatch
    from ...ir.observation import Observation, ObservationBatch
    from ...ir.scenario_contents import ScenarioContents
    from ...ir.scene import Scene
    from ...ir.trace import Trace
    from .lanes import LaneKind
    from .sensing import Sensor


STANDING_GAP = 2.0
"""Meters between two vehicles that stand in a row: what drives traffic, who gives way to it and who
begins behind it leave as much."""
LANE_END_GAP = 8.0
"""Meters before the end of its lane at which a vehicle stops that finds no gap to leave it, so that
it can still pull out: who merges and who makes room agree on it."""


@dataclass(frozen=True)
class InitialSpeed:
    """The speed that a controller wants at the start of a drive, limited by the bends ahead."""

    speed: float | None
    """m/s; None: the speed limit, and 50 km/h where there is none"""
    lateral_acceleration: float = 3.0
    """m/s^2, in bends"""
    deceleration: float = 3.0
    """m/s^2, before bends"""
    stops_at_junctions: bool = False
    """on a route, whether it must be able to stop before the next junction, as agents that obey the
    right of way must"""
    limit_factor: float = 1.0
    """the wanted speed as a multiple of the speed limit, if `speed` is None"""


class Controller(Kind):
    """`drive with`: drives an agent. Every engine can drive one that implements `controls` or
    `control`; one that does not is driven by engines that know it by its name. One that implements
    `altered` changes what the others decide."""

    verb: ClassVar[str] = "drive"
    interval: ClassVar[float] = 0.0
    """time in seconds between decisions, if that is longer than the step of the simulator: other
    drivers need not react as fast as the car under test"""
    keeps_distance: ClassVar[bool] = False
    """whether an agent without `start_speed` starts slowly enough to keep its distance to what is
    ahead in its lane: the time gap of its option `headway`, else 1 s"""

    leaves_open: ClassVar[str] = ""
    """what it leaves to the controller before it, such as "steering": there is a warning if it is
    the first controller of an agent"""

    for_vehicles: ClassVar[bool] = False
    """whether it drives in a lane as vehicles do: there is a warning if its agent is a
    pedestrian"""

    is_elementwise: ClassVar[bool] = False
    """whether `controls` is elementwise: numpy's functions (`np.sin`, `np.minimum`, `np.where`) and
    operators on columns of the observations, without branches on their values (`if`) and without
    state. The embedded engine may then trace it once and repeat the computation in compiled code
    for many steps without calling it; the results are the same to the last bit"""

    lane_options: ClassVar[tuple[str, ...]] = ()
    """options that hold the id of a lane: one that the road does not have is an error (RL613)"""

    sensor_options: ClassVar[tuple[str, ...]] = ()
    """options that hold the name of a sensor of the agent: one that it does not have is an error
    (RL480)"""

    def takes_lane(self, kind: type[LaneKind], is_oncoming: bool) -> bool:
        """Whether `left` or `right` in one of `lane_options` can mean a lane of this kind, with
        traffic that comes toward the agent or not. By default any; if no lane on that side can be
        meant, `check` reports it (RL613)."""
        return True

    def control(self, observation: Observation) -> Control:
        """Decide what to do until the next step.

        Returns a `Control` of finite numbers; anything else is RL474. Without it, `controls` is
        called for a batch of one agent.
        """
        raise NotImplementedError

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        """Decide what N agents do until the next step. Options that are numbers are columns (N,)
        here.

        The decision for an agent must depend on its row alone. `state` has a row for each agent, as
        returned by `start`; the method changes it in place. Returns a `ControlBatch` of numbers,
        with NaN for what is left to the controllers before it. Anything else is RL474.
        """
        raise NotImplementedError

    def altered(self, wanted: ActuationBatch, state: Any) -> tuple[Floats, Floats]:
        """Steering and acceleration (N,) of N agents instead of those that their controllers
        decided: an actuator fault. A kind that implements this decides nothing else, and is called
        at every step, also where it is not `active`. Options and `state` are as in `controls`.
        """
        raise NotImplementedError

    def initial_speed(self) -> InitialSpeed | None:
        """The speed of an agent in a lane at the start of its drive, if this is its first
        controller, has no condition, and the scene file gives no `start_speed`. By default None:
        the agent stands."""
        return None

    def start(self, count: int) -> NDArray[Any] | None:
        """The state of `controls` for `count` agents at the start of a drive: an array (count, ...)
        that is kept from step to step. By default None."""
        return None


class Simulator(Kind):
    """`simulate with`: where scenes are driven."""

    verb: ClassVar[str] = "simulate"
    required_methods: ClassVar[tuple[str, ...]] = ("drive", "drive_all")
    at_once: ClassVar[int] = 64
    """The greatest number of scenes in a call of `drive_all`. Results are written when it returns,
    so use a small number if each drive takes long, a large one if they run in parallel."""

    knows_levels: ClassVar[bool] = False
    """Whether it keeps agents on a bridge apart from those below. Otherwise a map with roads that
    cross above others is a warning (RL444)."""

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        """The parts of a scenario that this simulator cannot drive; reported as for
        `Backend.unsupported`, at the `simulate with` of the scene file."""
        return ()

    def offers(self, sensor: type[Sensor]) -> bool:
        """Whether controllers get readings of sensors of this kind, given the options of this
        simulator. By default False for all; `check` reports a sensor that is not offered
        (RL257)."""
        return False

    def drive(self, scene: Scene, controllers: Mapping[str, Controller]) -> Trace:
        """Drive a scene.

        `controllers` holds the controllers in Python by agent, including the standard ones; all
        others are in `scene.agents[i].drive`. Returns a `Trace`; anything else is RL474. Raise
        `DiagnosticError` if the engine cannot be reached or cannot drive the scene. By default
        `drive_all` is called with one scene; a simulator implements one of the two.
        """
        (trace,) = self.drive_all([scene], [controllers])
        return trace

    def drive_all(
        self, scenes: Sequence[Scene], controllers: Sequence[Mapping[str, Controller]]
    ) -> Iterable[Trace]:
        """Drive several scenes: an engine that is slow to start is started once for all of them.

        Returns a `Trace` for each scene, in their order. By default `drive` is called for each.
        """
        for scene, of_scene in zip(scenes, controllers, strict=True):
            yield self.drive(scene, of_scene)
