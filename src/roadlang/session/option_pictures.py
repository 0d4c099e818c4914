"""Options that take a picture, from Python: by the name of an image, or the picture itself."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ..diagnostics import Code, DiagnosticError, diagnose, did_you_mean
from ..diagnostics.arguments import shown
from ..plugins.guard import plugin_guard
from ..plugins.option_types import EntityType

if TYPE_CHECKING:
    from ..evaluate.indexed_scenario import IndexedScenario
    from ..ir.picture import Picture
    from ..plugins.registry import KindEntry
    from .loading import LoadedScenario


def with_pictures(
    options: Mapping[str, Any], entry: KindEntry, loaded: LoadedScenario | None
) -> dict[str, Any]:
    """The options of a kind, with the `Picture` in the place of each name of an image, or of a
    network or road that is made from one.

    `loaded` is where the names are declared; None for a scene from JSON, which has no pictures.
    Raises `DiagnosticError`: RL101 for an unknown name, RL206 for anything else, RL229 for an
    image that differs between scenes.
    """
    from ..ir.picture import Picture

    found = dict(options)
    with plugin_guard(entry, None):
        schemas = entry.options
    for schema in schemas:
        value = options.get(schema.name)
        if schema.type != EntityType(("image",)) or value is None or isinstance(value, Picture):
            continue
        if isinstance(value, str) and loaded is not None:
            found[schema.name] = _named(value, loaded)
        else:
            raise _wrong_type(schema.name, value, loaded)
    return found


def _named(name: str, loaded: LoadedScenario) -> Picture:
    from ..ir.scenario import ScenarioImage
    from ..scenes.emitting import fixed_picture
    from ..world.index import index_scenario

    scenario = index_scenario(loaded.scenario, loaded.registry)
    known = (*scenario.images, *scenario.networks, *scenario.roads)
    if name not in known:
        help_ = did_you_mean(name, scenario.images) or _images_of(scenario)
        raise DiagnosticError(diagnose(Code.UNKNOWN_NAME, name=name, help=help_))
    for link in scenario.chain(scenario.declaration(name)):
        if isinstance(link, ScenarioImage):
            return fixed_picture(link.name, scenario)
    help_ = _images_of(scenario)
    raise DiagnosticError(
        diagnose(
            Code.WRONG_TYPE,
            what=f"`{name}`",
            expected="an image",
            found="a road or network without one",
            help=help_,
        )
    )


def _images_of(scenario: IndexedScenario) -> str:
    names = ", ".join(f"`{name}`" for name in scenario.images)
    return f"its images are {names}" if names else "the scenario has no image"


def _wrong_type(option: str, value: object, loaded: LoadedScenario | None) -> DiagnosticError:
    names = "" if loaded is None else "the name of an image, or "
    help_ = (
        () if loaded is not None else "a scene from JSON has no pictures; sample it to use names"
    )
    return DiagnosticError(
        diagnose(
            Code.WRONG_TYPE,
            what=f"`{option}`",
            expected=f"{names}a `roadlang.api.Picture`",
            found=shown(value),
            help=help_,
        )
    )
