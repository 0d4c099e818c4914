"""Drives the cars of MuJoCo models: {"driver": path, "models": [paths]} on the standard input.

Answers for each model how far from its line the car got (meters) and the share that it drove.
"""

import importlib.util
import json
import sys

import mujoco

question = json.load(sys.stdin)
spec = importlib.util.spec_from_file_location("driver", question["driver"])
driver = importlib.util.module_from_spec(spec)
spec.loader.exec_module(driver)
answers = {path: driver.drive(mujoco.MjModel.from_xml_path(path)) for path in question["models"]}
sys.stdout.write(json.dumps(answers) + "\n")
