"""Searches for scenes of one scenario and makes them: what each worker of a search holds."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, Generic, TypeVar

from ..evaluate.draw_record import DrawRecord
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import KindInstance
from ..judging.acceptance import Acceptance
from .accepted import Accepted, Concretize, Sample, SearchedBlock
from .attempts import accepted_attempts
from .guiding import guided_attempts
from .samplers import is_steering, sampler_of

T = TypeVar("T")


class SceneSearch(Generic[T]):
    """`concretize` makes the scene of an accepted candidate; it is pickled with the scenario."""

    def __init__(self, scenario: IndexedScenario, seed: int, concretize: Concretize[T]) -> None:
        self.acceptance = Acceptance(scenario)
        self.seed = seed
        self.concretize = concretize

    def __reduce__(self) -> tuple[Any, ...]:
        # By its parts: a worker indexes requirements again, which is less than to send them.
        return SceneSearch, (self.acceptance.scenario, self.seed, self.concretize)

    @cached_property
    def sampler(self) -> KindInstance:
        """The sampler of the scenario."""
        return sampler_of(self.acceptance.scenario)

    def search_block(self, scenes: Sequence[int]) -> SearchedBlock[T]:
        """The scenes of a block, each with a stream of attempts."""
        attempts = guided_attempts if is_steering(self.sampler) else accepted_attempts
        accepted, stats = attempts(self.acceptance, self.sampler, self.seed, scenes)
        samples = tuple(self.sample(item) for item in accepted)
        found = {item.index for item in accepted}
        missing = tuple(scene for scene in scenes if scene not in found)
        return SearchedBlock(samples, missing, stats)

    def search_blocks(self, blocks: Sequence[Sequence[int]]) -> list[SearchedBlock[T]]:
        """Several blocks, each by itself."""
        return [self.search_block(block) for block in blocks]

    def samples(self, accepted: Sequence[Accepted]) -> list[Sample[T]]:
        """What accepted candidates become."""
        return [self.sample(each) for each in accepted]

    def sample(self, accepted: Accepted) -> Sample[T]:
        """What an accepted candidate becomes."""
        record = DrawRecord()
        candidate = accepted.candidate(self.acceptance.scenario, self.seed, record)
        result = self.concretize(candidate, accepted.index)
        coordinates = {name: float(values[0]) for name, values in record.coordinates.items()}
        return Sample(result, coordinates)
