"""`roadlang mine FORMULA --param NAME=LOW..HIGH TRACE...`: the tightest that still holds."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click

from ..diagnostics import DiagnosticError
from .console import echo, report
from .finite_range import FiniteNumber, WholeNumber
from .read_traces import refuse_swapped

if TYPE_CHECKING:
    from ..stl.explain.mining import Mined
    from ..stl.explain.parameters import Parameter


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
    "--margin",
    type=FiniteNumber(),
    help="Minimum robustness; by default the formula only has to hold.",
)
@click.option(
    "--digits",
    type=WholeNumber(1, 12),
    default=6,
    help="Significant digits of the result, no finer than 1e-12 of the bounds.",
)
@click.option(
    "--agent", help="Agent of a trace of `roadlang run` whose signals need no prefix: `speed`."
)
@click.option(
    "--unknown-holds",
    is_flag=True,
    help="Count a TRACE that could still satisfy FORMULA, if it continued, as satisfying it.",
)
@click.option(
    "--front",
    type=WholeNumber(2, 1000),
    metavar="POINTS",
    help="List the Pareto front: for each of POINTS values of the first parameter the tightest of "
    "the others.",
)
@click.option("--json", "as_json", is_flag=True, help="Print the result as JSON.")
def command(
    formula: str,
    traces: tuple[str, ...],
    bounds: tuple[str, ...],
    agent: str | None,
    front: int | None,
    as_json: bool,
    **how: Any,
) -> None:
    """Find the tightest parameters with which FORMULA holds on every TRACE.

    For example `roadlang mine "always (e < limit)" --param limit=0..20 drive.csv`, or for an
    interval `roadlang mine "eventually[0, tau] (e < 1)" --param tau=0..60 drive.csv`.
    """
    refuse_swapped(formula)
    parameters = [_parameter(text) for text in bounds]
    names = [parameter.name for parameter in parameters]
    if twice := {name for name in names if names.count(name) > 1}:
        raise click.UsageError(f"--param {min(twice)} is given twice")
    if front and len(parameters) < 2:
        raise click.UsageError("--front needs two parameters or more")
    mined, digits = _mined(formula, parameters, traces, agent, front, how), how["digits"]
    _warn(mined)
    if as_json:
        found = [_document(point) for point in mined]
        echo(json.dumps(found if front else found[0], indent=2))
    elif front:
        for point in mined:
            echo("  ".join(f"{name} = {value:.{digits}g}" for name, value in point.values.items()))
    else:
        for name, value in mined[0].values.items():
            note = "  (the end of its bounds)" if name in mined[0].at_bound else ""
            echo(f"{name} = {value:.{digits}g}{note}")
        echo(f"{mined[0].formula}  {_found(how)} on every trace")


def _found(how: Mapping[str, Any]) -> str:
    """What is known of the formula: with a margin of 0 or less it need not hold."""
    has, holds = "has", "holds"
    if how["unknown_holds"]:
        has, holds = "has, or can still get,", "holds, or can still hold,"
    return holds if how["margin"] is None else f"{has} a robustness of {how['margin']:g} or more"


def _mined(
    formula: str,
    parameters: Sequence[Parameter],
    traces: Sequence[str],
    agent: str | None,
    front: int | None,
    how: Mapping[str, Any],
) -> Sequence[Mined]:
    """Raises DiagnosticError, which names the trace that it is about."""
    from ..stl.explain.mining import RecordingError, mine, mine_front
    from ..stl.formats.column_units import check_units
    from .read_traces import naming, read_samples
    from .trace_dimensions import check_dimensions

    check_units(formula, traces)
    check_dimensions(formula, traces)
    recordings = [read_samples(path, agent)[1:] for path in traces]
    try:
        if front:
            return mine_front(formula, parameters, recordings, points=front, **how)
        return (mine(formula, parameters, recordings, **how),)
    except RecordingError as error:
        named = naming(traces[error.recording], error.diagnostics)
        raise DiagnosticError(*named) from None


def _warn(mined: Sequence[Mined]) -> None:
    from ..diagnostics import Code, diagnose

    names = dict.fromkeys(name for point in mined for name in point.not_monotone)
    report(diagnose(Code.NOT_MONOTONE, None, name=name) for name in names)


def _document(mined: Mined) -> dict[str, Any]:
    return {
        "values": dict(mined.values),
        "formula": str(mined.formula),
        "robustness": mined.rho if abs(mined.rho) != float("inf") else str(mined.rho),
        "at_bound": list(mined.at_bound),
        "not_monotone": list(mined.not_monotone),
    }


def _parameter(text: str) -> Parameter:
    from ..stl.explain.parameters import Parameter

    name, _, bounds = text.partition("=")
    low, _, high = bounds.partition("..")
    try:
        return Parameter(name.strip(), float(low), float(high))
    except ValueError:
        raise click.UsageError(
            f"--param {text}: write NAME=LOW..HIGH with two numbers without units"
        ) from None
