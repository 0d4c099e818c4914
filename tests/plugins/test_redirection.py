"""Code of plugins in several threads at once: standard output is everyone's own."""

from __future__ import annotations

import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

from roadlang.cli.console import echo
from roadlang.plugins.attribution import attributed

LONGEST = 60.0


def test_calls_of_plugins_that_overlap_in_two_threads_leave_standard_output_as_it_was(
    capsys: pytest.CaptureFixture[str],
) -> None:
    before = sys.stdout
    ours, theirs = attributed(), attributed()
    with ThreadPoolExecutor(1) as pool:
        pool.submit(theirs.__enter__).result(LONGEST)
        with ours:
            pool.submit(theirs.__exit__, None, None, None).result(LONGEST)
    assert sys.stdout is before
    echo("a result")
    assert capsys.readouterr() == ("a result\n", "")


def test_results_are_printed_while_another_thread_runs_a_plugin(
    capsys: pytest.CaptureFixture[str],
) -> None:
    plugin = attributed()
    with ThreadPoolExecutor(1) as pool:
        pool.submit(plugin.__enter__).result(LONGEST)
        echo("a result")
        pool.submit(print, "from the plugin").result(LONGEST)
        pool.submit(plugin.__exit__, None, None, None).result(LONGEST)
    assert capsys.readouterr() == ("a result\n", "from the plugin\n")


def test_nested_calls_of_plugins_print_to_standard_error(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with attributed():
        with attributed():
            sys.stdout.write("inside\n")
        sys.stdout.write("outside\n")
        echo("by echo")
    sys.stdout.write("after\n")
    assert capsys.readouterr() == ("after\n", "inside\noutside\nby echo\n")
