"""`roadlang godot`: the bundled simulator, started for a client to connect to."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from roadlang.commands import WholeNumber, echo
from roadlang_godot.usual_port import USUAL_PORT

if TYPE_CHECKING:
    from pathlib import Path


@click.command("godot")
@click.option("--headless", is_flag=True, help="Run without a window.")
@click.option("--host", default="127.0.0.1", show_default=True, help="Address to listen on.")
@click.option(
    "--port",
    type=WholeNumber(1, 65535),
    default=USUAL_PORT,
    show_default=True,
    help="Port to listen on.",
)
@click.option(
    "--transport",
    type=click.Choice(["udp", "websocket"]),
    default="udp",
    show_default=True,
    help="Protocol.",
)
@click.option("--where", is_flag=True, help="Print the paths of Godot and the project, and exit.")
@click.option(
    "--addon",
    type=click.Path(exists=True, file_okay=False),
    metavar="PROJECT",
    help="Copy roadlang into the folder of a Godot project, as `addons/roadlang`, and exit.",
)
def command(
    headless: bool, host: str, port: int, transport: str, where: bool, addon: str | None
) -> None:
    """Start Godot with the bundled project, in which scenes are built and driven.

    It receives scenes from `emit godot`, `roadlang watch` and `roadlang run`. It listens only on
    this machine, unless --host is given.
    """
    from pathlib import Path

    from roadlang_godot.engines import engine

    if addon is not None:
        _install(Path(addon))
        return
    if where:
        found = engine.find()
        echo(f"engine   {found}")
        echo(f"version  {engine.version_of(found)}")
        echo(f"project  {engine.project()}")
        return
    engine.version_of(engine.find())
    running = engine.start(
        window=not headless, host=host, port=port, transport=transport, quit_idle=None
    )
    with running:
        echo(f"Godot listens on {host}:{running.port} ({transport}); Ctrl-C stops it")
        running.process.wait()


def _install(folder: Path) -> None:
    from roadlang.commands import Code, DiagnosticError, diagnose
    from roadlang_godot.engines import addon

    if not addon.is_project(folder):
        reason = f"`{folder}` is not a Godot project: it has no file `project.godot`"
        raise click.BadParameter(reason, param_hint="--addon")
    if addon.is_foreign(folder):
        reason = f"`{folder / addon.FOLDER}` is something else: move it away first"
        raise click.BadParameter(reason, param_hint="--addon")
    try:
        place = addon.install_addon(folder)
    except OSError as error:
        path = folder / addon.FOLDER
        raise DiagnosticError(
            diagnose(Code.OUTPUT_NOT_WRITTEN, file=path, reason=error.strerror or error)
        ) from error
    echo(f"{place}: put a `RoadlangStage` into a scene, and run it")
