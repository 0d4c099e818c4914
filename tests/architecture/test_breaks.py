"""Each rule is noticed when it is broken on purpose in a copy of the sources."""

from __future__ import annotations

import pytest

from tests.architecture import rules
from tests.architecture.rules import Rule
from tests.architecture.source_tree import source_tree

SOURCES = source_tree()
KIND = "plugins/standard/roadlang_standard/perturb_sine.py"
EXTRACTION = "plugins/standard/roadlang_standard/extraction/"
BREAKS: tuple[tuple[Rule, str, str], ...] = (
    (rules.packages_import_downward, "geometry/curves/curve.py", "from ...diagnostics import Code"),
    (
        rules.packages_import_downward,
        "stl/formula/terms.py",
        "def f():\n    from ...world import roads",
    ),
    (rules.packages_import_downward, "geometry/curves/width.py", "from roadlang import world"),
    (
        rules.packages_import_downward,
        "geometry/lanes/road.py",
        "import importlib\nimportlib.import_module('roadlang.world.roads.roads')",
    ),
    (rules.packages_import_downward, "ir/units.py", "__import__('roadlang.scenes.sampling')"),
    (
        rules.packages_import_downward,
        "world/roads/roads.py",
        "from importlib import import_module\nimport_module('...scenes.sampling', __package__)",
    ),
    (
        rules.packages_import_downward,
        "world/roads/roads.py",
        "import importlib\nimportlib.import_module('roadlang.' + 'scenes')",
    ),
    (rules.subpackages_import_downward, "world/lanes/lane_plan.py", "from ..roads import roads"),
    (rules.subpackages_import_downward, "geometry/curves/curve.py", "from .. import networks"),
    (
        rules.subpackages_import_downward,
        EXTRACTION + "colors/tones.py",
        "from ..masks.mask_parts import parts_of",
    ),
    (
        rules.subpackages_import_downward,
        EXTRACTION + "maps/map_roads.py",
        "def f():\n    from ..pixels import pixels_of",
    ),
    (rules.the_core_imports_no_kind_and_no_api, "semantics/check.py", "from ..api import option"),
    (rules.the_core_imports_no_kind_and_no_api, "cli/main.py", "from .. import api"),
    (
        rules.the_core_imports_no_kind_and_no_api,
        "cli/main.py",
        "import roadlang_standard.agent_car",
    ),
    (
        rules.the_core_imports_no_kind_and_no_api,
        "session/loading.py",
        "def f():\n    from roadlang_godot.engines import engine",
    ),
    (rules.third_parties_are_those_of_the_table, "geometry/curves/curve.py", "import click"),
    (rules.third_parties_are_those_of_the_table, "semantics/check.py", "import numpy as np"),
    (rules.third_parties_are_those_of_the_table, "world/roads/roads.py", "import yaml"),
    (
        rules.polygons_are_joined_in_one_package,
        "geometry/lanes/road.py",
        "def f():\n    import shapely",
    ),
    (rules.polygons_are_joined_in_one_package, "geometry/junctions/area.py", "import shapely"),
    (
        rules.private_names_stay_in_their_file,
        "world/roads/roads.py",
        "from ..networks.networks import _root",
    ),
    (
        rules.private_names_stay_in_their_file,
        "scenes/roads.py",
        "from ..world.networks import networks\nnetworks._root(None, None)",
    ),
    (rules.private_names_stay_in_their_file, "scenes/roads.py", "from .actors import _CAR"),
    (
        rules.private_names_stay_in_their_file,
        "search/rejection_sampling.py",
        "def f(candidates):\n    return candidates._computed",
    ),
    (
        rules.no_circles,
        "world/perturbing/stations.py",
        "def f():\n    from ..roads.roads import road_batch",
    ),
    (rules.no_circles, "geometry/networks/network.py", "def f():\n    from .joints import joined"),
    (rules.no_circles, "session/scene.py", "def f():\n    from .reports import report"),
    (
        rules.no_circles,
        "evaluate/randomness.py",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from .candidates import T",
    ),
    (
        rules.no_clock_and_no_global_random_numbers,
        KIND,
        "import time\ndef now():\n    return time.time()",
    ),
    (
        rules.no_clock_and_no_global_random_numbers,
        "world/roads/roads.py",
        "from datetime import datetime\ndatetime.now()",
    ),
    (rules.no_clock_and_no_global_random_numbers, "search/guiding.py", "import random"),
    (rules.no_clock_and_no_global_random_numbers, "world/roads/roads.py", "np.random.normal(3)"),
    (
        rules.no_clock_and_no_global_random_numbers,
        "plugins/formats/roadlang_formats/read_geojson.py",
        "np.random.rand(3)",
    ),
    (
        rules.no_clock_and_no_global_random_numbers,
        "world/roads/roads.py",
        "np.random.default_rng()",
    ),
    (rules.shipped_kinds_use_the_public_api, KIND, "from roadlang.ir.batch import RoadBatch"),
    (
        rules.shipped_kinds_use_the_public_api,
        "plugins/godot/roadlang_godot/engines/engine.py",
        "def f():\n    import roadlang.world.roads.roads",
    ),
    (
        rules.packages_that_compute_read_no_files,
        "geometry/lanes/road.py",
        "open('road.csv').read()",
    ),
    (
        rules.packages_that_compute_read_no_files,
        "evaluate/evaluation.py",
        "from pathlib import Path",
    ),
    (
        rules.packages_that_compute_read_no_files,
        "stl/evaluate/sliding_and_until.py",
        "np.load('kernels.npy')",
    ),
    (
        rules.the_core_names_no_shipped_kind,
        "world/networks/networks.py",
        "DEFAULT = 'standard.auto'",
    ),
    (rules.the_core_names_no_shipped_kind, "search/effort.py", "CHEAP = ('sine', 'bump')"),
    (rules.the_core_names_no_shipped_kind, "scenes/emitting.py", "FIRST = 'svg'"),
    (rules.files_and_functions_are_small, "world/new.py", "\n" * rules.MOST_LINES),
    (
        rules.files_and_functions_are_small,
        "world/roads/roads.py",
        "def f():\n" + "    pass\n" * rules.MOST_FUNCTION_LINES,
    ),
    (rules.every_file_says_what_it_is_for, "world/__init__.py", ""),
)


@pytest.mark.parametrize(("rule", "path", "lines"), BREAKS)
def test_a_break_is_noticed(rule: Rule, path: str, lines: str) -> None:
    full = path if path.startswith("plugins/") else f"src/roadlang/{path}"
    broken = SOURCES.with_lines(full, lines) if lines else SOURCES.with_text(full, "")
    assert any(full in fault or _module(full) in fault for fault in rule(broken))


def _module(path: str) -> str:
    return path.removeprefix("src/").removesuffix(".py").replace("/", ".")
