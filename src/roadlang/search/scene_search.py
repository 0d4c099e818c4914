"""Searches for scenes of one scenario and makes them: what each worker of a search holds."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import cached_property
from itertools import groupby
from typing import Any, Generic, TypeVar

from ..diagnostics import DiagnosticError
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import KindInstance
from ..ir.paused_collector import collector_paused
from ..judging.acceptance import Acceptance
from .accepted import Accepted, Concretize, Sample, SearchedBlock, candidates_of
from .guiding import guided_attempts
from .rejection_sampling import accepted_attempts
from .samplers import is_steering, sampler_of

T = TypeVar("T")


class SceneSearch(Generic[T]):
    """`concretize` makes the scenes of accepted candidates; it is pickled with the scenario."""

    def __init__(
        self,
        scenario: IndexedScenario,
        seed: int,
        concretize: Concretize[T],
    ) -> None:
        self.acceptance = Acceptance(scenario)
        self.seed = seed
        self.concretize = concretize

    def __reduce__(self) -> tuple[Any, ...]:
        # By its parts: a worker indexes requirements again, which is less than to send them.
        parts = (self.acceptance.scenario, self.seed, self.concretize)
        return SceneSearch, parts

    @cached_property
    def sampler(self) -> KindInstance:
        """The sampler of the scenario."""
        return sampler_of(self.acceptance.scenario)

    def search_block(self, scenes: Sequence[int]) -> SearchedBlock[T]:
        """The scenes of a block, each with a stream of attempts."""
        attempts = guided_attempts if is_steering(self.sampler) else accepted_attempts
        accepted, stats = attempts(self.acceptance, self.sampler, self.seed, scenes)
        samples = tuple(self.samples(accepted))
        found = {item.index for item in accepted}
        missing = tuple(scene for scene in scenes if scene not in found)
        return SearchedBlock(samples, missing, stats)

    def search_blocks(self, blocks: Sequence[Sequence[int]]) -> list[SearchedBlock[T]]:
        """Several blocks, each by itself."""
        return [self.search_block(block) for block in blocks]

    def samples(self, accepted: Sequence[Accepted]) -> list[Sample[T]]:
        """What accepted candidates become."""
        return [
            sample
            for _, similar in groupby(accepted, key=lambda each: sorted(each.coordinates))
            for sample in self._samples(tuple(similar))
        ]

    def _samples(self, accepted: Sequence[Accepted]) -> list[Sample[T]]:
        """Of those of which the same coordinates were chosen."""
        if len(accepted) > 1 and self.acceptance.scenario.has_fixed_roots:
            # What cannot be made together is made one by one, until one fails alone.
            with suppress(DiagnosticError):
                return self._made(accepted)
        return [sample for each in accepted for sample in self._made([each])]

    def _made(self, accepted: Sequence[Accepted]) -> list[Sample[T]]:
        candidates = candidates_of(accepted, self.acceptance.scenario, self.seed)
        with collector_paused():
            results = self.concretize(candidates, [each.index for each in accepted])
        assert candidates.record is not None
        drawn = candidates.record.coordinates_of_rows(candidates.count)
        return [Sample(*pair) for pair in zip(results, drawn, strict=True)]
