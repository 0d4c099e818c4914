"""`roadlang mine FORMULA --param NAME=LOW..HIGH TRACE...`: the tightest that still holds."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import click

from .console import echo

if TYPE_CHECKING:
    from ..stl.explain.mining import Parameter


@click.command("mine")
@click.argument("formula", metavar="FORMULA")
@click.argument("traces", nargs=-1, required=True, metavar="TRACE...")
@click.option(
    "--param",
    "bounds",
    multiple=True,
    required=True,
    metavar="NAME=LOW..HIGH",
    help="Parameter in FORMULA and its bounds; the first one is tightened first.",
)
@click.option(
    "--margin", type=float, help="Minimum robustness; by default the formula only has to hold."
)
@click.option(
    "--digits", type=click.IntRange(1, 12), default=6, help="Significant digits of the result."
)
@click.option(
    "--agent", help="Agent of a trace of `roadlang run` whose signals need no prefix: `speed`."
)
@click.option("--json", "as_json", is_flag=True, help="Print the result as JSON.")
def command(
    formula: str,
    traces: tuple[str, ...],
    bounds: tuple[str, ...],
    margin: float | None,
    digits: int,
    agent: str | None,
    as_json: bool,
) -> None:
    """Find the tightest parameters with which FORMULA holds on every TRACE.

    For example `roadlang mine "always (e < limit)" --param limit=0..20 drive.csv`, or for an
    interval `roadlang mine "eventually[0, tau] (e < 1)" --param tau=0..60 drive.csv`.
    """
    parameters = [_parameter(text) for text in bounds]
    from ..stl.explain.mining import mine
    from ..stl.formats.trace_files import read_trace

    recordings = [read_trace(path, agent)[1:] for path in traces]
    mined = mine(formula, parameters, recordings, margin=margin, digits=digits)
    if as_json:
        found = {
            "values": dict(mined.values),
            "formula": str(mined.formula),
            "robustness": mined.rho if abs(mined.rho) != float("inf") else str(mined.rho),
            "at_bound": list(mined.at_bound),
        }
        echo(json.dumps(found, indent=2))
        return
    for name, value in mined.values.items():
        note = "  (the end of its bounds)" if name in mined.at_bound else ""
        echo(f"{name} = {value:.{digits}g}{note}")
    echo(f"{mined.formula}  holds on every trace")


def _parameter(text: str) -> Parameter:
    from ..stl.explain.mining import Parameter

    name, _, bounds = text.partition("=")
    low, _, high = bounds.partition("..")
    try:
        return Parameter(name.strip(), float(low), float(high))
    except ValueError:
        raise click.UsageError(f"--param {text}: write NAME=LOW..HIGH with two numbers") from None
