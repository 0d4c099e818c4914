"""`roadlang watch FILE`: every save reaches the running simulator, which drives on meanwhile."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import click

from roadlang.commands import DiagnosticError, echo, report

if TYPE_CHECKING:
    from roadlang import LoadedScenario, SceneSet
    from roadlang_godot.live import LiveScene, Move
    from roadlang_godot.session import Session

LISTEN = 0.05
JUDGE_EVERY = 0.5


@click.command("watch")
@click.argument("file")
@click.option("--headless", is_flag=True, help="Start Godot without a window.")
@click.option("--host", help="Host of a running `roadlang godot` to use.")
@click.option(
    "--port",
    type=click.IntRange(1, 65535),
    default=4242,
    show_default=True,
    help="Port of that Godot.",
)
@click.option(
    "--road", type=click.Choice(["mesh", "tiles"]), default="mesh", help="How to build the road."
)
@click.option("--save", is_flag=True, help="Write what is moved in the window back to FILE.")
@click.option(
    "--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Random seed."
)
@click.option(
    "--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set the value of a param."
)
@click.option("--for", "seconds", type=float, help="Exit after this many seconds.")
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

    In the window, objects and road points can be dragged; robustness is shown live.
    """
    from roadlang import load
    from roadlang.commands import parse_overrides
    from roadlang_godot import engine

    loaded = load(file).with_params(parse_overrides(settings))
    scenes = loaded.sample(1, seed=seed)
    report(scenes.diagnostics)
    watcher = Watcher(loaded, seed, road, save)
    deadline = float("inf") if seconds is None else time.monotonic() + seconds
    if host is not None:
        with engine.connect(host, port, name=scenes[0].name) as session:
            watcher.run(session, scenes, deadline)
        return
    with engine.start(window=not headless) as running, running.connect() as session:
        watcher.run(session, scenes, deadline)


class Watcher:
    """Looks after one file and one simulator."""

    def __init__(self, loaded: LoadedScenario, seed: int, road: str, save: bool) -> None:
        self._loaded = loaded
        self._file = str(loaded.path)
        self._seed = seed
        self._road = road
        self._save = save
        self._text = loaded.text

    def run(self, session: Session, scenes: SceneSet, deadline: float) -> None:
        """Until the deadline, or Ctrl-C."""
        from roadlang_godot.live import LiveScene

        live = LiveScene(session, scenes[0].record, self._road)
        echo(f"{self._file} is driven; save it to change it, Ctrl-C to leave")
        judged = 0.0
        while time.monotonic() < deadline:
            for move in live.listen(LISTEN):
                self._take(move, live)
            self._look(live)
            if time.monotonic() - judged > JUDGE_EVERY:
                judged = time.monotonic()
                live.show(_lines(live, scenes))

    def _look(self, live: LiveScene) -> None:
        from roadlang.commands import read_scene_file

        try:
            text = read_scene_file(self._file)
        except DiagnosticError:
            # Editors that save by renaming leave a moment without a file.
            return
        if text != self._text:
            self._text = text
            self._change(live)

    def _change(self, live: LiveScene) -> None:
        try:
            began = time.monotonic()
            (scene,) = self._loaded.with_text(self._text).sample(1, seed=self._seed)
            compiled = time.monotonic()
            count = live.change(scene.record)
        except DiagnosticError as error:
            report(error.diagnostics)
            return
        sent = 1000 * (time.monotonic() - compiled)
        compiling = 1000 * (compiled - began)
        echo(f"{count} changes in {sent:.0f} ms, after {compiling:.0f} ms of compiling")

    def _take(self, move: Move, live: LiveScene) -> None:
        from roadlang.commands import object_moved, replace_file, waypoint_moved

        if not move.done:
            return
        if move.what == "object":
            text = object_moved(self._text, move.name, move.end)
        else:
            text = waypoint_moved(self._text, move.name, move.start, move.end)
        if text is None:
            echo(f"`{move.name}` is not placed by numbers in {self._file}: it stays")
            return
        self._text = text
        if self._save:
            replace_file(self._loaded.path, text)
        self._change(live)


def _lines(live: LiveScene, scenes: SceneSet) -> list[str]:
    """Robustness of every requirement, and of every expectation on what was driven lately."""
    from roadlang.commands import judge

    verdicts = list(live.scene.requirements)
    trace = live.trace()
    if trace is not None:
        verdicts += judge(live.scene, trace, scenes.loaded.registry).verdicts
    return [
        f"{'ok ' if v.satisfied else 'BROKEN '} {v.name}  {v.robustness:.2f}"
        for v in verdicts
        if v.robustness is not None
    ]
