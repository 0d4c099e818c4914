"""Plugins are found by their entry points; a broken one is named and breaks nothing else."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.plugins.discovery import load_registry
from roadlang.plugins.registry import Registry, UnknownKind
from tests.plugins.installed import install

ACME = Path(__file__).parent / "acme_plugin" / "roadlang_acme.py"

GOOD = """
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import Length, Perturber, hookimpl, option

@dataclass(frozen=True)
class Zigzag(Perturber):
    '''Zig, then zag.'''
    name: ClassVar[str] = "{kind}"
    amplitude: Length = option(help="how far")

    def displacement(self, road, random):
        return self.amplitude + 0 * road.stations

@hookimpl
def roadlang_kinds():
    return [Zigzag]
"""

BROKEN = {
    "import error": ("import a_module_that_is_not_there", "ModuleNotFoundError"),
    "syntax error": ("def broken(:", "SyntaxError"),
    "exit on import": ("import sys; sys.exit(3)", "SystemExit: 3"),
    "no hook": ("x = 3", "implements no hook"),
    "wrong hook name": (
        "from roadlang.api import hookimpl\n@hookimpl\ndef roadlang_kind(): return []",
        "roadlang_kind",
    ),
    "hook with wrong arguments": (
        "from roadlang.api import hookimpl\n@hookimpl\ndef roadlang_kinds(nonsense): return []",
        "nonsense",
    ),
    "hook that raises": (
        "from roadlang.api import hookimpl\n@hookimpl\ndef roadlang_kinds(): return 1 / 0",
        "ZeroDivisionError",
    ),
    "hook that returns nothing": (
        "from roadlang.api import hookimpl\n@hookimpl\ndef roadlang_kinds(): return []",
        "returned no kinds",
    ),
    "hook that returns nonsense": (
        "from roadlang.api import hookimpl\n@hookimpl\ndef roadlang_kinds(): return 3",
        "TypeError",
    ),
    "class that is no kind": (
        "from roadlang.api import hookimpl\n@hookimpl\ndef roadlang_kinds(): return [int]",
        "does not derive from a base class",
    ),
    "kind without a name": (
        GOOD.format(kind="zigzag").replace('name: ClassVar[str] = "zigzag"', ""),
        "has no `name`",
    ),
    "bad annotation": (
        GOOD.format(kind="zigzag").replace("amplitude: Length", "amplitude: complex"),
        "field `amplitude` of Zigzag",
    ),
    "forgotten decorator": (
        GOOD.format(kind="zigzag").replace("@dataclass(frozen=True)", ""),
        "Zigzag is not decorated with `@dataclass(frozen=True)`",
    ),
    "duplicate kind": (
        GOOD.format(kind="zigzag").replace("[Zigzag]", "[Zigzag, Zigzag]"),
        "provides `perturb zigzag` twice",
    ),
    "map with a bad key": (
        "from roadlang.api import hookimpl\n@hookimpl\ndef roadlang_kinds(): return {'zag': 'a:B'}",
        "`zag` is not a verb and a name",
    ),
}


def reasons(registry: Registry) -> dict[str, str]:
    return {broken.origin.plugin: broken.reason for broken in registry.broken}


def test_the_standard_kinds_come_in_by_an_entry_point() -> None:
    entry = load_registry().find("perturb", "sine")
    assert entry.qualified == "standard.sine"
    assert entry.origin.distribution == "roadlang"


def test_every_standard_kind_loads_and_explains_itself() -> None:
    for entry in load_registry().entries:
        assert entry.help, entry.qualified
        assert all(option.help for option in entry.options), entry.qualified


def test_an_installed_plugin_is_found_with_its_distribution(site: Path) -> None:
    install(site, "acme", ACME.read_text())
    entry = load_registry().find("drive", "acme.mpc")
    assert str(entry.origin) == "acme-plugin 1.2"
    assert [option.name for option in entry.options] == ["horizon", "weights", "model", "verbose"]
    assert load_registry().find("drive", "mpc") == entry


@pytest.mark.parametrize("fault", BROKEN)
def test_a_broken_plugin_is_named_and_the_rest_works(site: Path, fault: str) -> None:
    text, reason = BROKEN[fault]
    install(site, "faulty", text)
    install(site, "good", GOOD.format(kind="zigzag"))
    registry = load_registry()
    assert list(reasons(registry)) == ["faulty"]
    assert reason in reasons(registry)["faulty"]
    assert registry.has("perturb", "zigzag")
    assert registry.has("perturb", "sine")


def test_plugins_can_be_left_out(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    install(site, "good", GOOD.format(kind="zigzag"))
    assert not load_registry(blocked=["good"]).has("perturb", "zigzag")
    monkeypatch.setenv("ROADLANG_NO_PLUGINS", "other, good")
    assert not load_registry().has("perturb", "zigzag")
    assert load_registry().has("perturb", "sine")
    monkeypatch.setenv("ROADLANG_NO_PLUGINS", "all")
    assert load_registry().entries == ()
    with pytest.raises(UnknownKind):
        load_registry().find("perturb", "sine")


def test_kinds_named_in_the_metadata_are_found_without_importing_the_plugin(site: Path) -> None:
    module = f"from pathlib import Path\nPath({str(site / 'imported')!r}).touch()\n{GOOD}"
    install(
        site, "lazy", module.format(kind="zigzag"), kinds="perturb.zigzag = roadlang_lazy:Zigzag"
    )
    registry = load_registry()
    assert registry.find("perturb", "zigzag").qualified == "lazy.zigzag"
    assert not (site / "imported").exists()
    assert registry.find("perturb", "zigzag").help == "Zig, then zag."
    assert (site / "imported").exists()


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("zigzag = roadlang_lazy:Zigzag", "`zigzag` is not a verb and a name"),
        ("perturb.zigzag = roadlang_lazy", "the target of `perturb zigzag` is not `module:Class`"),
        ("perturb.zig-zag = roadlang_lazy:Zigzag", "'zig-zag' is not a name"),
    ],
)
def test_a_kind_named_wrongly_in_the_metadata_is_broken(site: Path, line: str, reason: str) -> None:
    install(site, "lazy", GOOD.format(kind="zigzag"), kinds=line)
    (broken,) = load_registry().broken
    assert reason in broken.reason


def test_a_plugin_cannot_have_the_name_of_another_in_either_form(site: Path) -> None:
    install(site, "lazy", GOOD.format(kind="zigzag"), kinds="perturb.zigzag = roadlang_lazy:Zigzag")
    install(site, "eager", GOOD.format(kind="wave"), name_of_entry="lazy")
    assert ["is also that of" in broken.reason for broken in load_registry().broken] == [True, True]
