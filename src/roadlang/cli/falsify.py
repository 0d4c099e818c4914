"""`roadlang falsify FILE`: a search for scenes that violate an expectation."""

from __future__ import annotations

import json
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..session.params import parse_overrides
from . import exit_codes, shared_options
from .console import counted, echo, note, report, shown, style
from .finite_range import FiniteRange, WholeNumber
from .quantities import seconds

if TYPE_CHECKING:
    from ..session.falsification import Failure, Falsification

_SHOWN = 10
"""Failures that are listed on the terminal."""
_FIGURES = 25
"""Failures that are drawn: of hundreds, figures take a fifth as long as the search."""


@click.command("falsify")
@click.argument("file")
@shared_options.output("out/search")
@click.option(
    "--expect",
    "expects",
    multiple=True,
    metavar="NAME",
    help="An expectation to violate, the most important first; by default all.",
)
@click.option("--with", "searcher", metavar="KIND", help="Searcher, instead of the file's.")
@click.option("--evaluations", type=WholeNumber(min=1), help="Stop after this many candidates.")
@click.option("--failures", type=WholeNumber(min=1), help="Stop after this many distinct failures.")
@click.option(
    "--seconds", type=seconds(min=0, min_open=True), help="Stop after this time, such as 10min."
)
@click.option(
    "--batch", type=WholeNumber(min=1), help="Maximum number of candidates evaluated together."
)
@click.option(
    "--islands", type=WholeNumber(min=1), help="Number of independent searches side by side."
)
@click.option("--random", type=FiniteRange(0, 1), help="Fraction of candidates drawn at random.")
@shared_options.engine
@shared_options.duration
@shared_options.seed
@shared_options.jobs
@shared_options.cluster
@shared_options.settings
@click.option(
    "--figures",
    type=WholeNumber(min=0),
    default=_FIGURES,
    show_default=True,
    help="Number of failures to draw, worst first.",
)
@click.option("--resume", is_flag=True, help="Continue from the journal in DIR.")
@click.option("--json", "as_json", is_flag=True, help="Print the summary as JSON.")
def command(
    file: str,
    folder: str,
    settings: tuple[str, ...],
    as_json: bool,
    expects: tuple[str, ...],
    duration: float | None,
    jobs: int,
    cluster: str | None,
    **options: Any,
) -> None:
    """Search the scenes of FILE that satisfy every `require` for some that violate an `expect`.

    DIR/failures has the distinct failures as scenes, worst first, which `roadlang run` drives
    again, with their traces, and figures of the worst; DIR/failing.csv and safe.csv have a row for
    every scene that was driven, summary.json the failure rate and what was covered. Finished work
    is kept in DIR/journal.jsonl: `--resume` continues after an interruption, or with more
    evaluations. Options override those of the file's `falsify`. The exit code is 4 if there is a
    failure, 3 if no scene satisfies the requirements.
    """
    from ..session.cluster import cluster as workers_of
    from ..session.loading import load
    from .deferred_modules import defer_parts_of_numpy
    from .progress import ProgressBar

    defer_parts_of_numpy()
    target = Path(folder).absolute()  # before a plugin can change the current folder
    figures: int = options.pop("figures")
    loaded = load(file).with_params(parse_overrides(settings))
    _ = loaded.scenario  # raises what is wrong with the file, with its warnings
    report(loaded.check())
    with workers_of(cluster, jobs) as workers, ProgressBar("evaluations") as progress:
        search = loaded.falsify(
            expects or None,
            options={} if duration is None else {"duration": duration},
            jobs=workers.jobs,
            executor=workers.executor,
            folder=target,
            progress=progress,
            **options,
        )
    search.write(target, figures)
    _print(search, target, as_json)
    _note_figures(search, target, figures)
    click.get_current_context().exit(_exit_code(search))


def _exit_code(search: Falsification) -> int:
    if search.failures:
        return exit_codes.EXPECTATION_VIOLATED
    return exit_codes.DONE if search.driven else exit_codes.NO_SCENE


def _print(search: Falsification, target: Path, as_json: bool) -> None:
    from ..diagnostics import Code, diagnose
    from ..search.rejection_report import as_text
    from ..session.falsification_files import summary

    report(search.diagnostics)
    if as_json:
        click.echo(json.dumps(summary(search), indent=2))
        return
    for failure in search.failures[:_SHOWN]:
        echo(_line(failure))
    more = len(search.failures) - _SHOWN
    if more > 0:
        echo(f"  ... and {more} more")
    if not search.driven:
        tried, file = f"{len(search.outcomes):,}", str(search.loaded.path)
        rejections = search.rejections
        help_ = (
            () if rejections else f"`roadlang compile {shlex.quote(file)}` shows what rejects them"
        )
        report([diagnose(Code.NO_SCENE_FOUND, path=file, tried=tried, help=help_)])
        if rejections:
            note(f"\n{as_text(rejections, len(search.outcomes))}")
    failing = sum(outcome.is_failure for outcome in search.driven)
    echo(
        f"{len(search.failures)} distinct of {counted(failing, 'failure')} in"
        f" {counted(len(search.driven), 'scene')} of"
        f" {counted(len(search.outcomes), 'evaluation')}; in {shown(target)}"
    )
    rate = search.rate
    if rate.scenes:
        echo(
            f"{rate.low:.2%} to {rate.high:.2%} of random scenes fail"
            f" (95% confidence, {rate.failures} of {rate.scenes})"
        )


def _note_figures(search: Falsification, target: Path, figures: int) -> None:
    from ..ir.result_files import FAILURES, SCENE, numbered_stem

    if figures < len(search.failures):
        other = shown(target / FAILURES / f"{numbered_stem(figures + 1)}{SCENE}")
        drawn = f"figures of the {figures} worst failures" if figures else "no figures"
        note(f"{drawn}: `--figures N` draws more, `roadlang run {other} -o DIR` a single one")


def _line(failure: Failure) -> str:
    name = failure.outcome.violated[0]
    robustness = failure.robustness[name]
    rho = "" if robustness is None else f" {robustness:.3g}"
    moment = failure.outcome.moment
    place = ""
    if moment is not None:
        place = f", first at {moment.time:.1f} s"
        place += "" if moment.station is None else f", s = {moment.station:.0f} m"
        place += f" ({moment.place})" if moment.place else ""
        place += f", {moment.partner}" if moment.partner else ""
    for failed in failure.outcome.controller_failures[:1]:
        place += f"; controller of {failed.agent} failed at {failed.time:.1f} s: {failed.summary}"
    word = style("violated", fg="red")
    return f"  {word}  failures/{failure.rank:04d}.json  {name}{rho}{place}"
