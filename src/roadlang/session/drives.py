"""Drives of scenes: traces as columns, and how the expectations came out."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from ..diagnostics import arguments
from ..drive.figure import drive_figure
from ..drive.simulators import Driven, drive_scenes
from ..drive.standing import without_objects
from ..drive.trace_files import COLUMNS, to_csv, to_json
from ..drive.written_places import UNKNOWN, WrittenPlaces
from ..ir.controller_failure import failure_columns
from ..ir.result_columns import OF_DRIVES, robustness_column, value_columns
from ..judging.badness import says_how_near, worst_of
from ..judging.deciding_moment import DecidingMoment, deciding_moment, first_violation
from ..judging.robustness_series import robustness_series
from .expectations import Expectation, expectations_of
from .tables import columns_of, frame_of

if TYPE_CHECKING:
    import pandas

    from ..diagnostics import Diagnostic
    from ..geometry.arrays import Floats
    from ..ir.readings import SensorRecord
    from ..ir.scene import RoadPlace, Verdict
    from ..ir.trace import Trace
    from ..plugins.registry import Registry
    from .scene import Scene


def drive(
    scenes: Sequence[Scene],
    registry: Registry,
    engine: str | None,
    options: Mapping[str, Any],
    places: WrittenPlaces = UNKNOWN,
    expects: Sequence[str] = (),
) -> DriveSet:
    """Drive scenes, all with one engine. `places`: where faults are shown; `expects`: what a search
    was for, the most important first."""
    arguments.text_or_none("engine", engine)
    records = [scene.record for scene in scenes]
    driven = (
        drive_scenes(records, registry, engine, options, record_sensors=True, places=places)
        if records
        else ()
    )
    return DriveSet(
        Drive(scene, found, places, expects) for scene, found in zip(scenes, driven, strict=True)
    )


class Drive:
    """One scene, driven. `trace` is what was recorded; SI units and radians."""

    def __init__(
        self, scene: Scene, driven: Driven, places: WrittenPlaces, expects: Sequence[str] = ()
    ) -> None:
        self.scene = scene
        self.trace: Trace = driven.trace
        self.readings: tuple[SensorRecord, ...] = driven.readings
        """what the sensors of the agents measured; none of a drive of a search"""
        self._verdicts = driven.judgment.verdicts
        self._faults = driven.judgment.faults_at(places.expectations)
        self._warnings = driven.judgment.warnings
        self._places = places
        self._expects = expects

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

    @property
    def verdicts(self) -> Mapping[str, Verdict]:
        """Each `expect` by name, with its robustness, satisfied or not."""
        return MappingProxyType(self._by_name)  # which cannot be pickled, as drives can

    @cached_property
    def _by_name(self) -> dict[str, Verdict]:
        return {verdict.name: verdict for verdict in self._verdicts}

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Why expectations could not be evaluated on this drive; each names its expectation. Then
        warnings of windows that hold no sample of the drive."""
        faults = (
            replace(
                fault,
                help=(*fault.help, f"this is the expectation `{name}` in scene {self.scene.index}"),
            )
            for name, faults in self._faults.items()
            for fault in faults
        )
        warnings = (
            replace(warning, span=self._places.expectations.get(name))
            for name, found in self._warnings.items()
            for warning in found
        )
        return (*faults, *warnings)

    @property
    def satisfied(self) -> bool:
        """Whether all expectations hold."""
        return all(verdict.satisfied for verdict in self._verdicts)

    @property
    def verdict(self) -> str:
        """`holds`, `violated`, or `not judged` where nothing is expected or could be judged."""
        if any(verdict.satisfied is False for verdict in self._verdicts):
            return "violated"
        return "holds" if self._verdicts and self.satisfied else "not judged"

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
        return frame_of(self.to_dict(), "time")

    @property
    def has_unjudged_contacts(self) -> bool:
        """Whether agents touch something, but no expectation is violated."""
        touched = any(event["event"] == "contact" for event in self.trace.events)
        return touched and self.verdict != "violated"

    @property
    def worst(self) -> Verdict | None:
        """The violated expectation of least robustness; where all hold that of the least above 0:
        what equality decides (`ego.contacts == 0`) holds with 0, and came near to nothing. Of a
        search, the first violated one of those that it was for."""
        return worst_of(self._verdicts, self._expects)

    @cached_property
    def worst_moment(self) -> DecidingMoment | None:
        """When the worst expectation is decided, and for whom."""
        worst = self.worst
        return None if worst is None else deciding_moment(worst, self.trace, self.scene.registry)

    @cached_property
    def first_violation(self) -> DecidingMoment | None:
        """When the worst expectation first goes wrong, and for whom; None where all hold."""
        worst = self.worst
        if worst is None or worst.satisfied is not False:
            return None
        return first_violation(worst, self.trace, self.scene.registry)

    def svg(self) -> str:
        """The roads and paths, colored by the robustness of the worst expectation."""
        worst, moment = self.worst, self.worst_moment
        series, title = None, f"scene {self.scene.index}"
        if worst is not None:
            series = robustness_series(worst, self.trace, self.scene.registry)
            rho = "" if worst.robustness is None else f", robustness {worst.robustness:.3g}"
            title = f"{title}: {worst.name}{rho}"
        first = next(iter(self.trace.agents), "")
        name = moment.actors[0].name if moment is not None and moment.actors else first
        at = None if moment is None else moment.sample
        record = self.scene.record
        return drive_figure(record, self.moving_trace, name, series, title, at)

    def _repr_svg_(self) -> str:
        return self.svg()

    @cached_property
    def moving_trace(self) -> Trace:
        """The trace without objects that stand still, which are in the scene."""
        return without_objects(self.trace, self.scene.record)

    def to_csv(self) -> str:
        """The trace as `roadlang run` writes it: one row for each agent at each time. Objects that
        stand still are in the scene, not here."""
        return to_csv(self.moving_trace)

    def to_json(self) -> str:
        """The same as JSON, with everything that was recorded."""
        return to_json(self.moving_trace)


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
        """Those of all drives; a warning of several drives is there once."""
        found = (diagnostic for drive in self for diagnostic in drive.diagnostics)
        return tuple(dict.fromkeys(found))

    @property
    def satisfied(self) -> bool:
        """Whether all expectations hold in all of them."""
        return all(drive.satisfied for drive in self)

    def rows(self) -> list[dict[str, Any]]:
        """Of each drive: `scene`, params and draws, then for each expectation its robustness and,
        as `NAME satisfied`, how it came out; `verdict` of all; which is the worst, and when and
        where (`worst`, `worst time`, `worst agent`, `worst x`, `worst y`, `worst station`; `worst
        road` in place of time and agent where it is about roads alone); where a controller failed
        during the drive, `controller failure time`, `... agent`, `... reason`.
        """
        rows = []
        for drive in self:
            row: dict[str, Any] = {"scene": drive.scene.index}
            row |= value_columns({**drive.scene.values, **drive.scene.draws}, OF_DRIVES)
            for name, verdict in drive.verdicts.items():
                row[robustness_column(name, OF_DRIVES)] = verdict.robustness
                row[f"{name} satisfied"] = verdict.satisfied
            row["verdict"] = drive.verdict
            failures = failure_columns(drive.trace.controller_failures)
            rows.append(row | _worst_columns(drive) | failures)
        return rows

    def to_dict(self) -> dict[str, list[Any]]:
        """`rows` as columns for `pandas.DataFrame`."""
        return columns_of(self.rows())

    def to_frame(self) -> pandas.DataFrame:
        """`rows` as a data frame with the scenes as index. Raises `ImportError` without pandas."""
        return frame_of(self.to_dict(), "scene")


def _worst_columns(drive: Drive) -> dict[str, Any]:
    worst, moment = drive.worst, drive.worst_moment
    columns: dict[str, Any] = {"worst": None if worst is None else worst.name}
    if worst is None or not says_how_near(worst.satisfied, worst.robustness):
        return columns
    if worst.tightest is not None:
        columns |= {f"worst {name}": found for name, found in _on_road(drive, worst.tightest)}
    elif moment is not None and moment.actors:
        agent, at = moment.actors[0], moment.sample
        columns |= {"worst time": float(drive.trace.time[at]), "worst agent": agent.name}
        for name in ("x", "y", "station"):
            value = float(getattr(agent, name)[at])
            columns[f"worst {name}"] = value if math.isfinite(value) else None
    return columns


def _on_road(drive: Drive, place: RoadPlace) -> Iterator[tuple[str, Any]]:
    """Which road, where it is there, and the station: that of the requirements."""
    yield "road", place.road
    roads = drive.scene.record.roads
    for road in [road for road in roads if road.name == place.road][:1]:
        for name, values in (("x", road.x), ("y", road.y)):
            yield name, float(np.interp(place.station, road.reference_stations, values))
    yield "station", place.station
