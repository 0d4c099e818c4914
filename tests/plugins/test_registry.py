"""Looking kinds up by name, and what is said where one is not there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import pytest

from roadlang import testing
from roadlang.api import Backend, Scene
from roadlang.diagnostics import DiagnosticError
from roadlang.plugins.discovery import load_registry, registry_of
from roadlang.plugins.entry_points import Origin
from roadlang.plugins.finding import entry_of
from roadlang.plugins.registry import BrokenPlugin, Registry

ACME = Origin("acme", "acme-plugin", "1.2")
OTHER = Origin("other", "other-plugin", "0.3")


def test_the_standard_kinds_are_listed_before_those_of_other_plugins() -> None:
    plugins = dict.fromkeys(entry.origin.plugin for entry in load_registry().entries)
    assert list(plugins)[:3] == ["standard", "formats", "godot"]


def test_a_name_with_its_plugin_is_missing_for_the_reasons_of_that_plugin_alone() -> None:
    broken = BrokenPlugin(ACME, "it has no `name`", "perturb sway")
    registry = Registry(broken=(broken,))
    assert registry.broken_kind(["perturb"], "acme.sway") == broken
    assert registry.broken_kind(["perturb"], "other.sway") is None
    assert registry.broken_kind(["perturb"], "sway") == broken
    assert registry.broken_kind(["draw"], "sway") is None


def test_a_plugin_that_is_broken_as_a_whole_is_the_reason_for_each_of_its_names() -> None:
    broken = BrokenPlugin(ACME, "SyntaxError")
    registry = Registry(broken=(BrokenPlugin(OTHER, "ImportError"), broken))
    assert registry.broken_kind(["perturb"], "acme.sway") == broken
    assert registry.broken_kind(["perturb"], "sway") is None


def test_hints_name_three_broken_plugins_and_count_the_others() -> None:
    def hints(count: int) -> tuple[str, ...]:
        origins = (Origin(f"p{index}", f"p{index}-plugin", "1") for index in range(count))
        return Registry(broken=tuple(BrokenPlugin(origin, "?") for origin in origins)).hints

    assert hints(0) == ()
    assert hints(3)[2] == "the plugin p2-plugin 1 could not be loaded: ?"
    assert len(hints(3)) == 3
    assert hints(5)[3:] == ("2 more could not be loaded; `roadlang plugins` shows why",)


@pytest.mark.parametrize(
    ("verb", "what"),
    [("simulate", "engine"), ("emit", "backend"), ("perturb", "`perturb` kind")],
)
def test_an_unknown_choice_is_called_what_a_user_calls_it(verb: str, what: str) -> None:
    with pytest.raises(DiagnosticError) as error:
        entry_of(load_registry(), verb, "nonsense")
    (found,) = error.value.diagnostics
    assert (found.code, found.message) == ("RL930", f"there is no {what} called `nonsense`")


def test_a_default_of_a_stranger_changes_no_file() -> None:
    @dataclass(frozen=True)
    class Loud(Backend):
        """Wants to be written by every file without an `emit`."""

        name: ClassVar[str] = "loud"
        is_default: ClassVar[bool] = True

        def files(self, scene: Scene) -> dict[str, str]:
            return {"txt": "!"}

    registry = registry_of({"acme": testing.plugin_of(Loud)})
    assert registry.has("emit", "loud")
    assert [entry.name for entry in registry.defaults("emit")] == ["json", "svg"]
    assert registry.default("sample").name == "random"
