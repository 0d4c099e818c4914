"""Checks a scene file and lowers it to the scenario: all errors in one run, each said once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from ..diagnostics import Code, Diagnostic, Source
from ..diagnostics.diagnostic import in_order
from ..ir.paused_collector import collector_paused
from ..ir.scenario import Scenario
from ..plugins.registry import Registry
from .checker import Checker
from .infer.definitions import define
from .infer.name_warnings import warn
from .infer.rule_table import RULES
from .lower.scenario import lower
from .lower.written_size import report_oversized
from .names.formula_size import drop_large_formulas
from .names.including import load
from .names.nesting import report_nesting
from .names.program import Program
from .outputs import add_outputs, select_outputs, with_advice


def check_text(
    text: str,
    path: Path,
    overrides: Mapping[str, str | Source],
    registry: Registry,
    outputs: Sequence[str] | None = None,
) -> tuple[Scenario | None, list[Diagnostic]]:
    """The scenario of a scene file, or None where there are errors, and all diagnostics in order.

    The text need not be saved; files that it names are relative to the folder of `path`.
    `overrides` are values of params by name, as written after `--set name=`. `outputs` (`json`,
    `svg { size: 800px }`) come in the place of the file's `emit`s.
    """
    with collector_paused():
        return _check(load(path, text, overrides), registry, outputs)


def _check(
    program: Program, registry: Registry, outputs: Sequence[str] | None
) -> tuple[Scenario | None, list[Diagnostic]]:
    if outputs is not None:
        add_outputs(program, outputs)
    drop_large_formulas(program)
    report_nesting(program)
    checker = Checker(program, registry, RULES, define)
    try:
        scenario = lower(checker)
        report_oversized(checker, scenario)
    except RecursionError:
        # What is left are circles of hundreds of definitions.
        if not any(found.code == Code.NESTING_TOO_DEEP for found in checker.diagnostics):
            checker.report(Code.NESTING_TOO_DEEP, program.source.span(0, 0))
        return None, in_order(checker.diagnostics)
    if not checker.has_errors:
        warn(checker)
    found = in_order(checker.diagnostics)
    if outputs is not None:
        scenario = replace(scenario, emits=select_outputs(scenario.emits, outputs))
        found = [with_advice(diagnostic) for diagnostic in found]
    return (None if checker.has_errors else scenario), found
