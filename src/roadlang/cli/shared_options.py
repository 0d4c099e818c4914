"""Options that several commands have: each means the same in all of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

import click

from ..plugins.program_environment import one_thread_for_opencv
from .finite_range import Seed, WholeNumber
from .output_files import OutputPath
from .quantities import seconds

Command: TypeAlias = Callable[..., Any]


def output(default: str) -> Callable[[Command], Command]:
    """`-o DIR`. Commands have folders of their own, as none writes where another has written; those
    of drives and searches lie within the one of `compile`."""
    return click.option(
        "-o",
        "--output",
        "folder",
        default=default,
        show_default=True,
        metavar="DIR",
        type=OutputPath(),
        help="Output folder.",
    )


count = click.option(
    "-n",
    "count",
    type=WholeNumber(min=1, max=1_000_000),
    help="Number of scenes; by default 1, or all of a grid.",
)
seed = click.option("--seed", type=Seed(), default=0, show_default=True, help="Random seed.")


def _one_thread_each(_: click.Context, __: click.Parameter, value: int) -> int:
    """Several processes need no threads of OpenCV; a process without threads can be forked, one
    with them cannot."""
    if value > 1:
        one_thread_for_opencv()
    return value


jobs = click.option(
    "--jobs",
    callback=_one_thread_each,
    type=WholeNumber(min=1, max=256),
    default=1,
    show_default=True,
    help="Number of worker processes; does not change the result.",
)
cluster = click.option(
    "--cluster",
    metavar="ADDRESS",
    help="Scheduler of a running Dask cluster to work on, such as tcp://10.0.0.5:8786.",
)
settings = click.option(
    "--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set the value of a param."
)
params = click.option(
    "--params",
    metavar="FILE.yaml",
    help="YAML file with values of params; a list of maps gives several runs.",
)
engine = click.option("--engine", help="Simulator, instead of the file's `simulate with`.")
duration = click.option(
    "--duration", type=seconds(min=0.1), help="Maximum duration of a drive, such as 60s."
)


def _listed(_: click.Context, __: click.Parameter, values: tuple[str, ...]) -> str | None:
    """As one list; None where the option is not given."""
    return ",".join(values) if values else None


def _emit(help: str) -> Callable[[Command], Command]:
    return click.option("--emit", metavar="KIND,...", multiple=True, callback=_listed, help=help)


emit = _emit("Outputs, instead of the file's `emit`s: `json,svg{size: 800px}`.")
emit_of_drives = _emit(
    "Files to write for each drive, instead of the file's `emit`s: `openscenario`."
)
