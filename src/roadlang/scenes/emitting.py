"""Scenes to files: the backends of a scenario, guarded, and what each of them writes."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..diagnostics import Code, DiagnosticError, diagnose
from ..evaluate.candidates import fixed_candidate
from ..evaluate.evaluation import build
from ..evaluate.indexed_scenario import IndexedScenario
from ..evaluate.kind_instance import KindInstance
from ..ir.manifest import MANIFEST_FILE, OutputFile
from ..ir.picture import Picture
from ..ir.scenario import Scenario
from ..ir.scene import Scene
from ..ir.trace import Trace
from ..ir.values import Entity, PassCall
from ..plugins.guard import wrong_result
from ..plugins.kinds import implements
from ..plugins.registry import Registry
from ..world.index import index_scenario
from ..world.sources.pictures import load_picture

_FILE_NAME = re.compile(r"[\w][\w.-]*\Z")


@dataclass(frozen=True)
class Output:
    """One file. `scene` is None for what is written once for all scenes."""

    path: str
    content: bytes
    backend: str
    scene: int | None

    def record(self) -> OutputFile:
        """What the manifest says of it."""
        digest = hashlib.sha256(self.content).hexdigest()
        return OutputFile(self.path, digest, len(self.content), self.backend, self.scene)


def backends_of(
    source: Scenario, registry: Registry, calls: Sequence[PassCall]
) -> list[KindInstance]:
    """The backends that `emit`s of a scenario call.

    Raises `DiagnosticError` for options that are out of bounds and for kinds that are not there.
    """
    scenario = index_scenario(source, registry)
    fixed = fixed_candidate(scenario)

    def resolve(entity: Entity) -> Any:
        return fixed_picture(entity.name, scenario) if entity.role == "image" else entity.name

    return [build(call, fixed, single=True, resolve=resolve) for call in calls]


def fixed_picture(name: str, scenario: IndexedScenario) -> Picture:
    """The picture of an image for a figure. Raises RL229 where it differs between scenes."""
    image = scenario.images[name]
    if scenario.is_varying(image.name):
        what, expected = f"`{image.name}`", "the same in every scene"
        raise DiagnosticError(
            diagnose(Code.MUST_NOT_BE_RANDOM, image.span, what=what, expected=expected)
        )
    return load_picture(name, fixed_candidate(scenario)).picture


def outputs_of_scene(backends: Sequence[KindInstance], scene: Scene) -> list[Output]:
    """The files of a scene, of all backends."""
    return [
        Output(f"{scene.stem}.{ending}", content, backend.entry.recorded, scene.index)
        for backend in backends
        for ending, content in _files_of_scene(backend, scene).items()
    ]


def outputs_of_drive(
    backends: Sequence[KindInstance], scene: Scene, trace: Trace, reserved: Collection[str]
) -> list[Output]:
    """The files of a drive, of all backends. `reserved`: endings that none of them may use.

    Raises `DiagnosticError` RL931 where two have one name, RL474 for other faults.
    """
    names = OutputNames(backends)
    found = []
    for backend in backends:
        with backend.guarded:
            files = backend.kind.drive_files(scene, trace)
        for ending, content in _checked(files, backend).items():
            if ending.casefold() in reserved:
                fault = f"gave a file of a drive the ending {ending!r}, which `roadlang run` uses"
                raise wrong_result(backend.entry, backend.call.span, fault)
            found.append(
                Output(f"{scene.stem}.{ending}", content, backend.entry.recorded, scene.index)
            )
            names.add(found[-1])
    return found


def outputs_of_all(backends: Sequence[KindInstance], scenes: Sequence[Scene]) -> Iterator[Output]:
    """What backends write once for all scenes."""
    for backend in backends:
        with backend.guarded:
            files = backend.kind.collection(scenes)
        for path, content in _checked(files, backend).items():
            if path.casefold() == MANIFEST_FILE:
                fault = f"gave a file the name {path!r}, which is that of the manifest"
                raise wrong_result(backend.entry, backend.call.span, fault)
            yield Output(path, content, backend.entry.recorded, None)


def wants_all(backends: Iterable[KindInstance]) -> bool:
    """Whether a backend writes something for all scenes, or sends them to an engine."""
    kinds = [type(backend.kind) for backend in backends]
    return any(implements(kind, "collection") or implements(kind, "send") for kind in kinds)


class OutputNames:
    """The names of the files so far, and who wrote them."""

    def __init__(self, backends: Sequence[KindInstance]) -> None:
        self._calls = {backend.entry.recorded: backend.call for backend in backends}
        self._names: dict[str, str] = {}

    def add(self, output: Output | OutputFile) -> None:
        """Raises `DiagnosticError` RL931 where two have one name."""
        if output.path in self._names:
            raise DiagnosticError(
                diagnose(
                    Code.DUPLICATE_OUTPUT,
                    self._calls[output.backend].span,
                    first=self._names[output.path],
                    second=output.backend,
                    files=f"`{output.path}`",
                )
            )
        self._names[output.path] = output.backend


def send(backends: Iterable[KindInstance], scenes: Iterable[Scene]) -> None:
    """Deliver the scenes through the backends that speak to an engine."""
    live = [backend for backend in backends if implements(type(backend.kind), "send")]
    for scene in scenes:
        for backend in live:
            with backend.guarded:
                backend.kind.send(scene)


def _files_of_scene(backend: KindInstance, scene: Scene) -> Mapping[str, bytes]:
    with backend.guarded:
        files = backend.kind.files(scene)
    return _checked(files, backend)


def _checked(files: Any, backend: KindInstance) -> Mapping[str, bytes]:
    """File contents as bytes. Raises `DiagnosticError` RL474 for anything else."""
    entry, span = backend.entry, backend.call.span
    if not isinstance(files, Mapping):
        raise wrong_result(entry, span, f"gave a {type(files).__name__}, not a map of contents")
    contents: dict[str, bytes] = {}
    with backend.guarded:
        written = list(files.items())
    for name, content in written:
        if not isinstance(name, str) or not _FILE_NAME.match(name):
            raise wrong_result(entry, span, f"gave a file the name {name!r}")
        if not isinstance(content, str | bytes):
            fault = f"gave a {type(content).__name__} as the content of `{name}`"
            raise wrong_result(entry, span, fault)
        try:
            contents[name] = content.encode() if isinstance(content, str) else content
        except UnicodeEncodeError as error:
            fault = f"gave text as the content of `{name}` that UTF-8 cannot hold: {error.reason}"
            raise wrong_result(entry, span, fault) from error
    return contents
