"""What is said when a method of a plugin's kind gives what it should not, in lines."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, make_dataclass
from typing import Any, ClassVar

import numpy as np

from roadlang import DiagnosticError, NoSceneError, testing
from roadlang.api import (
    Control,
    Controller,
    Distribution,
    Drawer,
    DriveSignal,
    Extractor,
    JunctionControl,
    Kind,
    Monitor,
    Perturber,
    Piece,
    Position,
    RightOfWay,
    RoadName,
    RoadNumber,
    Sampler,
    Selector,
    Signal,
)
from roadlang.geometry import Arc, Curve, Straight
from roadlang.plugins.kinds.drives import InitialSpeed
from tests.golden.summaries import array
from tests.straight_road import STRAIGHT

_BENT = STRAIGHT + "road bent from main { perturb with odd }\n"
_TOWN = 'image plan from """\n####\n.#..\n.#..\n""" { scale: 16m/px, legend: { "#": road } }\n'
_FOUND = _TOWN + "network town from plan { lanes: 2 }\n"
_SWAY = "road bent from main { perturb with sine { amplitude: 1m..3m, wavelength: 80m } }\n"
_EGO = STRAIGHT + "agent ego is car on main at 20m { drive with odd }\n"
_REASON = re.compile(r"\): (\w+): .* / this")
_PLACE_OF_CODE = re.compile(r"\([\w/.\\-]+\.py:\d+\)")
_LINE = Curve.through([(0.0, 0.0), (40.0, 0.0), (90.0, 9.0)])
_ANY: tuple[Any, ...] = (
    *(None, -1.0, float("nan"), "x", 2 + 1j, [], (0.5, 2.0), (2.0, 0.5)),
    *([[0.5, 0.5], [0.5, 0.5]], np.zeros(7)),
)


@dataclass(frozen=True)
class _Place:
    """A method of a base class, where its kind is used, and right or nearly right results."""

    base: type[Kind]
    method: str
    text: str
    results: tuple[Any, ...] = ()
    members: tuple[tuple[str, Any], ...] = ()


_PHASES = (RightOfWay("signals"), RightOfWay("yield", (1,)), RightOfWay("yield", (77,)))
_STILL: Mapping[type[Kind], Mapping[str, Any]] = {
    Perturber: {"displacement": lambda self, road, random: 0.0 * road.stations},
    Sampler: {"points": lambda self, indices, draws, seed: np.zeros((len(indices), len(draws)))},
    Distribution: {"quantile": lambda self, uniform: 1.0 + uniform},
    Controller: {"control": lambda self, seen: Control(0.0, 0.0)},
    Drawer: {"draw": lambda self, closed: _LINE},
    Signal: {"values": lambda self: self.road.stations * 0.0},
    RoadNumber: {"values": lambda self: self.road.length},
}
_SIGNAL = STRAIGHT + "require r: always (odd(main) < 3)\n"
_DRAWN = STRAIGHT + "param w = odd()\nroad wide from main { width: w * 6m }\n"
_SAMPLED = STRAIGHT + _SWAY + "sample with odd\n"
_PLACES = (
    _Place(Perturber, "displacement", _BENT),
    _Place(Perturber, "displacements", _BENT),
    _Place(Perturber, "displacement_bound", _BENT),
    _Place(Perturber, "shortest_feature", _BENT),
    _Place(Drawer, "draw", "road main { draw with odd }\n", (_LINE,)),
    _Place(Drawer, "least_length", "road main { draw with odd }\nrequire r: length(main) > 50m\n"),
    _Place(
        Piece,
        "to_segment",
        "road main { draw with segments { pieces: [straight(50m), odd()] } }\n",
        (Straight(20.0), Arc(20.0, 0.02)),
    ),
    _Place(Selector, "select", _FOUND + "road main from town { select: odd() }\n"),
    *(_Place(Distribution, method, _DRAWN) for method in ("quantile", "support")),
    *(_Place(Sampler, method, _SAMPLED) for method in ("points", "size", "limit")),
    *(_Place(Signal, method, _SIGNAL) for method in ("values", "range", "dimension_of")),
    _Place(RoadNumber, "values", STRAIGHT + "require r: odd(main) < 300\n"),
    _Place(RoadNumber, "range", STRAIGHT + "require r: odd(main) < 300\n"),
    _Place(Monitor, "robustness", STRAIGHT + "require calm with odd\n"),
    _Place(
        DriveSignal,
        "values_in",
        _EGO.replace("odd", "stanley") + "expect e: always (odd() < 1)\n",
        (),
        (("member", False),),
    ),
    _Place(JunctionControl, "right_of_way", _FOUND[:-3] + "\n  control with odd }\n", _PHASES),
    _Place(Position, "lane_places", _FOUND + "agent a is car on town at odd()\n"),
    _Place(Extractor, "extract", _TOWN + "network town from plan { extract with odd }\n"),
    _Place(Controller, "control", _EGO, (Control(0.1, 1.0), Control(0.0, float("nan")))),
    _Place(Controller, "controls", _EGO),
    _Place(Controller, "start", _EGO),
    _Place(
        Controller,
        "initial_speed",
        _EGO,
        (InitialSpeed(9.0), InitialSpeed(-9.0), InitialSpeed(float("nan"))),
    ),
)


def odd_kind_lines() -> Iterator[str]:
    """Each method with each result: the message, or where things are then."""
    for place in _PLACES:
        yield f"{place.base.__name__}.{place.method}:"
        said: dict[str, list[str]] = {}
        for gives in (*_ANY, *place.results, ValueError("boom")):
            found = " | ".join(_outcome(place.text, _kind(place, gives)))
            said.setdefault(found, []).append(_name(gives))
        for found, results in said.items():
            yield f"  {' '.join(results)}: {found}"


def _name(gives: Any) -> str:
    if isinstance(gives, Curve):
        return "Curve"
    return repr(gives).replace("\n", " ").replace(" ", "")


def _kind(place: _Place, gives: Any) -> type[Kind]:
    """A kind called `odd` whose method gives this, or raises it."""

    def odd(*_: Any, **__: Any) -> Any:
        if isinstance(gives, Exception):
            raise gives
        return gives

    still = next((m for base, m in _STILL.items() if issubclass(place.base, base)), {})
    of_road = place.base in (Signal, RoadNumber)
    body: dict[str, Any] = {**still, **dict(place.members), "name": "odd", "__doc__": "Odd."}
    is_shared = place.method in ("range", "dimension_of")
    body[place.method] = classmethod(odd) if is_shared else odd
    annotations = dict.fromkeys(dict(place.members), ClassVar[Any]) | {"name": ClassVar[str]}
    namespace = {**body, "__annotations__": annotations}
    fields = [("road", RoadName)] if of_road else []
    return make_dataclass("Odd", fields, bases=(place.base,), namespace=namespace, frozen=True)


def _outcome(text: str, kind: type[Kind]) -> Iterator[str]:
    try:
        scene = testing.sample(text, 1, kinds=[kind])[0]
        record = scene.record
        for road in record.roads[:2]:
            yield f"{road.name} {array([*road.x, *road.y, *road.width])}"
        for thing in (*record.agents, *record.objects):
            pose = (thing.x, thing.y, thing.heading, thing.start_speed or 0.0)
            yield f"{thing.name} {array(pose)}"
        for network in record.networks:
            yield f"control {[junction.control.kind for junction in network.junctions]}"
        if record.agents:
            drive = scene.run(duration=0.5)
            for agent in drive.trace.agents.values():
                yield array([*agent.x.tolist(), *agent.y.tolist(), *agent.speed.tolist()])
            yield f"{[v.robustness for v in drive.verdicts.values()]}"
            yield from (_said(found) for found in drive.diagnostics)
    except NoSceneError:
        yield "no scene"
    except DiagnosticError as error:
        yield from (_said(found) for found in error.diagnostics[:2])
    except Exception:  # noqa: BLE001 - what is not reported is what is compared
        yield "an exception, no diagnostic"


def _said(found: Any) -> str:
    place = f"{found.span.line}:{found.span.column} " if found.span is not None else ""
    said = f"{place}{found.code} {found.message} / {' / '.join(found.help)}"
    said = _REASON.sub(r"): \1 / this", said)  # its words differ from Python to Python
    return _PLACE_OF_CODE.sub("(FILE)", said).replace("\n", " / ")
