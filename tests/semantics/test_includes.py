"""Files that include each other many times are refused in bounded time."""

from __future__ import annotations

from pathlib import Path

from roadlang.ir.dimension import LENGTH
from roadlang.ir.values import ConstantValue
from roadlang.plugins.registry import Registry
from roadlang.semantics import check_text


def test_files_that_double_are_refused(tmp_path: Path, registry: Registry) -> None:
    for number in range(24):
        inner = f'include "f{number + 1}.rl" as a\ninclude "f{number + 1}.rl" as b\n'
        (tmp_path / f"f{number}.rl").write_text(inner)
    (tmp_path / "f24.rl").write_text("param x = 1m\n")
    scenario, found = check_text('include "f0.rl"\n', tmp_path / "scene.rl", {}, registry)
    assert scenario is None
    assert [diagnostic.code for diagnostic in found] == ["RL110"]


def test_only_the_first_included_file_beyond_the_limit_is_named(
    tmp_path: Path, registry: Registry
) -> None:
    for number in range(250):
        (tmp_path / f"f{number}.rl").write_text(f"param p{number} = 1m\n")
    text = "".join(f'include "f{number}.rl"\n' for number in range(250))
    scenario, found = check_text(text, tmp_path / "scene.rl", {}, registry)
    assert scenario is None
    assert [diagnostic.code for diagnostic in found] == ["RL110"]
    assert found[0].span is not None
    assert found[0].span.line == 201


def test_each_inclusion_has_draws_of_its_own(tmp_path: Path, registry: Registry) -> None:
    street = "road main { draw with waypoints { points: [(0m, 0m), (80m, 0m..9m)] }, width: 7m }\n"
    (tmp_path / "street.rl").write_text(street)
    text = 'include "street.rl" as left\ninclude "street.rl" as right\n'
    scenario, found = check_text(text, tmp_path / "scene.rl", {}, registry)
    assert scenario is not None, found
    places = {road.name: road.passes[0].place for road in scenario.roads}
    assert places == {"left.main": "left.main/draw 1", "right.main": "right.main/draw 1"}


def test_params_of_included_files_are_set_from_the_command_line(
    tmp_path: Path, registry: Registry
) -> None:
    (tmp_path / "street.rl").write_text("param bend = 30m\n")
    text = 'include "street.rl" as left { bend: 20m }\ninclude "street.rl" as right\n'
    scenario, found = check_text(text, tmp_path / "scene.rl", {"left.bend": "5m"}, registry)
    assert scenario is not None, found
    values = {item.name: item.value for item in scenario.values}
    assert [getattr(values[f"{side}.bend"], "value", None) for side in ("left", "right")] == [5, 30]


def test_what_a_file_sets_wins_over_what_its_includes_set(
    tmp_path: Path, registry: Registry
) -> None:
    (tmp_path / "inner.rl").write_text("param wide = 2m\nparam long = 20m\n")
    (tmp_path / "outer.rl").write_text('include "inner.rl" { wide: 3m, long: 30m }\n')
    text = 'include "outer.rl" { wide: 4m }\n'
    scenario, found = check_text(text, tmp_path / "scene.rl", {"long": "50m"}, registry)
    assert scenario is not None, found
    values = {value.name: value.value for value in scenario.values}
    assert values == {"wide": ConstantValue(4.0, LENGTH), "long": ConstantValue(50.0, LENGTH)}


def test_the_header_of_a_scenario_is_that_of_the_main_file(
    tmp_path: Path, registry: Registry
) -> None:
    (tmp_path / "street.rl").write_text('scenario street "A street"\nparam wide = 2m\n')
    scenario, found = check_text(
        'include "street.rl"\nscenario town "A town"\n', tmp_path / "scene.rl", {}, registry
    )
    assert scenario is not None, found
    assert (scenario.header.name, scenario.header.title) == ("town", "A town")
