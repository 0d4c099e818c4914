"""Scenes that become files as soon as they are made: what a worker hands back of each."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from os import PathLike

from ..diagnostics import DiagnosticError
from ..evaluate.candidates import CandidateBatch
from ..evaluate.kind_instance import KindInstance
from ..ir.manifest import OutputFile
from ..ir.scene import Scene, Verdict
from ..search.accepted import Concretize, Sample
from ..search.searching import LARGEST_BLOCK, SENT_BLOCK
from .emitting import Output, outputs_of_scene, wants_all
from .instantiate import ConcreteScene
from .spool import packed

Stager = Callable[[bytes], bytes | PathLike[str]]
"""Where the content of a file stays until it is taken; pickled with the scenario."""


def held(content: bytes) -> bytes:
    """It is handed back with the scene."""
    return content


@dataclass(frozen=True)
class EmittedFile:
    """A file of a scene, and its content or where that was staged."""

    record: OutputFile
    content: bytes | PathLike[str]


@dataclass(frozen=True)
class EmittedScene:
    """`made` has an outline of the scene, `whole` all of it where somebody wants all scenes."""

    made: ConcreteScene
    files: tuple[EmittedFile, ...]
    whole: bytes | None


@dataclass(frozen=True)
class Emission:
    """The backends that scenes are written by, and who takes what they write. With a `stage` other
    than `held` workers hand back little of a scene."""

    backends: Sequence[KindInstance]
    take: Callable[[EmittedScene], None]
    stage: Stager = held

    @property
    def handling(self) -> tuple[Callable[[Sample[EmittedScene]], Sample[ConcreteScene]], int]:
        """What a search does with each scene, and the most that a worker hands back together."""
        return self._taken, SENT_BLOCK if self.stage is held else LARGEST_BLOCK

    def _taken(self, sample: Sample[EmittedScene]) -> Sample[ConcreteScene]:
        """What is kept of a scene after its files were taken."""
        self.take(sample.result)
        return Sample(sample.result.made, sample.coordinates)


def emitted(
    concretize: Concretize[ConcreteScene],
    backends: Sequence[KindInstance],
    stage: Stager,
    candidates: CandidateBatch,
    numbers: Sequence[int],
) -> list[EmittedScene]:
    """Scenes with their files."""
    keeps = wants_all(backends)
    return [
        EmittedScene(
            replace(made, scene=outline_of(made.scene)),
            tuple(EmittedFile(o.record(), stage(o.content)) for o in _outputs(backends, made)),
            packed(made.scene) if keeps else None,
        )
        for made in concretize(candidates, numbers)
    ]


def _outputs(backends: Sequence[KindInstance], made: ConcreteScene) -> tuple[Output, ...]:
    """What refuses a scene is followed by the warnings of it: they may say why, as where a backend
    needs a place on Earth that its picture does not have."""
    try:
        return tuple(outputs_of_scene(backends, made.scene))
    except DiagnosticError as error:
        raise DiagnosticError(*error.diagnostics, *made.warnings) from None


def outline_of(scene: Scene) -> Scene:
    """A scene with its verdicts alone, and of these no more than how they came out."""
    return Scene(
        scene.name,
        scene.title,
        scene.index,
        scene.provenance,
        requirements=tuple(map(outcome_of, scene.requirements)),
        expectations=tuple(map(outcome_of, scene.expectations)),
    )


def outcome_of(verdict: Verdict) -> Verdict:
    """A verdict without its robustness along roads."""
    name, text, domain = verdict.name, verdict.text, verdict.domain
    return Verdict(name, text, domain, verdict.robustness, verdict.satisfied)
