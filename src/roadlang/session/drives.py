"""Drives of scenes: traces as columns, and how the expectations came out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, overload

from ..drive.simulators import Driven, drive_scenes
from ..drive.trace_files import COLUMNS, to_csv, to_json
from .expectations import Expectation, expectations_of
from .scene import Scene
from .tables import columns_of

if TYPE_CHECKING:
    import pandas

    from ..diagnostics import Diagnostic, Span
    from ..geometry.arrays import Floats
    from ..ir.scene import Verdict
    from ..ir.trace import Trace
    from ..plugins.registry import Registry


def drive(
    scenes: Sequence[Scene],
    registry: Registry,
    engine: str | None,
    options: Mapping[str, Any],
    places: Mapping[str, Span | None] | None = None,
) -> DriveSet:
    """Drive scenes, all with one engine. `places`: where each expectation is declared."""
    records = [scene.record for scene in scenes]
    driven = drive_scenes(records, registry, engine, options) if records else ()
    return DriveSet(
        Drive(scene, found, places or {}) for scene, found in zip(scenes, driven, strict=True)
    )


class Drive:
    """One scene, driven. `trace` is what was recorded; SI units and radians."""

    def __init__(self, scene: Scene, driven: Driven, places: Mapping[str, Span | None]) -> None:
        self.scene = scene
        self.trace: Trace = driven.trace
        self._verdicts = driven.judgement.verdicts
        self._faults = driven.judgement.faults
        self._places = places

    def __repr__(self) -> str:
        return f"<drive of scene {self.scene.index} in {self.engine}: {self.duration:.6g} s>"

    @property
    def engine(self) -> str:
        """Who drove, as it calls itself."""
        return self.trace.engine

    @property
    def duration(self) -> float:
        """Seconds that were driven."""
        return float(self.trace.time[-1]) if len(self.trace.time) else 0.0

    @cached_property
    def verdicts(self) -> Mapping[str, Verdict]:
        """Each `expect` by name, with its robustness, satisfied or not."""
        return MappingProxyType({verdict.name: verdict for verdict in self._verdicts})

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Why expectations could not be evaluated on this drive; each names its expectation."""
        return tuple(
            replace(
                fault,
                span=fault.span or self._places.get(name),
                help=(*fault.help, f"this is the expectation `{name}` in scene {self.scene.index}"),
            )
            for name, faults in self._faults.items()
            for fault in faults
        )

    @property
    def satisfied(self) -> bool:
        """Whether all expectations hold."""
        return all(verdict.satisfied for verdict in self._verdicts)

    def to_dict(self) -> dict[str, Floats]:
        """Columns for `pandas.DataFrame`: `time`, and `ego.x`, `ego.speed`, ... of each agent.

        Formulas of `roadlang.stl` can name them: `always (ego.speed < 15)`. What the engine does
        not record is NaN.
        """
        columns = {"time": self.trace.time}
        for name, agent in self.trace.agents.items():
            columns |= {f"{name}.{column}": getattr(agent, column) for column in COLUMNS}
        return columns

    def to_frame(self) -> pandas.DataFrame:
        """`to_dict` as a data frame with the time as index. Raises `ImportError` without pandas."""
        import pandas

        return pandas.DataFrame(self.to_dict()).set_index("time")

    def to_csv(self) -> str:
        """The trace as `roadlang run` writes it: one row for each agent at each time."""
        return to_csv(self.trace)

    def to_json(self) -> str:
        """The trace with everything in it."""
        return to_json(self.trace)


class DriveSet(Sequence[Drive]):
    """The drives of several scenes, in their order."""

    def __init__(self, drives: Iterator[Drive]) -> None:
        self._drives = tuple(drives)

    def __repr__(self) -> str:
        return f"<{len(self)} drives, {sum(drive.satisfied for drive in self)} satisfied>"

    def __len__(self) -> int:
        return len(self._drives)

    @overload
    def __getitem__(self, index: int) -> Drive: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Drive]: ...
    def __getitem__(self, index: int | slice) -> Drive | Sequence[Drive]:
        return self._drives[index]

    @property
    def expectations(self) -> tuple[Expectation, ...]:
        """How each `expect` came out over the drives."""
        return expectations_of(
            (drive.scene.index, verdict) for drive in self for verdict in drive.verdicts.values()
        )

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Why expectations could not be evaluated, of all drives."""
        return tuple(diagnostic for drive in self for diagnostic in drive.diagnostics)

    @property
    def satisfied(self) -> bool:
        """Whether all expectations hold in all of them."""
        return all(drive.satisfied for drive in self)

    def rows(self) -> list[dict[str, Any]]:
        """Of each drive: `scene`, params and draws, then for each expectation its robustness and,
        as `NAME satisfied`, how it came out."""
        rows = []
        for drive in self:
            row: dict[str, Any] = {"scene": drive.scene.index}
            row |= {**drive.scene.values, **drive.scene.draws}
            for name, verdict in drive.verdicts.items():
                row |= {name: verdict.robustness, f"{name} satisfied": verdict.satisfied}
            rows.append(row)
        return rows

    def to_dict(self) -> dict[str, list[Any]]:
        """`rows` as columns for `pandas.DataFrame`."""
        return columns_of(self.rows())
