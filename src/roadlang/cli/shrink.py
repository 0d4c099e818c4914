"""`roadlang shrink FAILURE.json`: the simplest scene that still fails."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from .console import echo, shown, style
from .output_files import OutputPath

if TYPE_CHECKING:
    from ..session.falsification import Failure


@click.command("shrink")
@click.argument("failure", metavar="FAILURE.json")
@click.option("--file", "scene_file", metavar="FILE", help="The scene file, if it was moved.")
@click.option(
    "-o",
    "--output",
    "target",
    type=OutputPath(dir_okay=False),
    metavar="FILE",
    help="The scene; by default FAILURE.shrunk.json.",
)
def command(failure: str, scene_file: str | None, target: str | None) -> None:
    """Write the simplest scene that still fails as FAILURE.json does.

    FAILURE.json is a scene that `roadlang falsify` wrote (failures/0001.json), or one of `roadlang
    run` that violates an expectation. Its random values are set to their simplest values, one
    after the other, or moved halfway toward them, as long as the same expectation stays violated.
    What remains is what the failure depends on.
    """
    from ..session.failure_files import failure_in
    from ..session.failure_findings import write_shrunk

    found = failure_in(failure, scene_file)
    simple = found.shrink()
    written = write_shrunk(simple, Path(failure), None if target is None else Path(target))
    _print(found, simple)
    echo(f"written to {shown(written)}; `roadlang run` drives it")


def _print(found: Failure, simple: Failure) -> None:
    from ..report.numbers import plain, quantity
    from ..session.failure_findings import reported_draws, unit_of

    name = found.outcome.violated[0]
    before, after = (
        plain(quantity(failure.robustness[name], unit_of(found))) for failure in (found, simple)
    )
    word = style("violated", fg="red")
    echo(f"{word}  {name}: robustness {after} (before: {before})")
    draws = reported_draws(simple)
    axes = len(simple.axes)
    if not draws:
        echo(f"it fails with all of its {axes} random values at their simplest")
        return
    echo(f"{axes - len(draws)} of {axes} random values are at their simplest; it needs")
    units = simple.scene.units
    for draw in draws:
        value = simple.outcome.draws.get(draw)
        text = "" if value is None else f" = {_value(value, units.get(draw, ''))}"
        echo(f"  {draw}{text}")


def _value(value: object, unit: str) -> str:
    from ..report.numbers import plain, quantity

    return plain(quantity(float(value), unit)) if isinstance(value, int | float) else str(value)
