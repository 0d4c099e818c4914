"""What plugins are handed cannot be changed, so that no plugin changes what another one sees."""

from __future__ import annotations

import copy
import dataclasses
import json
import operator
import pickle
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang.api import (
    AgentTrace,
    Distribution,
    Extractor,
    Length,
    Like,
    Monitor,
    Observation,
    Perturber,
    RoadName,
    Sampler,
    Selector,
    Signal,
    Trace,
    list_of,
    map_of,
    option,
    to_json,
)
from roadlang.diagnostics import Diagnostic, DiagnosticError
from roadlang.ir.read_only import FrozenDict, FrozenList, frozen
from roadlang.scenes.sampling import SamplingResult
from tests.plugins.installed import install, start
from tests.straight_road import STRAIGHT

Sample = Callable[..., SamplingResult]
ARRAYS = (
    "stations", "points", "heading", "curvature", "normal", "displacement", "width", "length",
    "folded",
)  # fmt: skip
SWAYING = (
    STRAIGHT + "road bent from main { perturb with sine { amplitude: 1m..2m, wavelength: 80m } }\n"
)
TOWN = '''
image plan from """
######
#    #
######
""" { scale: 8m/px, legend: { "#": road, "x": tree } }
network town from plan { extract with looking }
road main from town { select: looking() }
'''

seen: list[Any] = []


def failure(sample: Sample, text: str, *kinds: type) -> Diagnostic:
    with pytest.raises(DiagnosticError) as caught:
        sample(text, kinds=kinds)
    return caught.value.diagnostics[0]


def changing(array: str) -> type[Signal]:
    """A signal that computes in place, as numpy makes it easy to."""

    @dataclass(frozen=True)
    class Careless(Signal):
        """Sets what it is handed to zero."""

        name: ClassVar[str] = "careless"
        unit: ClassVar[str] = "m"
        road: RoadName = option()

        def values(self) -> Any:
            numbers = getattr(self.road, array)
            numbers *= 0
            return self.road.stations

    return Careless


@pytest.mark.parametrize("array", ARRAYS)
@pytest.mark.parametrize("road", ["main", "bent"])
def test_a_signal_that_computes_in_place_is_named(sample: Sample, array: str, road: str) -> None:
    text = SWAYING + f"require fine: always (careless({road}) < 900m)\n"
    found = failure(sample, text, changing(array))
    assert found.code == "RL470"
    assert "signal acme.careless" in found.message
    assert "read-only" in found.message


def test_a_perturber_cannot_move_the_stations(sample: Sample) -> None:
    @dataclass(frozen=True)
    class Careless(Perturber):
        """Counts its stations from -1."""

        name: ClassVar[str] = "careless"

        def displacements(self, roads: Any, random: Any) -> Any:
            stations = roads.stations
            stations -= 1
            return 0 * stations

    found = failure(sample, STRAIGHT + "road bent from main { perturb with careless }\n", Careless)
    assert found.code == "RL470"
    assert "perturb acme.careless" in found.message


@dataclass(frozen=True)
class Halving(Perturber):
    """Halves its options in place."""

    name: ClassVar[str] = "halving"
    size: Length = option(0.0)
    sizes: list_of(Length) = option(())  # type: ignore[valid-type]
    named: map_of(Length) = option(None)  # type: ignore[valid-type]

    def displacements(self, roads: Any, random: Any) -> Any:
        for size in (self.size, *self.sizes, *(self.named or {}).values()):
            if isinstance(size, np.ndarray):
                size /= 2
        return 0 * roads.stations


@pytest.mark.parametrize("options", ["size: a", "sizes: [a, 1m]", "named: { x: a }"])
def test_a_drawn_option_stays_what_was_drawn(sample: Sample, options: str) -> None:
    text = f"let a = 1m..2m\nroad bent from main {{ perturb with halving {{ {options} }} }}\n"
    found = failure(sample, STRAIGHT + text, Halving)
    assert "ValueError" in found.message
    assert "read-only" in found.message


def test_a_distribution_cannot_change_the_numbers_that_a_sampler_chose(sample: Sample) -> None:
    @dataclass(frozen=True)
    class Doubling(Distribution):
        """Doubles what it gets."""

        name: ClassVar[str] = "doubling"
        high: Like = option()

        def quantile(self, uniform: Any) -> Any:
            uniform *= 2
            return self.high * uniform

    text = (
        "road bent from main { perturb with sine { amplitude: doubling(1m), wavelength: 80m } }\n"
    )
    found = failure(sample, STRAIGHT + text + "sample with halton\n", Doubling)
    assert "distribution acme.doubling" in found.message


def test_a_sampler_cannot_change_which_candidates_there_are(sample: Sample) -> None:
    @dataclass(frozen=True)
    class Shifting(Sampler):
        """Counts on."""

        name: ClassVar[str] = "shifting"

        def points(self, indices: Any, draws: Any, seed: int) -> Any:
            indices += 1
            return np.zeros((len(indices), len(draws)))

    assert (
        "sample acme.shifting"
        in failure(sample, SWAYING + "sample with shifting\n", Shifting).message
    )


@dataclass(frozen=True)
class LookingExtractor(Extractor):
    """Keeps the picture for the test."""

    name: ClassVar[str] = "looking"

    def extract(self, picture: Any) -> Any:
        seen.append(picture)
        return picture.network([np.array([(0.0, 1.0), (4.0, 1.0), (9.0, 2.0)])], width=1.0)


@dataclass(frozen=True)
class LookingSelector(Selector):
    """Keeps the network for the test."""

    name: ClassVar[str] = "looking"

    def select(self, network: Any) -> Any:
        seen.append(network)
        return network.longest()


@dataclass(frozen=True)
class LookingMonitor(Monitor):
    """Keeps the road for the test."""

    name: ClassVar[str] = "looking"
    road: RoadName = option()

    def robustness(self) -> Any:
        seen.append(self.road)
        return [1.0]


def inside(value: Any, place: str, known: set[int]) -> Iterator[tuple[str, Any]]:
    """All arrays, maps and lists in the fields of a value, and in theirs, with the way there."""
    if id(value) in known or isinstance(value, str | int | float | bool | type(None) | type):
        return
    known.add(id(value))
    if isinstance(value, np.ndarray | Mapping | list):
        yield place, value
    if isinstance(value, Mapping):
        for key, item in value.items():
            yield from inside(item, f"{place}[{key!r}]", known)
    elif isinstance(value, tuple | list):
        for index, item in enumerate(value[:50]):
            yield from inside(item, f"{place}[{index}]", known)
    else:
        for name, item in getattr(value, "__dict__", {}).items():
            if not name.startswith("_"):
                yield from inside(item, f"{place}.{name}", known)
        if dataclasses.is_dataclass(value):
            for field in dataclasses.fields(value):
                item = getattr(value, field.name)
                yield from inside(item, f"{place}.{field.name}", known)


def assert_read_only(value: Any) -> None:
    found = list(inside(value, type(value).__name__, set()))
    assert found
    for place, item in found:
        if isinstance(item, np.ndarray):
            assert not item.flags.writeable, place
        else:
            assert isinstance(item, FrozenDict | FrozenList), place


def test_all_that_pictures_networks_and_roads_hold_is_read_only(sample: Sample) -> None:
    seen.clear()
    text = TOWN + "require look with looking { road: main }\n"
    sample(text, kinds=(LookingExtractor, LookingSelector, LookingMonitor))
    assert {type(item).__name__ for item in seen} == {"Picture", "RoadNetwork", "RoadBatch"}
    for item in seen:
        if type(item).__name__ == "RoadBatch":
            for name in ARRAYS:
                getattr(item, name)
        assert_read_only(item)


def test_they_stay_so_in_another_process(sample: Sample) -> None:
    seen.clear()
    text = TOWN + "require look with looking { road: main }\n"
    sample(text, kinds=(LookingExtractor, LookingSelector, LookingMonitor))
    for item in seen:
        assert_read_only(pickle.loads(pickle.dumps(item)))


def test_all_that_a_scene_holds_is_read_only(sample: Sample) -> None:
    text = SWAYING + (
        "param sizes = [1m, 2m]\n"
        "agent ego is car on bent at 5m {\n"
        "  drive with stanley { speed: 8m/s }\n"
        "  drive with brake { when: ego.speed > 3m/s }\n"
        "}\n"
        "expect slow: always (ego.speed < 9m/s)\n"
    )
    (scene,) = sample(text).scenes
    assert_read_only(scene)
    assert copy.deepcopy(scene) == pickle.loads(pickle.dumps(scene)) == scene
    assert_read_only(pickle.loads(pickle.dumps(scene)))
    assert to_json(copy.deepcopy(scene)) == to_json(scene)
    assert dataclasses.replace(scene, title="x").values == scene.values


def agent(name: str) -> AgentTrace:
    columns: dict[str, Any] = {
        field.name: 0.0 if field.type == "float" else np.zeros(3)
        for field in dataclasses.fields(AgentTrace)[1:-2]
    }
    return AgentTrace(name=name, **columns)


def test_all_that_a_trace_holds_is_read_only() -> None:
    trace = Trace(np.arange(3.0), {"ego": agent("ego")}, "test", ({"what": ["crash"]},))
    assert_read_only(trace)
    assert_read_only(pickle.loads(pickle.dumps(trace)))


def test_the_others_that_a_controller_sees_are_read_only() -> None:
    values: dict[str, Any] = {f.name: 0.0 for f in dataclasses.fields(Observation)[:-1]}
    values["line_ahead"] = lambda d: (d, 0.0, 0.0, 0.0)
    lone = Observation(**values)
    assert_read_only(dataclasses.replace(lone, others={"ego": lone}))


def test_a_copy_of_what_is_read_only_can_be_changed() -> None:
    value = frozen({"a": [1, {"b": 2}], "c": (3,)})
    assert json.dumps(value) == '{"a": [1, {"b": 2}], "c": [3]}'
    changed = dict(value)
    changed["a"] = [*value["a"], 4]
    assert (value | {"c": 5})["c"] == 5
    assert value == {"a": [1, {"b": 2}], "c": (3,)}


def in_place(name: str, value: Any, other: object) -> None:
    """`value |= other` and its like, named as in `operator`."""
    getattr(operator, name)(value, other)


CHANGES: dict[str, Callable[[Any], Any]] = {
    "m[key] = value": lambda m: operator.setitem(m, "x", 1),
    "del m[key]": lambda m: operator.delitem(m, "a"),
    "m |= other": lambda m: in_place("ior", m, {"x": 1}),
    "m.update": lambda m: m.update(x=1),
    "m.setdefault": lambda m: m.setdefault("x", 1),
    "m.pop": lambda m: m.pop("a"),
    "m.popitem": lambda m: m.popitem(),
    "m.clear": lambda m: m.clear(),
    "l[0] = value": lambda m: operator.setitem(m["a"], 0, 2),
    "l[:] = values": lambda m: operator.setitem(m["a"], slice(None), []),
    "del l[0]": lambda m: operator.delitem(m["a"], 0),
    "l += values": lambda m: in_place("iadd", m["a"], [1]),
    "l *= 2": lambda m: in_place("imul", m["a"], 2),
    "l.append": lambda m: m["a"].append(1),
    "l.extend": lambda m: m["a"].extend([1]),
    "l.insert": lambda m: m["a"].insert(0, 1),
    "l.pop": lambda m: m["a"].pop(),
    "l.remove": lambda m: m["a"].remove(1),
    "l.clear": lambda m: m["a"].clear(),
    "l.sort": lambda m: m["a"].sort(),
    "l.reverse": lambda m: m["a"].reverse(),
}


@pytest.mark.parametrize("change", CHANGES)
def test_every_change_in_place_is_refused(change: str) -> None:
    value = frozen({"a": [1, 2]})
    with pytest.raises(TypeError, match="read-only"):
        CHANGES[change](value)
    assert value == {"a": [1, 2]}


SNEAKY = """
from dataclasses import dataclass
from typing import ClassVar
from roadlang.api import Backend, Perturber, hookimpl

@dataclass(frozen=True)
class Sneaky(Backend):
    '''Writes into the scene.'''
    name: ClassVar[str] = "sneaky"

    def files(self, scene):
        scene.values["hack"] = 1
        return {}

@dataclass(frozen=True)
class Flat(Perturber):
    '''Straightens the road that it is handed.'''
    name: ClassVar[str] = "flat"

    def displacements(self, roads, random):
        roads.curves.points[..., 1] = 0
        return 0 * roads.stations

@hookimpl
def roadlang_kinds():
    return [Sneaky, Flat]
"""


def test_one_backend_cannot_change_the_scene_of_the_next(site: Path) -> None:
    install(site, "acme", SNEAKY)
    (site / "scene.rl").write_text(STRAIGHT + "emit sneaky\nemit json\n")
    process = start(site, "compile", "scene.rl")
    _, err = process.communicate(timeout=300)
    assert process.returncode == 5
    assert "`emit acme.sneaky` failed (acme-plugin 1.2): TypeError: this map is read-only" in err
    assert "(roadlang_acme.py:12)" in err
    assert not (site / "out").exists()


def test_arrays_are_read_only_in_workers_too(site: Path) -> None:
    install(site, "acme", SNEAKY)
    text = SWAYING + (
        "road flat from bent { perturb with flat }\n"
        "require near: always (deviation(flat, main) < 9m)\n"
    )
    (site / "scene.rl").write_text(text)
    process = start(site, "compile", "scene.rl", "-n", "40", "--jobs", "2")
    _, err = process.communicate(timeout=300)
    assert process.returncode == 5
    assert "`perturb acme.flat` failed" in err
    assert "read-only" in err
