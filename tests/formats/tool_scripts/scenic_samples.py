"""Samples Scenic programs: {"programs": [paths], "samples": n} on the standard input.

Answers for each program with its error, or with the draws that its samples took, and the lanes of
its objects: the id that OpenDRIVE has for the lane, and how far (radians) the object's heading is
from the lane's direction; null for none.
"""

import json
import math
import sys
import warnings

import scenic

warnings.simplefilter("ignore")


def lane_of(thing, network):
    section = network.laneSectionAt(thing.position)
    if section is None:
        return None
    turn = thing.heading - float(section.orientation[thing.position].yaw)
    return [section.openDriveID, abs(math.remainder(turn, math.tau))]


def sampled(path, count):
    scenario = scenic.scenarioFromFile(path, mode2D=True)
    draws = 0
    for _ in range(count):
        scene, tries = scenario.generate(maxIterations=20)
        draws += tries
    network = scene.workspace.network
    return {
        "draws": draws,
        "lanes": {thing.name: lane_of(thing, network) for thing in scene.objects},
    }


question = json.load(sys.stdin)
answers = {}
for program in question["programs"]:
    try:
        answers[program] = sampled(program, question["samples"])
    except Exception as error:  # noqa: BLE001 - whatever Scenic says is the answer
        answers[program] = {"error": f"{type(error).__name__}: {error}"}
print(json.dumps(answers))
