"""Commands that plugins add: found, completed, listed, and named when they are broken or fail."""

from __future__ import annotations

import json
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest
from click.shell_completion import ShellComplete

from roadlang.cli.commands import COMMANDS
from roadlang.cli.main import roadlang, run
from roadlang.plugins.entry_points import command_candidates
from tests.plugins.installed import install, start

ROAD = "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] } }\n"
PLUGIN = '''
import click
from roadlang.api import hookimpl


@click.command("hello")
@click.argument("file")
@click.option("--loudly", is_flag=True)
def hello(file, loudly):
    """Greet the roads of FILE."""
    from roadlang import load
    from roadlang.commands import echo, exit_codes, report

    scenes = load(file).sample(1)
    report(scenes.diagnostics)
    for name in scenes[0].roads:
        echo(f"hello {name}" + "!" * loudly)
    click.get_current_context().exit(exit_codes.EXPECTATION_VIOLATED)


@click.command()
@click.argument("how")
def trip(how):
    """Go wrong in some way."""
    import sys
    from roadlang.commands import Diagnostic, DiagnosticError

    if how == "raise":
        return 1 // 0
    if how == "exit":
        sys.exit(7)
    if how == "diagnostic":
        raise DiagnosticError(Diagnostic("ACME01", "error", "there is no road to Acme"))
    raise click.UsageError("how indeed")


@click.group()
def many():
    """Several things."""


@many.command()
def one():
    """One of them."""
    raise RuntimeError("not today")


@click.command(hidden=True)
def secret():
    """Nobody is told."""
    click.echo("psst")


nothing = 3


@hookimpl
def roadlang_planned():
    return ["emit acme"]
'''
MODULE = "roadlang_acme"


@pytest.fixture
def acme(site: Path) -> Path:
    lines = [f"{name} = {MODULE}:{name}" for name in ("hello", "trip", "many", "secret")]
    install(site, "acme", PLUGIN, commands="\n".join(lines))
    (site / "scene.rl").write_text(ROAD)
    return site


def help_text(capsys: pytest.CaptureFixture[str], *before: str) -> str:
    capsys.readouterr()
    assert run([*before, "--help"]) == 0
    return capsys.readouterr().out


def completions(incomplete: str, *words: str) -> list[str]:
    shell = ShellComplete(roadlang, {}, "roadlang", "_ROADLANG_COMPLETE")
    return [item.value for item in shell.get_completions(list(words), incomplete)]


def test_a_command_runs_as_ours_do(acme: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["hello", str(acme / "scene.rl"), "--loudly"]) == 4
    assert capsys.readouterr().out == "hello main!\n"


def test_what_a_command_reports_looks_as_ours_does(
    acme: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (acme / "scene.rl").write_text("raod main\n")
    assert run(["hello", str(acme / "scene.rl")]) == 1
    assert "scene.rl:1:1" in capsys.readouterr().err


def test_a_real_process_finds_it(acme: Path) -> None:
    process = start(acme, "hello", "scene.rl")
    assert process.communicate(timeout=300) == ("hello main\n", "")
    assert process.returncode == 4


def test_help_lists_it_with_the_first_line_of_its_docstring(
    acme: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = " ".join(help_text(capsys).split())
    assert "Commands of plugins:" in words
    assert "hello Greet the roads of FILE." in words
    assert "secret" not in words
    assert run(["secret"]) == 0


def test_help_says_what_is_wrong_with_a_command_once_and_nothing_of_names_that_are_ours(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("acme", "other"):
        lines = f"hello = roadlang_{name}:hello\ncheck = roadlang_{name}:hello"
        install(site, name, PLUGIN, commands=lines)
    words = " ".join(help_text(capsys).split())
    assert words.count("hello cannot be used") == 1
    assert "check cannot be used" not in words


def test_it_is_completed_and_meant(acme: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert completions("hel") == ["hello"]
    assert completions("--l", "hello") == ["--loudly"]
    assert completions("o", "many") == ["one"]
    assert run(["helo"]) == 2
    assert "Did you mean `hello`?" in capsys.readouterr().err


@pytest.mark.parametrize("how", ["option", "environment"])
def test_leaving_a_plugin_out_leaves_its_commands_out(
    acme: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    how: str,
) -> None:
    before = ["--no-plugin", "acme"] if how == "option" else []
    if how == "environment":
        monkeypatch.setenv("ROADLANG_NO_PLUGINS", "other, acme")
    assert "hello" not in help_text(capsys, *before)
    assert "render" in help_text(capsys, *before)
    assert run([*before, "hello", "scene.rl"]) == 2
    assert "No such command 'hello'" in capsys.readouterr().err


def test_shipped_commands_go_with_their_plugin(capsys: pytest.CaptureFixture[str]) -> None:
    assert "render" not in help_text(capsys, "--no-plugin", "godot")
    assert "render" in help_text(capsys, "--no-plugin", "standard")
    assert "render" not in help_text(capsys, "--no-plugin", "all")


FAILURES = {
    "raise": (5, "error[RL470]: `roadlang trip` failed (acme-plugin 1.2): ZeroDivisionError"),
    "exit": (7, ""),
    "diagnostic": (1, "error[ACME01]: there is no road to Acme"),
    "usage": (2, "Error: how indeed"),
}


@pytest.mark.parametrize("how", FAILURES)
def test_what_a_command_raises_is_told_of_its_plugin(
    acme: Path, capsys: pytest.CaptureFixture[str], how: str
) -> None:
    code, says = FAILURES[how]
    assert run(["trip", how]) == code
    said = capsys.readouterr().err
    assert says in said
    assert ("(roadlang_acme.py:" in said) == (how == "raise")


def test_a_command_of_a_group_is_told_of_its_plugin_too(
    acme: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["many", "one"]) == 5
    assert "`roadlang many` failed (acme-plugin 1.2): RuntimeError" in capsys.readouterr().err


BROKEN = {
    "a module that raises": ("1 / 0", "hello", "ZeroDivisionError: division by zero"),
    "a module that exits": ("raise SystemExit(3)", "hello", "SystemExit: 3"),
    "a module that is not there": (None, "hello", "ModuleNotFoundError"),
    "no such name": (PLUGIN, "goodbye", "AttributeError"),
    "not a command": (PLUGIN, "nothing", "it is a int, not a click.Command"),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_a_broken_command_breaks_nothing_else(
    site: Path, capsys: pytest.CaptureFixture[str], fault: str
) -> None:
    text, attribute, reason = BROKEN[fault]
    module = "roadlang_acme" if text is not None else "roadlang_nowhere"
    install(site, "acme", text or "", commands=f"greet = {module}:{attribute}")
    words = " ".join(help_text(capsys).split())
    assert "greet cannot be used:" in words
    assert reason in words
    assert "render" in words
    assert run(["greet"]) == 2
    said = capsys.readouterr().err
    assert "error[RL932]: the command `greet` comes from acme-plugin 1.2" in said
    assert reason in said
    assert "render" in completions("ren")
    completions("", "greet")


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("check", "roadlang itself has a command with this name"),
        ("render", "roadlang 0.1.0 has a command with the same name"),
        ("-f", "its name is not valid"),
        ("a.b", "its name is not valid"),
    ],
)
def test_a_command_that_cannot_be_is_listed_with_the_reason(
    site: Path, capsys: pytest.CaptureFixture[str], name: str, reason: str
) -> None:
    install(site, "acme", PLUGIN, commands=f"{name} = roadlang_acme:secret")
    reason = reason.replace("0.1.0", version("roadlang"))
    assert run(["plugins"]) == 0
    listed = capsys.readouterr().out
    assert f"the command `{name}` of acme (acme-plugin 1.2) is broken: {reason}" in listed
    assert run(["plugins", "--json"]) == 0
    [record] = json.loads(capsys.readouterr().out)["broken"]
    assert record["kind"] == f"command {name}"
    if name in COMMANDS:
        (site / "scene.rl").write_text(ROAD)
        assert run([name, str(site / "scene.rl")]) == 0
        assert "psst" not in capsys.readouterr().out


def test_two_strangers_with_one_command(site: Path, capsys: pytest.CaptureFixture[str]) -> None:
    install(site, "acme", PLUGIN, commands="hello = roadlang_acme:hello")
    install(site, "apex", PLUGIN, commands="hello = roadlang_apex:hello")
    assert "hello cannot be used: a" in " ".join(help_text(capsys).split())
    assert run(["hello"]) == 2
    said = capsys.readouterr().err
    assert "acme-plugin 1.2" in said
    assert "apex-plugin 1.2" in said
    assert run(["--no-plugin", "apex", "secret"]) == 2  # apex is out, and acme has no `secret`
    (site / "scene.rl").write_text(ROAD)
    assert run(["--no-plugin", "apex", "hello", str(site / "scene.rl")]) == 4


def test_a_command_for_another_version_of_roadlang(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    install(site, "acme", PLUGIN, commands="hello = roadlang_acme:hello", requires="roadlang>=99")
    assert run(["hello"]) == 2
    assert "it requires roadlang>=99" in capsys.readouterr().err


def test_commands_are_listed_with_the_plugin_that_brings_them(
    acme: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["plugins"]) == 0
    listed = capsys.readouterr().out.splitlines()
    start = listed.index("acme  (acme-plugin 1.2)")
    assert [line.split() for line in listed[start + 1 : start + 4]] == [
        ["command", "hello", "Greet", "the", "roads", "of", "FILE."],
        ["command", "many", "Several", "things."],
        ["command", "trip", "Go", "wrong", "in", "some", "way."],
    ]


def test_check_imports_no_command(acme: Path) -> None:
    code = (
        "import sys; from roadlang.cli.main import run; run(['check', 'scene.rl']); "
        "print('roadlang_godot.commands.render' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=acme, capture_output=True, text=True, check=True
    )
    assert done.stdout.split()[-1] == "False"


def test_of_two_plugins_of_one_distribution_a_command_is_that_of_its_own_package(
    site: Path,
) -> None:
    """As `roadlang render` is one of `godot`, not of `standard`: leaving that out leaves it out."""
    install(site, "acme", PLUGIN, commands=f"hello = {MODULE}:hello\nbye = roadlang_other:hello")
    points = site / "acme_plugin-1.2.dist-info" / "entry_points.txt"
    points.write_text(
        points.read_text().replace("[roadlang]", "[roadlang]\nother = roadlang_other")
    )
    owners = {found.name: found.origin.plugin for found in command_candidates()}
    assert (owners["hello"], owners["bye"], owners["render"]) == ("acme", "other", "godot")


def test_a_command_of_a_package_without_a_plugin_belongs_to_the_first_of_its_distribution(
    site: Path,
) -> None:
    install(site, "acme", PLUGIN, commands="hello = roadlang_tools:hello")
    owners = {found.name: found.origin.plugin for found in command_candidates()}
    assert owners["hello"] == "acme"
