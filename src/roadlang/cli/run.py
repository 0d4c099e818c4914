"""`roadlang run FILE`: scenes are driven, and every `expect` is judged on what happened."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..diagnostics import Code, DiagnosticError, diagnose, did_you_mean
from . import exit_codes
from .console import paint, report, say
from .scene_files import parse_overrides

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..ir.scene import Scene, Verdict
    from ..ir.trace import Trace
    from ..plugins.kinds import Simulator
    from ..plugins.registry import KindEntry
    from .made_scenes import MadeScenes


@click.command("run")
@click.argument("file")
@click.option("--engine", help="Where to drive, instead of the file's `simulate with`: `godot`.")
@click.option("-o", "--output", "folder", default="out", show_default=True, metavar="DIR")
@click.option("-n", "count", type=click.IntRange(min=1), help="How many scenes.")
@click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True)
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set a param.")
@click.option("--duration", type=click.FloatRange(min=0.1), help="Seconds at most.")
@click.option("--window", is_flag=True, help="Show the drive in a window, in real time.")
@click.option("--json", "as_json", is_flag=True, help="Print the verdicts as JSON.")
def command(  # noqa: PLR0913 - one parameter per option
    file: str,
    engine: str | None,
    folder: str,
    count: int | None,
    seed: int,
    settings: tuple[str, ...],
    duration: float | None,
    window: bool,
    as_json: bool,
) -> None:
    """Make scenes of FILE, drive each, judge its expectations, and write the traces to DIR.

    The exit code is 4 where an expectation is broken, and 5 where the engine failed.
    """
    from .made_scenes import make_scenes

    made = make_scenes(file, parse_overrides(settings), count, seed)
    report(made.warnings)
    changes: dict[str, Any] = {}
    if duration is not None:
        changes["duration"] = duration
    if window:
        changes["headless"] = False
    simulator, entry = simulator_of(made, engine, changes)
    driven = _driven(simulator, entry, made)
    _write(Path(folder), driven)
    if as_json:
        click.echo(
            json.dumps([_record(scene, verdicts) for scene, _, verdicts in driven], indent=2)
        )
    else:
        for scene, trace, verdicts in driven:
            _print(scene, trace, verdicts)
    broken = any(v.satisfied is False for _, _, verdicts in driven for v in verdicts)
    code = exit_codes.EXPECTATION_BROKEN if broken else exit_codes.DONE
    click.get_current_context().exit(code)


def simulator_of(
    made: MadeScenes, engine: str | None, changes: dict[str, Any]
) -> tuple[Simulator, KindEntry]:
    """The simulator that the command line or the file names, with the file's options."""
    from ..plugins.guard import plugin_guard

    call = made.scenes[0].simulate
    names = made.registry.names("simulate")
    name = engine or (call.kind if call is not None else names[0])
    if not made.registry.has("simulate", name):
        hints = did_you_mean(name, names) or (f"there are {', '.join(names)}",)
        raise DiagnosticError(diagnose(Code.UNKNOWN_CHOICE, what="engine", name=name, help=hints))
    entry = made.registry.find_recorded("simulate", name)
    with plugin_guard(entry, None):
        kind: Any = entry.load()
    options = dict(call.options) if call is not None and call.kind == name else {}
    known = {field.name for field in dataclasses.fields(kind)}
    options |= {key: value for key, value in changes.items() if key in known}
    with plugin_guard(entry, None):
        simulator: Simulator = kind(**options)
    return simulator, entry


def _driven(
    simulator: Simulator, entry: KindEntry, made: MadeScenes
) -> list[tuple[Scene, Trace, tuple[Verdict, ...]]]:
    from ..drive.controllers import python_controllers
    from ..ir.trace import Trace
    from ..judging.drives import judge
    from ..plugins.guard import plugin_guard, wrong_result

    controllers = [python_controllers(scene, made.registry) for scene in made.scenes]
    with plugin_guard(entry, None):
        traces = list(simulator.drive_all(made.scenes, controllers))
    for trace in traces:
        if not isinstance(trace, Trace):
            raise wrong_result(entry, None, f"gave a {type(trace).__name__}, not a Trace")
    return [
        (scene, trace, judge(scene, trace, made.registry))
        for scene, trace in zip(made.scenes, traces, strict=True)
    ]


def _write(folder: Path, driven: Sequence[tuple[Scene, Trace, tuple[Verdict, ...]]]) -> None:
    from ..drive.trace_files import to_csv, to_json
    from ..scenes.writing import write_all

    files: dict[str, bytes] = {}
    for scene, trace, verdicts in driven:
        stem = f"scene-{scene.index:04d}"
        files[f"{stem}.trace.csv"] = to_csv(trace).encode()
        files[f"{stem}.trace.json"] = to_json(trace).encode()
        record = json.dumps(_record(scene, verdicts), indent=2) + "\n"
        files[f"{stem}.verdicts.json"] = record.encode()
    write_all(folder, files)


def _record(scene: Scene, verdicts: Sequence[Verdict]) -> dict[str, Any]:
    return {
        "scene": scene.index,
        "name": scene.name,
        "expectations": [
            {"name": v.name, "text": v.text, "robustness": v.robustness, "satisfied": v.satisfied}
            for v in verdicts
        ],
    }


def _print(scene: Scene, trace: Trace, verdicts: Sequence[Verdict]) -> None:
    took = f"{trace.time[-1]:.1f} s" if len(trace.time) else "no time"
    say(f"scene {scene.index}: {took} driven in {trace.engine}")
    for verdict in verdicts:
        good = verdict.satisfied
        word = paint("holds ", "32") if good else paint("broken", "31")
        if good is None:
            word = "not judged"
        rho = "" if verdict.robustness is None else f"  robustness {verdict.robustness:.3g}"
        say(f"  {word}  {verdict.name}: {verdict.text}{rho}")
