"""The `roadlang` command: runs a command and turns whatever happens into words and an exit code."""

from __future__ import annotations

import contextlib
import gc
import io
import os
import sys
from collections.abc import Iterator, Sequence

import click

from ..plugins.entry_points import BLOCKED_VARIABLE
from ..plugins.termination import (
    Terminated,
    end_on_sigterm,
    raise_if_terminated,
    stop_noticing_sigterm,
)
from ..plugins.tracebacks import VARIABLE
from ..version import __version__
from . import exit_codes
from .commands import LazyGroup
from .standard_output import claim_standard_output, open_closed_streams

_COLLECTED_AFTER = (400_000, 20, 100)
"""Thresholds of the garbage collector, above its defaults: most objects of a command live until it
ends, so that frequent collections find nothing."""


@click.group(
    cls=LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="Exit codes: 0 done, 1 the scenario has errors, 2 usage error, 3 no scene satisfied the"
    " requirements, 4 an expectation is violated, 5 something else failed: engine, network,"
    " plugin or memory, 70 a bug in roadlang.",
)
@click.version_option(__version__, "-V", "--version", message="roadlang %(version)s")
@click.option(
    "--color",
    type=click.Choice(["auto", "always", "never"]),
    default="auto",
    help="When to print colors; `auto` follows the terminal and NO_COLOR.",
)
@click.option(
    "--no-plugin",
    multiple=True,
    metavar="NAME",
    is_eager=True,  # before the command is looked for: plugins bring commands
    expose_value=False,
    callback=lambda context, _, names: _leave_out(context, names),
    help="Do not load this plugin.",
)
@click.pass_context
def roadlang(context: click.Context, color: str) -> None:
    """A compiler for driving scenarios: from an image of a road to simulator-ready scenes."""
    context.meta["roadlang.color"] = color
    with contextlib.suppress(OSError):  # it may be gone
        context.meta["roadlang.folder"] = os.getcwd()  # before a plugin can change it


def _leave_out(context: click.Context, names: tuple[str, ...]) -> None:
    if names:
        context.with_resource(_plugins_refused(names))


@contextlib.contextmanager
def _plugins_refused(names: tuple[str, ...]) -> Iterator[None]:
    """Say so in the environment, where worker processes see it too."""
    before = os.environ.get(BLOCKED_VARIABLE)
    os.environ[BLOCKED_VARIABLE] = ",".join([*names, *([before] if before else [])])
    try:
        yield
    finally:
        if before is None:
            del os.environ[BLOCKED_VARIABLE]
        else:
            os.environ[BLOCKED_VARIABLE] = before


def main(arguments: Sequence[str] | None = None) -> None:
    """The console script."""
    _one_thread_for_matrices()
    gc.set_threshold(*_COLLECTED_AFTER)
    open_closed_streams()
    claim_standard_output()
    try:
        end_on_sigterm()
        code = run(arguments)
        raise_if_terminated()
        stop_noticing_sigterm()
    except Terminated:
        click.echo("stopped", err=True)
        _flush()
        # Everything of ours is cleaned up. Libraries may wait for their threads when Python ends:
        # whoever ends a process does not.
        os._exit(exit_codes.TERMINATED)
    _flush()
    gc.freeze()  # spares the last collection: the process ends now
    sys.exit(code)


def _one_thread_for_matrices() -> None:
    """Before numpy is imported: ours are small, for which threads cost more than they give, and
    sums would depend on how many cores there are. Workers have the same environment."""
    for library in ("OPENBLAS", "MKL"):
        os.environ.setdefault(f"{library}_NUM_THREADS", "1")


def _flush() -> None:
    with contextlib.suppress(OSError, ValueError):
        sys.stdout.flush()
        sys.stderr.flush()


def run(arguments: Sequence[str] | None = None) -> int:
    """Run a command line and return its exit code; bad input and bugs are both reported as text."""
    try:
        result = roadlang.main(arguments, prog_name="roadlang", standalone_mode=False)
        sys.stdout.flush()
        return result if isinstance(result, int) else exit_codes.DONE
    except click.ClickException as error:
        _show(error)
        return error.exit_code
    except (click.Abort, KeyboardInterrupt) as error:
        # click raises its own, which says nothing, from that of Python
        when = str(error.__cause__ if isinstance(error, click.Abort) else error)
        click.echo(f"interrupted {when}" if when.startswith("while ") else "interrupted", err=True)
        return exit_codes.INTERRUPTED
    except BrokenPipeError:
        _forget_standard_output()
        return exit_codes.PIPE_CLOSED
    except SystemExit as request:
        return request.code if isinstance(request.code, int) else int(request.code is not None)
    except Exception as error:  # noqa: BLE001 - a bug becomes RL900, never a traceback
        return _explain(error)


def _show(error: click.ClickException) -> None:
    """Print usage error to stderr; what was typed may hold control characters."""
    from .console import note

    text = io.StringIO()
    error.show(text)
    note(text.getvalue().rstrip())


def _explain(error: Exception) -> int:
    from ..diagnostics import DiagnosticError
    from .console import note, report

    if not isinstance(error, DiagnosticError):
        from .bug import describe_bug
        from .machine_faults import machine_fault

        if os.environ.get(VARIABLE):
            raise error
        if isinstance(error, OSError):
            _forget_standard_output()
        error = DiagnosticError(machine_fault(error) or describe_bug(error))
    report(error.diagnostics)
    if error.details:
        note(f"\n{error.details}")
    return exit_codes.exit_code_of(error.diagnostics) or exit_codes.SCENARIO_HAS_ERRORS


def _forget_standard_output() -> None:
    """Have what is still to be written to it go nowhere, where it cannot be written to."""
    try:
        sys.stdout.flush()
    except (OSError, ValueError):
        # Python flushes once more at exit, which would complain again.
        with contextlib.suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
