"""An engine for many drives that is restarted if it is lost."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

from roadlang.api import Code

from ..faults import EngineError, fault
from ..net.session import Session
from . import engine

if TYPE_CHECKING:
    from roadlang.api import Scene

T = TypeVar("T")

MOST_LOSSES = 3
"""Number of engines that crash or stop answering in one scene before the scene counts as the
cause."""
MOST_KILLS = 20
"""Engines that something else may kill in one scene, or one after the other while they start."""
_LOST = frozenset({Code.GODOT_DISCONNECTED, Code.GODOT_NOT_ANSWERING})


class RestartedEngine:
    """An engine with a session, started when it is needed, and again when it is lost.

    `start` starts an engine.
    """

    def __init__(self, start: Callable[[], engine.Engine]) -> None:
        self._start = start
        self._engine: engine.Engine | None = None
        self._session: Session | None = None

    def drive(self, scene: Scene, work: Callable[[Session], T]) -> T:
        """What `work` makes of a scene; done again from its start where the engine is lost.

        Only engines that were lost at work count against the scene. Raises RL505 that names it
        where they were too many.
        """
        losses = kills = 0
        while True:
            session = self._connected(scene.name)
            try:
                return work(session)
            except EngineError as error:
                if not _is_loss(error):
                    raise
                if self._was_killed():
                    kills += 1
                else:
                    losses += 1
                self.stop()
                if losses >= MOST_LOSSES or kills >= MOST_KILLS:
                    raise _lost_with(scene, losses + kills, error) from error

    def stop(self) -> None:
        """End the session and the engine."""
        session, running = self._session, self._engine
        self._session = self._engine = None
        if session is not None:
            session.close()
        if running is not None:
            running.stop()

    def _was_killed(self) -> bool:
        return self._engine is not None and self._engine.was_killed

    def _connected(self, name: str) -> Session:
        """The session, of a new engine where there is none. Raises RL505 where engines are lost
        before anything is driven."""
        starts = 0
        while self._session is None:
            try:
                self._engine = self._start()
                self._session = self._engine.connect(name)
            except EngineError as error:
                self.stop()
                starts += 1
                if not _is_loss(error) or starts >= MOST_KILLS:
                    raise
        return self._session


def _is_loss(error: EngineError) -> bool:
    return any(found.code in _LOST for found in error.diagnostics)


def _lost_with(scene: Scene, count: int, error: EngineError) -> EngineError:
    reason = f"{count} engines were lost in scene {scene.index} of `{scene.name}`"
    last = [found.message for found in error.diagnostics]
    return fault(Code.GODOT_DISCONNECTED, [f"the last one: {text}" for text in last], reason=reason)
