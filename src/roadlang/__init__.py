"""roadlang: a plugin-based compiler for driving scenarios.

    import roadlang

    scenes = roadlang.load("hairpin.rl").sample(3, seed=7)
    scenes[0].roads["bent"].curvature
    scenes.emit("out")

All names are imported when they are first used: `import roadlang` alone imports no numpy.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .version import __version__

if TYPE_CHECKING:
    from .diagnostics import Diagnostic, DiagnosticError
    from .session.drives import Drive, DriveSet
    from .session.falsification import Failure, Falsification
    from .session.loading import LoadedScenario, load, loads
    from .session.profiles import Profiles, RoadProfile
    from .session.reports import write_report
    from .session.scene import RoadArrays, Scene
    from .session.scene_set import NoSceneError, SceneSet
    from .session.trace_reading import read_drive

_MODULES = {
    ".diagnostics": "Diagnostic DiagnosticError",
    ".session.drives": "Drive DriveSet",
    ".session.falsification": "Failure Falsification",
    ".session.loading": "LoadedScenario load loads",
    ".session.profiles": "Profiles RoadProfile",
    ".session.reports": "write_report",
    ".session.scene": "RoadArrays Scene",
    ".session.scene_set": "NoSceneError SceneSet",
    ".session.trace_reading": "read_drive",
}
_HOME = {name: module for module, names in _MODULES.items() for name in names.split()}

__all__ = [
    "Diagnostic",
    "DiagnosticError",
    "Drive",
    "DriveSet",
    "Failure",
    "Falsification",
    "LoadedScenario",
    "NoSceneError",
    "Profiles",
    "RoadArrays",
    "RoadProfile",
    "Scene",
    "SceneSet",
    "__version__",
    "load",
    "loads",
    "read_drive",
    "write_report",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOME[name], __package__), name)


def __dir__() -> list[str]:
    return __all__
