"""Every example compiles, and the pictures among them have the truth that is stored beside them."""

from __future__ import annotations

import importlib.util
import json
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import cv2
import jsonschema
import numpy as np
import pytest

from roadlang.cli.main import run
from roadlang.ir.scene_schema import scene_schema

EXAMPLES = Path(__file__).parents[2] / "examples"
SCENES = sorted(EXAMPLES.rglob("*.rl"))


@pytest.mark.slow
@pytest.mark.parametrize("path", SCENES, ids=lambda p: p.relative_to(EXAMPLES).as_posix())
def test_an_example_compiles_to_valid_json_and_svg(path: Any, tmp_path: Path) -> None:
    # Examples for an engine emit to it; what they emit is tested where that engine is.
    assert run(["compile", str(path), "-o", str(tmp_path), "-n", "1", "--emit", "json,svg"]) == 0
    (scene,) = tmp_path.glob("scene-*.json")
    jsonschema.validate(json.loads(scene.read_text()), scene_schema())
    assert scene.with_suffix(".svg").read_text().startswith("<?xml")


@pytest.mark.parametrize("path", SCENES, ids=lambda p: p.relative_to(EXAMPLES).as_posix())
def test_an_example_is_in_the_one_layout_and_says_what_it_is_for(path: Any) -> None:
    assert run(["fmt", "--check", str(path)]) == 0
    assert path.read_text(encoding="utf-8").startswith("# ")


@pytest.fixture(scope="module")
def script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("make_pictures", EXAMPLES / "make_pictures.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.mark.slow
@pytest.mark.parametrize("name", ["hairpin", "village"])
def test_a_picture_is_what_the_script_makes(name: str, script: ModuleType) -> None:
    made = script.PHOTOS[name]()
    stored = cv2.imread(str(EXAMPLES / f"{name}.jpg"))
    assert stored.shape == made.image.shape
    # JPEG loses a little, and its libraries differ a little.
    assert np.abs(stored.astype(int) - made.image.astype(int)).mean() < 8
    truth = json.loads((EXAMPLES / f"{name}.truth.json").read_text())
    assert truth == json.loads(json.dumps(script.truth_of(made)))


def test_the_drawn_town_is_what_the_script_makes(script: ModuleType) -> None:
    assert (cv2.imread(str(EXAMPLES / "town.png")) == script.drawn_town()).all()
