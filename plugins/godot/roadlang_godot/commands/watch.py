"""`roadlang watch FILE`: every save reaches the running simulator, which drives on meanwhile."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from itertools import zip_longest
from typing import TYPE_CHECKING

import click

from roadlang.commands import Seed, WholeNumber, echo, report
from roadlang.commands import seconds as times
from roadlang_godot.usual_port import USUAL_PORT

from .watched_file import WatchedFile

if TYPE_CHECKING:
    from concurrent.futures import Future

    from roadlang import LoadedScenario, SceneSet
    from roadlang.api import Scene as SceneRecord
    from roadlang.commands import DiagnosticError
    from roadlang_godot.editing.compiled_edit import CompiledEdit
    from roadlang_godot.editing.live import HandEdit, LiveScene
    from roadlang_godot.net.session import Session

LISTEN, BRIEFLY = 0.05, 0.005
"""Seconds between checks of the file, and of what is being compiled."""
JUDGE_EVERY = 0.5
REST = 0.25
"""Seconds for which what is dragged stays where it is before it is compiled."""
BYTE_ORDER_MARK = "\ufeff"

_WITHOUT_HOST = "without `--host`, roadlang starts Godot itself"


@click.command("watch")
@click.argument("file")
@click.option("--headless", is_flag=True, help="Start Godot without a window.")
@click.option("--host", help="Host of a running `roadlang godot` to use.")
@click.option(
    "--port",
    type=WholeNumber(1, 65535),
    default=USUAL_PORT,
    show_default=True,
    help="Port of that Godot.",
)
@click.option(
    "--road", type=click.Choice(["mesh", "tiles"]), default="mesh", help="How to build the road."
)
@click.option("--save", is_flag=True, help="Save changes made in the window to FILE.")
@click.option("--seed", type=Seed(), default=0, show_default=True, help="Random seed.")
@click.option(
    "--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set the value of a param."
)
@click.option("--for", "seconds", type=times(min=0), help="Exit after this time, such as 60s.")
def command(  # noqa: PLR0913 - one parameter per option
    file: str,
    headless: bool,
    host: str | None,
    port: int,
    road: str,
    save: bool,
    seed: int,
    settings: tuple[str, ...],
    seconds: float | None,
) -> None:
    """Drive FILE in Godot, and update the scene each time FILE is saved.

    In the window, roads, objects and the starts of agents can be dragged by their handles;
    robustness is shown live.
    """
    from roadlang import load
    from roadlang.commands import parse_overrides
    from roadlang_godot.engines import engine
    from roadlang_godot.engines.running_engine import RunningEngine

    loaded = load(file).with_params(parse_overrides(settings))
    scenes = loaded.sample(1, seed=seed)
    report(scenes.diagnostics)
    watcher = Watcher(loaded, seed, road, save)
    deadline = float("inf") if seconds is None else time.monotonic() + seconds
    if host is not None:
        with RunningEngine(host, port, otherwise=_WITHOUT_HOST).connect(scenes[0].name) as session:
            watcher.run(session, scenes, deadline)
        return
    with engine.start(window=not headless) as running, running.connect() as session:
        watcher.run(session, scenes, deadline)


class Watcher:
    """Looks after one file and one simulator. Edits are compiled beside the drive, which goes on.

    After an edit, the agents go on where they are; one whose own start was edited starts anew.
    What is dragged in the window is an edit of the text, at each move of the mouse: it is shown at
    once, and compiled when the mouse rests or lets go.
    """

    def __init__(self, loaded: LoadedScenario, seed: int, road: str, save: bool) -> None:
        from concurrent.futures import ThreadPoolExecutor

        from roadlang_godot.editing.edited_text import EditedText
        from roadlang_godot.editing.held_agent import NOBODY

        self._loaded = loaded
        self._file = str(loaded.path)
        self._on_disk = WatchedFile(self._file)
        self._seed = seed
        self._road = road
        self._save = save
        self._edited = EditedText(loaded.text)
        self._saved = self._compiled = loaded.text
        self._compiler = ThreadPoolExecutor(1, "compiler")
        self._compiling: Future[CompiledEdit] | None = None
        self._is_previewed = self._is_moved = False
        self._held = NOBODY
        self._moved_at = 0.0
        self._problems: tuple[str, ...] = ()

    def run(self, session: Session, scenes: SceneSet, deadline: float) -> None:
        """Until the deadline, or Ctrl-C."""
        live = self.start(session, scenes[0].record)
        echo(f"{self._file} is being driven: save it to update the scene, press Ctrl-C to stop")
        judged = 0.0
        with self._compiler:
            while time.monotonic() < deadline:
                self.listen(live)
                self.look(live)
                if time.monotonic() - judged > JUDGE_EVERY:
                    judged = time.monotonic()
                    live.show([*self._problems, *_lines(live, scenes)])

    def start(self, session: Session, scene: SceneRecord) -> LiveScene:
        """Build the scene, and start to drive in it."""
        from roadlang.commands import handles_of, python_controllers
        from roadlang_godot.editing.live import LiveScene

        controllers = python_controllers(scene, self._loaded.registry, self._loaded.places)
        handles = handles_of(self._loaded.text, scene)
        return LiveScene(session, scene, controllers, self._road, handles)

    def listen(self, live: LiveScene) -> None:
        """Drive on for a moment, and do what a human did."""
        from roadlang.commands import DiagnosticError
        from roadlang_godot.faults import EngineError

        try:
            for edit in _last_moves(live.listen(LISTEN if self._compiling is None else BRIEFLY)):
                self.take(live, edit)
        except DiagnosticError as error:  # of a controller: the drive waits for an edit
            if isinstance(error, EngineError):
                raise
            report(error.diagnostics)

    def look(self, live: LiveScene, at_rest: bool = False) -> None:
        """See whether the file has changed, and change the scene once that is compiled. `at_rest`:
        whether what is dragged is known to rest."""
        from roadlang_godot.editing.compiled_edit import compiled

        if self._compiling is not None and self._compiling.done():
            compiling, self._compiling = self._compiling, None
            self._change(live, compiling)
        text = self._on_disk.read(time.monotonic())
        if text is not None and text != self._saved:
            self._saved = text
            self._edited.replace(text)
        wanted = self._edited.shown
        is_shown = self._is_previewed or self._is_moved
        waits = is_shown and not at_rest and time.monotonic() - self._moved_at < REST
        if self._compiling is None and wanted != self._compiled and not waits:
            self._compiled = wanted
            loaded = self._loaded.with_text(self._compiled)
            self._compiling = self._compiler.submit(compiled, loaded, self._seed)
        self._keep()

    def settle(self, live: LiveScene) -> None:
        """Drive on until what has changed so far is in the simulator."""
        self.look(live, at_rest=True)
        while self._compiling is not None:
            self.listen(live)
            self.look(live, at_rest=True)

    def take(self, live: LiveScene, edit: HandEdit) -> None:
        """Apply changes made in the window to the text."""
        from roadlang_godot.editing.held_agent import held_agent

        self._moved_at = time.monotonic()
        self._held = held_agent(self._held, edit, live, self._edited.text)
        if not self._edited.take(edit, live.scene) and edit.done and edit.handle is not None:
            echo(f"`{edit.handle.name}` is unchanged: {self._file} cannot express this edit")
        was_previewed, self._is_previewed = self._is_previewed, self._preview(live)
        if was_previewed and not self._is_previewed:
            self._compiled = ""  # what is shown is of no text: the text is compiled anew
            self._problems = ()
        self._show_moved(live)

    def _show_moved(self, live: LiveScene) -> None:
        """Show a network where it is dragged to, until that is compiled."""
        motion = self._edited.motion(self._loaded.text)
        if motion is not None:
            live.show_moved(motion)
        elif self._is_moved:
            self._compiled = ""
        self._is_moved = motion is not None

    def _preview(self, live: LiveScene) -> bool:
        """Show what is dragged, where that needs no compiling; whether it does not."""
        from roadlang.commands import handles_of, python_controllers

        scene = self._edited.preview(live.scene)
        if scene is None:
            return False
        controllers = python_controllers(scene, self._loaded.registry, self._loaded.places)
        handles, moved = handles_of(self._edited.shown, scene), self._edited.dragged_agent
        poses = self._held.poses_in(self._edited.shown)
        live.change(scene, controllers, moved, handles, poses, waits=False)
        return True

    def _change(self, live: LiveScene, compiling: Future[CompiledEdit]) -> None:
        from roadlang.commands import DiagnosticError, edited_starts

        try:
            edit = compiling.result()
            began = time.monotonic()
            restarted = edited_starts(self._loaded.scenario, edit.loaded.scenario)
            poses = self._held.poses_in(edit.loaded.text)
            count = live.change(edit.scene, edit.controllers, restarted, edit.handles, poses)
        except DiagnosticError as error:
            self._refuse(live, error)
            return
        self._loaded, self._problems = edit.loaded, ()
        self._is_moved = False
        if edit.loaded.text != self._edited.shown:  # what is dragged has moved on
            self._is_previewed = self._preview(live)
        if edit.loaded.text != self._edited.text:
            self._show_moved(live)  # a moment of a drag
            return
        sent, took = 1000 * (time.monotonic() - began), 1000 * edit.seconds
        echo(f"{count} changes in {sent:.0f} ms, after {took:.0f} ms of compiling")

    def _refuse(self, live: LiveScene, error: DiagnosticError) -> None:
        """What was changed by hand has no scene: that is shown, and what is not dragged any more is
        as before."""
        found = [one for one in error.diagnostics if one.is_error]
        self._problems = tuple(f"{one.code}  {one.message}" for one in found)
        live.show([*self._problems])
        if self._compiled == self._edited.text:  # no moment of a drag
            report(error.diagnostics)
        elif self._is_previewed or self._is_moved:
            return
        self._edited.withdraw(self._compiled)

    def _keep(self) -> None:
        """Save what was changed by hand, once it has a scene."""
        from roadlang.commands import replace_file

        text, path = self._edited.text, self._loaded.path
        if not self._save or text == self._saved or text != self._loaded.text:
            return
        assert path is not None
        mark = BYTE_ORDER_MARK if path.read_bytes().startswith(BYTE_ORDER_MARK.encode()) else ""
        replace_file(path, mark + text)
        self._saved = text


def _last_moves(edits: Sequence[HandEdit]) -> Iterator[HandEdit]:
    """Without the moves of a drag that others of it follow at once."""
    for edit, later in zip_longest(edits, edits[1:]):
        if later is None or edit.what != "move" or later.drag != edit.drag:
            yield edit


def _lines(live: LiveScene, scenes: SceneSet) -> list[str]:
    """Robustness of every requirement, and of every expectation on what was driven lately."""
    from roadlang.commands import judge_so_far

    verdicts = list(live.scene.requirements)
    trace = live.trace()
    if trace is not None:
        verdicts += judge_so_far(live.scene, trace, scenes.loaded.registry)
    return [
        f"{_STATES[v.satisfied]}  {v.name}  {v.robustness:.2f}"
        for v in verdicts
        if v.robustness is not None
    ]


_STATES = {True: "satisfied", False: "VIOLATED", None: "unknown"}
