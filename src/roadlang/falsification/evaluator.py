"""Evaluates points of the search space: candidates, their scenes, their drives. Workers hold it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from ..diagnostics import Diagnostic, DiagnosticError
from ..drive.simulators import Driven, drive_scenes, simulator_call
from ..drive.written_places import WrittenPlaces
from ..evaluate.candidates import CandidateBatch
from ..evaluate.draw_record import DrawRecord
from ..geometry.arrays import Floats, Integers
from ..ir.scenario import Scenario
from ..ir.scene import Call, Scene
from ..judging.acceptance import Acceptance, Measurements
from ..judging.window_warnings import road_window_warnings
from ..plugins.finding import entry_of
from ..plugins.kinds import Axis
from ..plugins.registry import Registry
from ..scenes.instantiate import all_concrete_scenes, driven_scenes_or_faults
from ..world.index import index_scenario
from .axes import axes_of
from .descriptors import descriptor, measures, moment_of, protagonist
from .outcome import Outcome
from .violations import Violations

AFTER_VIOLATION = "after_violation"
"""The option of simulators that can end a drive early."""
_WORTH_IT = 8
"""Candidates of one screening, at least, that are not measured again."""
_SCREENED = -3
"""The scene of points that are only screened: it keys what no axis chooses."""


@dataclass(frozen=True)
class Task:
    """What is searched in: the same for all points. `expects`: the expectations to violate, the
    most important first; `engine` and `options`: the simulator, where it is not the scenario's."""

    scenario: Scenario
    registry: Registry
    seed: int
    axes: tuple[str, ...]
    expects: tuple[str, ...]
    engine: str | None = None
    options: Mapping[str, Any] = field(default_factory=dict)
    overrides: Mapping[str, str] = field(default_factory=dict)
    after_violation: float | None = 2.0
    """seconds that a drive continues after all its expectations are violated; None: it ends as
    it would without a search"""


@dataclass(frozen=True, slots=True)
class Proposal:
    """A point to be evaluated; `index` also keys what no axis chooses."""

    index: int
    point: tuple[float, ...]
    is_random: bool = False


@dataclass(frozen=True)
class _Screened:
    """Candidates that were screened; `rows`: by the bytes of their points."""

    rows: Mapping[bytes, int]
    candidates: CandidateBatch
    measured: Measurements


class Evaluator:
    """Nothing of an outcome depends on what is evaluated with it."""

    def __init__(self, task: Task) -> None:
        self.task = task
        self.scenario = index_scenario(task.scenario, task.registry)
        self._places = WrittenPlaces.of(task.scenario)
        self.acceptance = Acceptance(self.scenario)
        self._violations = Violations(self.acceptance, task.seed)
        self._screened: list[_Screened] = []
        self._simulator: tuple[Call | None, Call] | None = None
        """what the last scene says of how it is driven, and how it is in this search"""

    @cached_property
    def _axes(self) -> tuple[Axis, ...]:
        known = {axis.name: axis for axis in axes_of(self.scenario, self.task.seed)}
        return tuple(known.get(name, Axis(name)) for name in self.task.axes)

    @property
    def simplest(self) -> tuple[float, ...]:
        """The coordinates of the simplest values of all axes."""
        return tuple(axis.simplest for axis in self._axes)

    @property
    def ordered(self) -> tuple[bool, ...]:
        """Of which axes there are values between others."""
        return tuple(axis.ends is None or axis.is_ordered for axis in self._axes)

    def __reduce__(self) -> tuple[type[Evaluator], tuple[Task]]:
        return Evaluator, (self.task,)

    def evaluate(self, proposals: Sequence[Proposal]) -> list[Outcome]:
        """The outcome of each, in order. Raises DiagnosticError where no scene can be driven."""
        outcomes: dict[int, Outcome] = {}
        scenes: dict[int, Scene] = {}
        rho = np.empty((len(self.acceptance.requirements), len(proposals)))
        for rows, valid, measured in self._measured(proposals):
            rho[:, rows] = measured.rho
            violations, is_valid = self._violations.of(measured), measured.satisfied.all(axis=0)
            for row, violation in zip(rows[~is_valid].tolist(), violations[~is_valid], strict=True):
                outcomes[row] = self._invalid(proposals[row], float(violation), rho[:, row])
            rows, valid = self._with_room(proposals, rows[is_valid], valid, outcomes, rho)
            numbers = [proposals[row].index for row in rows.tolist()]
            made = driven_scenes_or_faults(valid, numbers, self.task.overrides) if numbers else []
            for row, found in zip(rows.tolist(), made, strict=True):
                if isinstance(found, Scene):
                    scenes[row] = self._with_simulator(found)
                    continue
                if not _is_of_draws(found):
                    raise found
                worst = float(len(self.acceptance.requirements) + 1)
                outcomes[row] = self._invalid(proposals[row], worst, rho[:, row])
        if scenes:
            driven = drive_scenes(
                list(scenes.values()), self.task.registry, None, {}, places=self._places
            )
            for row, drive in zip(scenes, driven, strict=True):
                outcomes[row] = self.outcome(proposals[row], drive, rho[:, row])
        return [outcomes[row] for row in range(len(proposals))]

    def screen(self, points: Floats) -> Floats:
        """(n,) of points (n, axes): 0 where the requirements hold, else 1 and by how much they are
        violated, as for a search."""
        unused = np.zeros(len(points), np.int64)
        candidates = self._batch(points, unused + _SCREENED, unused)
        measured = self.acceptance.measure(candidates)
        if not candidates.is_keyed:
            rows = {point.tobytes(): row for row, point in enumerate(points)}
            self._screened.append(_Screened(rows, candidates, measured))
        violations = np.where(
            measured.satisfied.all(axis=0), 0.0, 1.0 + self._violations.of(measured)
        )
        survivors = np.flatnonzero(violations == 0.0)
        if len(survivors):
            room = self.acceptance.measure(candidates.take(survivors), last=True)
            lack = self._violations.of(room)
            violations[survivors] = np.where(lack > 0.0, 1.0 + lack, 0.0)
        return violations

    def full_scene(self, proposal: Proposal) -> Scene:
        """The scene of a point with all that people and figures want."""
        return self.full_scenes([proposal])[0]

    def full_scenes(self, proposals: Sequence[Proposal]) -> list[Scene]:
        """Those of several points."""
        if not proposals:
            return []
        candidates = self._candidates(proposals)
        numbers = [proposal.index for proposal in proposals]
        made = all_concrete_scenes(candidates, numbers, self.task.overrides)
        return [self._with_simulator(found.scene) for found in made]

    def window_warnings(self, proposal: Proposal) -> tuple[Diagnostic, ...]:
        """Of formulas over the roads of a scene whose windows hold no sample of them."""
        return road_window_warnings(self._candidates([proposal]))

    def outcome(self, proposal: Proposal, driven: Driven, rho: Floats) -> Outcome:
        """What came of a drive. Raises DiagnosticError where an expectation has no verdict."""
        task, scene = self.task, driven.scene
        faults = driven.judgment.faults_at(self._places.expectations)
        of_ours = [fault for name in task.expects for fault in faults.get(name, ())]
        if of_ours:
            raise DiagnosticError(*of_ours)
        verdicts = {verdict.name: verdict for verdict in driven.judgment.verdicts}
        violated = tuple(name for name in task.expects if verdicts[name].satisfied is False)
        moment = None
        if violated:
            moment = moment_of(verdicts[violated[0]], scene, driven.trace, task.registry)
        name = protagonist(scene, task.expects)
        return Outcome(
            proposal.index,
            proposal.point,
            proposal.is_random,
            None,
            self._named(rho),
            {name: verdicts[name].robustness for name in task.expects},
            violated,
            {**scene.values, **scene.draws},
            measures(scene, driven.trace, name),
            descriptor(scene, driven.trace, name, moment),
            moment,
            driven.trace.controller_failures,
        )

    def _with_simulator(self, scene: Scene) -> Scene:
        """The scene, which says how it is driven in this search: alone it is the same drive."""
        if self._simulator is None or self._simulator[0] != scene.simulate:
            self._simulator = scene.simulate, self._simulator_call(scene)
        return replace(scene, simulate=self._simulator[1])

    def _simulator_call(self, scene: Scene) -> Call:
        task = self.task
        call = simulator_call(scene, task.registry, task.engine, task.options)
        seconds = task.after_violation
        is_said = seconds is None or call.options.get(AFTER_VIOLATION) is not None
        if is_said or not self._can_end_early(call.kind):
            return call
        return replace(call, options={**call.options, AFTER_VIOLATION: seconds})

    def _can_end_early(self, kind: str) -> bool:
        entry = entry_of(self.task.registry, "simulate", kind)
        return any(option.name == AFTER_VIOLATION for option in entry.options)

    def _with_room(
        self,
        proposals: Sequence[Proposal],
        rows: Integers,
        valid: CandidateBatch,
        outcomes: dict[int, Outcome],
        rho: Floats,
    ) -> tuple[Integers, CandidateBatch]:
        """The rows, with their candidates, in which there is room for all agents and objects. A
        search chooses where they are, so that nothing is placed again; the others are outcomes."""
        if not len(rows):
            return rows, valid
        measured = self.acceptance.measure(valid, last=True)
        fits = measured.satisfied.all(axis=0)
        if fits.all():
            return rows, valid
        lack = self._violations.of(measured)
        for row, violation in zip(rows[~fits].tolist(), lack[~fits], strict=True):
            outcomes[row] = self._invalid(proposals[row], float(violation), rho[:, row])
        return rows[fits], valid.take_recorded(np.flatnonzero(fits))

    def _invalid(self, proposal: Proposal, violation: float, rho: Floats) -> Outcome:
        return Outcome(
            proposal.index, proposal.point, proposal.is_random, violation, self._named(rho)
        )

    def _named(self, rho: Floats) -> dict[str, float | None]:
        """Robustness by requirement, without those that go without saying."""
        return {
            requirement.name: float(value) if math.isfinite(value) else None
            for requirement, value in zip(self.acceptance.requirements, rho, strict=True)
            if not requirement.implied
        }

    def _measured(
        self, proposals: Sequence[Proposal]
    ) -> Iterator[tuple[Integers, CandidateBatch, Measurements]]:
        """The rows of proposals in parts, of each the candidates that satisfy the requirements, and
        the measurements of all. What was screened since the last call is not measured again."""
        screened, self._screened = self._screened, []
        points = [np.array(proposal.point).tobytes() for proposal in proposals]
        indices = np.array([proposal.index for proposal in proposals], np.int64)
        rest = np.arange(len(proposals))
        for part in screened:
            places = np.array([part.rows.get(points[row], -1) for row in rest.tolist()], np.int64)
            rows, places = rest[places >= 0], places[places >= 0]
            # Where they find room may be keyed, where nothing that was measured before is.
            if len(rows) < _WORTH_IT or part.candidates.is_keyed:
                continue
            rest = np.setdiff1d(rest, rows)
            measured = part.measured.take(places)
            is_valid = measured.satisfied.all(axis=0)
            attempts = indices[rows[is_valid]]
            numbers = np.zeros_like(attempts), attempts
            yield rows, part.candidates.renumbered(places[is_valid], *numbers), measured
        if len(rest):
            candidates = self._candidates([proposals[row] for row in rest.tolist()])
            measured = self.acceptance.measure(candidates)
            valid = candidates.take_recorded(np.flatnonzero(measured.satisfied.all(axis=0)))
            yield rest, valid, measured

    def _candidates(self, proposals: Sequence[Proposal]) -> CandidateBatch:
        points = np.array([proposal.point for proposal in proposals])
        points = points.reshape(len(proposals), len(self.task.axes))
        attempts = np.array([proposal.index for proposal in proposals])
        return self._batch(points, np.zeros_like(attempts), attempts)

    def _batch(self, points: Floats, scenes: Integers, attempts: Integers) -> CandidateBatch:
        coordinates = {name: points[:, column] for column, name in enumerate(self.task.axes)}
        record = DrawRecord()
        return CandidateBatch(self.scenario, self.task.seed, scenes, attempts, coordinates, record)


def _is_of_draws(error: DiagnosticError) -> bool:
    """Whether a fault is of these draws, not of the scenario: other draws may do without it."""
    from ..diagnostics import Code

    ours = (Code.DEGENERATE_ROAD, Code.DRAWN_VALUE_OUT_OF_BOUNDS, Code.POSITION_OFF_ROAD)
    return all(diagnostic.code in ours for diagnostic in error.diagnostics)
