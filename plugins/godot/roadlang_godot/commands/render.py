"""`roadlang render FILE`: a scene as a picture, a clip, a 3D file or labeled pictures, by Godot."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import click

from roadlang.commands import Seed, WholeNumber, echo, pixel_size, report, seconds

if TYPE_CHECKING:
    from roadlang import LoadedScenario

PICTURES = {".png": "png", ".jpg": "jpg", ".jpeg": "jpg"}
CLIPS = (".avi", ".mp4")
EXPORTS = {".tscn": "tscn", ".glb": "glb"}
MOST_SECONDS = 3600.0
"""The longest drive."""


@click.command("render")
@click.argument("file")
@click.option(
    "-o",
    "--output",
    metavar="FILE",
    help="Output file: `.png`, `.jpg`, `.avi`, `.mp4`, `.glb` (glTF) or `.tscn` (Godot).",
)
@click.option(
    "--dataset",
    metavar="DIR",
    help="Output folder of labeled pictures, taken by the cameras of the scene during its drive.",
)
@click.option(
    "-n",
    "count",
    type=WholeNumber(1, 1_000_000),
    default=50,
    show_default=True,
    help="Number of moments in the dataset.",
)
@click.option(
    "--every",
    type=seconds(min=0.01, max=MOST_SECONDS),
    default=0.5,
    show_default=True,
    help="Time between two moments, in seconds.",
)
@click.option("--clips", is_flag=True, help="Also write the dataset's color images as clips.")
@click.option(
    "--scenes",
    type=WholeNumber(1, 1_000_000),
    default=1,
    show_default=True,
    help="Number of scenes among which the moments are divided.",
)
@click.option(
    "--view",
    type=click.Choice(["chase", "top", "free"]),
    help="Camera; by default that of --agent (chase), --scale (top) or --camera (free), else "
    "`chase`, or `top` if there is no agent.",
)
@click.option(
    "--size",
    metavar="WxH",
    help="Image size in pixels; by default 1280x720, or 640x360 in a dataset.",
)
@click.option(
    "--scale", type=pixel_size(min=1e-4, max=1e4), help="Scale of the top view, such as 0.5m/px."
)
@click.option(
    "--at",
    "time",
    type=seconds(min=0, max=MOST_SECONDS),
    help="Time in the drive at which to render, in seconds.",
)
@click.option(
    "--duration",
    type=seconds(min=0, max=MOST_SECONDS),
    default=6.0,
    show_default=True,
    help="Duration of a clip in seconds.",
)
@click.option(
    "--fps",
    type=WholeNumber(1, 60),
    default=12,
    show_default=True,
    help="Frames per second of a clip.",
)
@click.option("--agent", help="Agent that the chase view follows; by default the first.")
@click.option(
    "--camera", metavar="X,Y,Z,YAW,PITCH", help="Camera of the free view, in meters and degrees."
)
@click.option(
    "--road", type=click.Choice(["mesh", "tiles"]), default="mesh", help="How to build the road."
)
@click.option("--scene", "index", type=WholeNumber(min=0), default=0, help="Number of the scene.")
@click.option("--seed", type=Seed(), default=0, show_default=True, help="Random seed.")
@click.option(
    "--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set the value of a param."
)
def command(
    file: str,
    output: str | None,
    dataset: str | None,
    settings: tuple[str, ...],
    **options: Any,
) -> None:
    """Render scenes of FILE as an image, a clip, a 3D file or labeled images.

    A chase view follows an agent, the top view shows the whole scene from above with north up,
    the free view looks from anywhere. Without a screen a virtual one is used. A 3D file holds the
    scene as Godot shows it, and opens without roadlang.

    With --dataset, the cameras of the scene (`sense with camera`), or a front camera of `ego` if
    there is none, take pictures during the drive: color, depth, classes and instances, each with
    boxes of all agents and objects. If drives end early, more scenes are sampled.
    """
    from roadlang import load
    from roadlang.commands import parse_overrides

    from .render_options import refuse_unused

    if bool(output) == bool(dataset):
        raise click.UsageError("give either an output file with `-o`, or a folder with `--dataset`")
    refuse_unused(_written(_suffix(output)) if output else "dataset")
    loaded = load(file).with_params(parse_overrides(settings))
    if output:
        _render_file(loaded, output, options)
    elif dataset:
        _render_dataset(loaded, dataset, options)


def _render_dataset(loaded: LoadedScenario, folder: str, options: Mapping[str, Any]) -> None:
    from pathlib import Path

    from roadlang_godot.commands.render_dataset import write_labeled
    from roadlang_godot.rendering.labeled_frames import Sampling

    from .render_options import image_size

    if options["scenes"] > options["count"]:
        raise click.UsageError(f"--scenes {options['scenes']} needs as many moments: -n is too low")
    size = image_size(options["size"], "640x360")
    sampling = Sampling(options["time"] or 0.0, options["every"], size, options["road"])
    moments, pictures = write_labeled(
        loaded, Path(folder).absolute(), sampling, options["count"], options["scenes"],
        options["seed"], options["clips"],
    )  # fmt: skip
    echo(f"{folder}: {moments} moments, {pictures} labeled pictures")


def _render_file(loaded: LoadedScenario, output: str, options: Mapping[str, Any]) -> None:
    from pathlib import Path

    from roadlang.commands import python_controllers, write_file
    from roadlang_godot.rendering.exported_scenes import export_scene
    from roadlang_godot.rendering.pictures import Shot, render_clip, render_picture

    from .render_options import camera_pose, chosen_view, image_size

    path, suffix = Path(output).absolute(), _suffix(output)
    scenes = loaded.sample(options["index"] + 1, seed=options["seed"])
    report(scenes.diagnostics)
    scene, road, time = scenes[-1].record, options["road"], options["time"]
    controllers = python_controllers(scene, loaded.registry, loaded.places)
    if suffix in EXPORTS:
        write_file(path, export_scene(scene, EXPORTS[suffix], road, time or 0.0, controllers))
        echo(output)
        return
    pose = None if options["camera"] is None else camera_pose(options["camera"])
    view = chosen_view(options, bool(scene.agents))
    _expect_agent(view, options["agent"], [one.name for one in scene.agents])
    shot = Shot(view, *image_size(options["size"], "1280x720"), options["scale"], options["agent"],
                pose, PICTURES.get(suffix, "jpg"), road)  # fmt: skip
    if suffix in CLIPS:
        frames = render_clip(
            scene, shot, path, options["duration"], options["fps"], time or 0.0, controllers
        )
        echo(f"{output}: {frames} frame{'' if frames == 1 else 's'}")
        return
    moment = (0.0 if view == "top" else 4.0) if time is None else time
    write_file(path, render_picture(scene, shot, moment, controllers))
    echo(f"{output}: {shot.width} x {shot.height}")


def _written(suffix: str) -> str:
    return "3D file" if suffix in EXPORTS else "clip" if suffix in CLIPS else "picture"


def _suffix(output: str) -> str:
    from pathlib import PurePath

    from roadlang.commands import Code, DiagnosticError, diagnose

    suffix = PurePath(output).suffix.lower()
    if suffix not in PICTURES and suffix not in CLIPS and suffix not in EXPORTS:
        help = "name a file that ends in .png, .jpg, .avi, .mp4, .glb or .tscn"
        raise DiagnosticError(
            diagnose(Code.UNKNOWN_CHOICE, what="output format", name=suffix, help=help)
        )
    return suffix


def _expect_agent(view: str, wanted: str | None, names: list[str]) -> None:
    """A chase view follows an agent of the scene."""
    from roadlang.commands import Code, DiagnosticError, diagnose

    if view != "chase":
        return
    if not names:
        message = "the scene has no agent to follow: choose `top` or `free`"
        raise click.BadParameter(message, param_hint="--view")
    if wanted is not None and wanted not in names:
        help = f"agents of this scene: {', '.join(names[:12])}"
        raise DiagnosticError(diagnose(Code.UNKNOWN_CHOICE, what="agent", name=wanted, help=help))
