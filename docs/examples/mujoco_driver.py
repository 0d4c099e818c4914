"""Drives the car of a model that `emit mujoco` wrote along its lane, by pure pursuit.

    python mujoco_driver.py scene-0000.mjcf.xml

Needs the Python package `mujoco`. Prints the greatest distance of the car's center from the
line that it follows, and the share of the line that it drove.
"""

import sys

import mujoco
import numpy as np

LATERAL = 1.5
"""Acceleration in bends, m/s^2."""
BRAKING = 2.0
"""Acceleration before bends, m/s^2."""


def numbers(model, name):
    """The values of a `numeric` element."""
    at = model.numeric(name).adr[0]
    return model.numeric_data[at : at + model.numeric(name).size[0]]


def speeds(path, station, fastest):
    """(n,) m/s at the points of a path (n, 2), slow enough for its bends."""
    heading = np.unwrap(np.arctan2(*np.gradient(path, axis=0).T[::-1]))
    bend = np.abs(np.gradient(heading, station))
    found = np.minimum(fastest, np.sqrt(LATERAL / np.maximum(bend, 1e-6)))
    for at in range(len(found) - 2, -1, -1):
        step = station[at + 1] - station[at]
        found[at] = min(found[at], np.sqrt(found[at + 1] ** 2 + 2.0 * BRAKING * step))
    return found


def drive(model, clear=True, seconds=600.0):
    """The greatest distance to the line (meters) and the share of the line that was driven, of
    all but the last meter.

    `clear`: the other agents, which are mocap bodies, are lifted out of the way first.
    """
    data = mujoco.MjData(model)
    if clear:
        data.mocap_pos[:, 2] += 100.0
    mujoco.mj_forward(model, data)
    path = np.column_stack((numbers(model, "path x"), numbers(model, "path y")))
    station = np.concatenate(([0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))))
    wanted = speeds(path, station, numbers(model, "speed")[0])
    wheelbase, radius = numbers(model, "wheelbase")[0], numbers(model, "wheel radius")[0]
    (free,) = np.flatnonzero(model.jnt_type == mujoco.mjtJoint.mjJNT_FREE)
    car = data.body(model.jnt_bodyid[free])
    steering = data.actuator(f"{car.name} steering")
    motor = data.actuator(f"{car.name} drive")
    every = max(1, round(0.02 / model.opt.timestep))
    at, farthest = 0.0, 0.0
    while data.time < seconds and at < station[-1] - 1.0:
        place, turn = car.xpos[:2], car.xmat.reshape(3, 3)
        along = np.linspace(at, min(at + 5.0, station[-1]), 101)
        near = np.column_stack([np.interp(along, station, column) for column in path.T])
        away = np.hypot(*(near - place).T)
        at, farthest = along[away.argmin()], max(farthest, away.min())
        speed = float(car.cvel[3:5] @ turn[:2, 0])
        # Between the rear axle, for which the formula holds, and the middle, which is to be near.
        behind = place - 0.3 * wheelbase * turn[:2, 0]
        # Far enough to begin to turn before a bend that is as tight as the car can turn.
        ahead = at + max(1.6, 0.4 * speed) + 0.3 * wheelbase
        target = np.array([np.interp(ahead, station, column) for column in path.T])
        if ahead > station[-1]:
            last = (path[-1] - path[-2]) / (station[-1] - station[-2])
            target = target + (ahead - station[-1]) * last
        to = target - behind
        steering.ctrl = np.arctan(2.0 * wheelbase * float(to @ turn[:2, 1]) / (to @ to))
        wish = np.interp(at + 0.3 * speed, station, wanted)
        motor.ctrl = np.clip(wish, speed - 4.0, speed + 3.0) / radius
        for _ in range(every):
            mujoco.mj_step(model, data)
    return farthest, min(at / max(station[-1] - 1.0, 1e-9), 1.0)


def main():
    """Drives in each of the models that are named."""
    for name in sys.argv[1:]:
        farthest, share = drive(mujoco.MjModel.from_xml_path(name))
        print(f"{name}: {farthest:.2f} m from the line at most, {share:.0%} of it driven")


if __name__ == "__main__":
    main()
