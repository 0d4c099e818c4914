"""`roadlang monitor FORMULA TRACE...`: judge recorded traces by an STL formula."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click

from . import exit_codes
from .console import echo, report
from .output_files import FormatFile
from .quantities import meters
from .read_traces import judging, read_samples, refuse_swapped
from .short_numbers import short_numbers

if TYPE_CHECKING:
    from ..stl import Formula
    from ..stl.formats.trace_files import Columns
    from ..stl.formula.evaluation_options import Measure, Semantics


@click.command("monitor")
@click.argument("formula", metavar="FORMULA")
@click.argument("traces", nargs=-1, required=True, metavar="TRACE...")
@click.option(
    "--agent", help="Agent of a trace of `roadlang run` whose signals need no prefix: `speed`."
)
@click.option("--json", "as_json", is_flag=True, help="Print the results as JSON.")
@click.option(
    "--plot",
    type=FormatFile("SVG", ".svg"),
    metavar="OUT.svg",
    help="SVG file for a plot of the signals and the robustness.",
)
@click.option(
    "--wrap",
    type=meters(min=0, min_open=True),
    metavar="LENGTH",
    help="Length of the closed road that the traces go around.",
)
@click.option(
    "--open",
    "is_open",
    is_flag=True,
    help="The traces may continue: show the range over all continuations; the verdict is `unknown` "
    "if it depends on them. Without this option a trace is judged as it ended.",
)
@click.option(
    "--strict", is_flag=True, help="Count a vacuous verdict as a violation (exit code 4)."
)
@click.option(
    "--semantics",
    type=click.Choice(["sampled", "held", "linear"]),
    default="sampled",
    show_default=True,
    help="The value of a signal between two samples: none, that of the earlier sample, or on the "
    "line between both.",
)
@click.option(
    "--robustness",
    "measure",
    type=click.Choice(["space", "time", "time-left", "average"]),
    default="space",
    show_default=True,
    help="What robustness measures: how much signals may change (space), how far they may shift to "
    "later (time) or earlier times (time-left), or the change averaged over windows (average). The "
    "range is always that of space robustness.",
)
@click.option(
    "--follow",
    "following",
    is_flag=True,
    help="Read one TRACE (`-`: standard input) while it is being written; print a line whenever "
    "FORMULA starts or stops holding.",
)
def command(
    formula: str,
    traces: tuple[str, ...],
    following: bool,
    plot: str | None,
    as_json: bool,
    **how: Any,
) -> None:
    """Evaluate FORMULA on each TRACE (CSV with the positions in the first column, or JSON).

    In traces of `roadlang run` the signals are `ego.speed` and so on; those of --agent, or of the
    only agent, are also called `speed`. Numbers are in the units of the trace unless they have a
    unit: `always[0, 5] (x < 1.5)`. The exit code is 4 if a trace violates the formula. A verdict is
    vacuous if it depends on a window that holds no sample. A trace counts as finished: `always p`
    holds if p holds to the end. See --open.

    The JSON of one TRACE is an object with formula, robustness (at the start), range, verdict,
    positions, trace (the robustness at each position) and explanation; of several it is a list of
    these. Infinities are the strings "inf" and "-inf".
    """
    refuse_swapped(formula)
    _refuse_combinations(traces, following, plot, as_json, how)
    from ..stl import parse
    from ..stl.formats.column_units import check_units
    from .trace_dimensions import check_dimensions

    parsed, files = parse(formula), [path for path in traces if path != "-"]
    check_units(formula, files)
    check_dimensions(formula, files)
    if following:
        from .follow import follow

        failed = follow(parsed, traces[0])
        code = exit_codes.EXPECTATION_VIOLATED if failed else exit_codes.DONE
        click.get_current_context().exit(code)
    columns = [(path, read_samples(path, how["agent"])) for path in traces]
    findings = [_judged(parsed, trace, path, plot, how) for path, trace in columns]
    _show(parsed, findings, as_json, how["is_open"])
    failing = ("violated", "vacuous") if how["strict"] else ("violated",)
    broken = any(finding["verdict"] in failing for finding in findings)
    click.get_current_context().exit(exit_codes.EXPECTATION_VIOLATED if broken else exit_codes.DONE)


def _refuse_combinations(
    traces: tuple[str, ...], following: bool, plot: str | None, as_json: bool, how: dict[str, Any]
) -> None:
    """UsageError for options that do not go together."""
    dense, measure = how["semantics"], how["measure"]
    if "-" in traces and not following:
        raise click.UsageError("`-` (standard input) needs --follow")
    if plot and len(traces) > 1:
        raise click.UsageError("--plot draws one trace; several were given")
    if dense != "sampled" and (plot or following or how["wrap"]):
        raise click.UsageError(
            f"--semantics {dense} cannot be used with --plot, --wrap or --follow"
        )
    if measure != "space" and (dense != "sampled" or plot or following or how["wrap"]):
        problem = "cannot be used with --semantics, --plot, --wrap or --follow"
        raise click.UsageError(f"--robustness {measure} {problem}")
    others = (how["agent"], how["wrap"], how["strict"], how["is_open"], plot, as_json)
    if following and (len(traces) > 1 or any(others)):
        raise click.UsageError("--follow takes one TRACE and no other option")


def _judged(
    formula: Formula, columns: Columns, path: str, plot: str | None, how: dict[str, Any]
) -> dict[str, Any]:
    with judging(path, columns[0]):
        if how["semantics"] != "sampled":
            return _dense_finding(formula, columns, path, how)
        finding = _finding(formula, columns, path, plot, how)
        if how["measure"] != "space":
            finding |= _measured(formula, columns, how["measure"])
        return finding


def _show(formula: Formula, findings: list[dict[str, Any]], as_json: bool, is_open: bool) -> None:
    if as_json:
        echo(json.dumps(findings[0] if len(findings) == 1 else findings, indent=2))
    else:
        echo(short_numbers(str(formula)))
        echo(_table(findings, is_open))
    for finding in findings:
        _warn_of_empty_windows(finding)


def _finding(
    formula: Formula, columns: Columns, path: str, plot: str | None, how: dict[str, Any]
) -> dict[str, Any]:
    axis, positions, signals = columns
    wrap: float | None = how["wrap"]
    why = formula.explain(positions, signals, wrap=wrap, finished=not how["is_open"])
    explanation = why.to_json()
    if plot:
        from ..files.writing import write_file
        from ..stl.explain.plot import plot_svg

        drawn = plot_svg(formula, positions, signals, axis=axis, wrap=wrap)
        write_file(Path(plot), drawn)
    trace = _shown(formula.robustness(positions, signals, wrap=wrap).tolist())
    return {
        "file": path,
        "formula": str(formula),
        "robustness": explanation["rho"],
        "range": explanation["range"],
        "verdict": why.verdict,
        "positions": positions,
        "trace": trace,
        "explanation": explanation,
        "lines": why.lines(),
    }


def _measured(formula: Formula, columns: Columns, measure: str) -> dict[str, Any]:
    """Robustness by another measure."""
    from ..stl.evaluate.measured_robustness import measured_robustness
    from ..stl.formula.evaluation_options import EvaluationOptions

    _, positions, signals = columns
    options = EvaluationOptions(robustness=cast("Measure", measure.replace("-", "_")))
    shown = _shown(measured_robustness(formula, positions, signals, options).tolist())
    return {"measure": measure, "robustness": shown[0], "trace": shown}


def _shown(values: list[float]) -> list[float | str]:
    """As JSON has them: infinities are texts."""
    return [value if abs(value) != float("inf") else str(value) for value in values]


def _dense_finding(
    formula: Formula, columns: Columns, path: str, how: dict[str, Any]
) -> dict[str, Any]:
    """No window falls between two samples."""
    from ..stl.dense.observed_rates import observed_sampling_error

    _, positions, signals = columns
    semantics: Semantics = how["semantics"]
    trace = formula.robustness(positions, signals, semantics=semantics)
    finished = not how["is_open"]
    why = formula.explain(positions, signals, semantics=semantics, finished=finished)
    explanation = why.to_json()
    error = observed_sampling_error(formula, positions, signals, semantics)
    shown = _shown(trace.tolist())
    lines = [] if error is None else [f"sampling error at most {error:.6g}, {_ASSUMPTION}"]
    return {
        "file": path,
        "formula": str(formula),
        "semantics": semantics,
        "robustness": shown[0],
        "range": explanation["range"],
        "verdict": why.verdict,
        "sampling_error": error,
        "positions": positions,
        "trace": shown,
        "explanation": explanation,
        "lines": [*why.lines(), *lines],
    }


_ASSUMPTION = "if no signal changes faster than between two neighboring samples"


def _warn_of_empty_windows(finding: dict[str, Any]) -> None:
    from ..diagnostics import Code, diagnose

    name, why = f"`{Path(finding['file']).name}`", finding["explanation"]
    kinds = (
        (Code.WINDOW_BETWEEN_SAMPLES, why["between_samples"]),
        (Code.WINDOWS_BEYOND_END, why["beyond_end"]),
    )
    report(diagnose(code, None, formula=f, trace=name) for code, found in kinds for f in found)


def _table(findings: list[dict[str, Any]], is_open: bool) -> str:
    """One row per trace, and under each what decides and where the formula fails."""
    head = ("trace", "verdict", "robustness", "range")[: 4 if is_open else 3]
    rows = [
        (
            Path(finding["file"]).name,
            finding["verdict"],
            _short(finding["robustness"]),
            "[{}, {}]".format(*map(_short, finding["range"])),
        )[: len(head)]
        for finding in findings
    ]
    widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]

    def line(cells: tuple[str, ...]) -> str:
        return "  ".join(c.ljust(w) for c, w in zip(cells, widths, strict=True)).rstrip()

    lines = [line(head)]
    for row, finding in zip(rows, findings, strict=True):
        lines.append(line(row))
        lines += [f"  {short_numbers(line)}" for line in finding["lines"][1:]]
    return "\n".join(lines)


def _short(value: float | str) -> str:
    return value if isinstance(value, str) else f"{value + 0.0:.6g}"  # -0.0 is 0
