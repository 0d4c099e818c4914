"""Kinds that write scenes (`emit`), and the kinds of agents and objects in them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, ClassVar

from .base import Kind

if TYPE_CHECKING:
    from ...ir.scenario_contents import ScenarioContents
    from ...ir.scene import Scene
    from ...ir.trace import Trace


class Backend(Kind):
    """`emit`: writes scenes to files, or sends them to a simulator."""

    verb: ClassVar[str] = "emit"
    required_methods: ClassVar[tuple[str, ...]] = ("files", "collection", "drive_files", "send")

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        """The parts of a scenario that this backend cannot express, given its options.

        Returns a reason for each such part, such as "it has pedestrians"; `check` reports them at
        the `emit` (RL243).
        """
        return ()

    def files(self, scene: Scene) -> Mapping[str, bytes | str]:
        """The files of one scene.

        Returns contents by file ending: `{"json": "..."}` becomes `scene-0000.json`. Text is
        written as UTF-8. Endings are letters, digits, `_`, `-` and `.`; anything else is RL474.
        A file that names another one of the same scene adds the ending to `scene.stem`.
        """
        return {}

    def drive_files(self, scene: Scene, trace: Trace) -> Mapping[str, bytes | str]:
        """The files of one drive, which `roadlang run` writes beside the trace.

        `trace` holds what moves, as the files of the trace do; objects are in the scene. Returns
        contents by file ending, as `files` does: `{"drive.xosc": "..."}` becomes
        `scene-0000.drive.xosc`. Endings that `roadlang run` uses (`json`, `trace.csv`, ...) are
        RL474.
        """
        return {}

    def collection(self, scenes: Iterable[Scene]) -> Mapping[str, bytes | str]:
        """The files that are written once for all scenes.

        Returns contents by file name, as `files` does by ending; `manifest.json` is roadlang's.
        """
        return {}

    def send(self, scene: Scene) -> None:
        """Send to an engine, after all files are written. Raise `DiagnosticError` if it cannot be
        reached."""


class AgentKind(Kind):
    """A kind of agent: what may follow `agent N is`.

    Its fields are its size and appearance: `length`, `width` and `height` in meters, by which it is
    placed and drawn, and others that simulators may use.
    """

    verb: ClassVar[str] = "agent"
    category: ClassVar[str] = ""
    """how outputs and engines show it: `car`, `van`, `truck`, `bus`, `tractor`, `motorcycle`,
    `bicycle`, `pedestrian` or `animal`. Empty: the vehicle whose usual size it has"""
    role: ClassVar[str] = ""
    """for vehicles with a role: `taxi`, `police`, `ambulance` or `fire`"""


class ObjectKind(Kind):
    """What may follow `object N is`, and stand in a legend. Fields are those of `AgentKind`."""

    verb: ClassVar[str] = "object"
    category: ClassVar[str] = "obstacle"
    """how outputs and engines show it: `tree`, `bush`, `hedge`, `building`, `shelter`, `wall`,
    `fence`, `guardrail`, `barrier`, `cone`, `pole`, `lamp`, `sign`, `traffic_light`, `water`,
    `obstacle`, `crosswalk` (paint on the road), or, of a parked vehicle, that of the vehicle or
    `trailer`"""
