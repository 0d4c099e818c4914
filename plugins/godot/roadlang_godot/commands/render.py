"""`roadlang render FILE -o OUTPUT`: a scene as a picture, a clip or a 3D file, by Godot."""

from __future__ import annotations

from pathlib import Path

import click

from roadlang.commands import Code, DiagnosticError, diagnose, echo, report

PICTURES = {".png": "png", ".jpg": "jpg", ".jpeg": "jpg"}
CLIPS = (".avi",)
EXPORTS = {".tscn": "tscn", ".glb": "glb"}


@click.command("render")
@click.argument("file")
@click.option(
    "-o",
    "--output",
    required=True,
    metavar="FILE",
    help="Output file: `.png`, `.jpg`, `.avi`, `.glb` (glTF) or `.tscn` (Godot).",
)
@click.option(
    "--view",
    type=click.Choice(["chase", "top", "free"]),
    help="Camera; by default `chase`, or `top` if there is no agent.",
)
@click.option(
    "--size", default="1280x720", show_default=True, metavar="WxH", help="Image size in pixels."
)
@click.option("--scale", type=float, help="Meters per pixel of the top view.")
@click.option("--at", "time", type=float, help="Time in the drive at which to render, in seconds.")
@click.option(
    "--duration", type=float, default=6.0, show_default=True, help="Duration of a clip in seconds."
)
@click.option(
    "--fps", type=click.IntRange(1, 60), default=12, show_default=True, help="Frames per second."
)
@click.option("--agent", help="Agent that the chase view follows; by default the first.")
@click.option(
    "--camera", metavar="X,Y,Z,YAW,PITCH", help="Camera of the free view, in meters and degrees."
)
@click.option(
    "--road", type=click.Choice(["mesh", "tiles"]), default="mesh", help="How to build the road."
)
@click.option(
    "--scene", "index", type=click.IntRange(min=0), default=0, help="Number of the scene."
)
@click.option(
    "--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Random seed."
)
@click.option(
    "--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set the value of a param."
)
def command(  # noqa: PLR0913 - one parameter per option
    file: str,
    output: str,
    view: str | None,
    size: str,
    scale: float | None,
    time: float | None,
    duration: float,
    fps: int,
    agent: str | None,
    camera: str | None,
    road: str,
    index: int,
    seed: int,
    settings: tuple[str, ...],
) -> None:
    """Render a scene of FILE as an image, a clip, or a 3D file.

    A chase view follows an agent, the top view shows the whole scene from above with north up,
    the free view looks from anywhere. Without a screen a virtual one is used. A 3D file holds the
    scene as Godot shows it, and opens without roadlang.
    """
    from roadlang import load
    from roadlang.commands import parse_overrides, python_controllers, write_file
    from roadlang_godot.exported_scenes import export_scene
    from roadlang_godot.pictures import Shot, render_clip, render_picture

    path, suffix = Path(output).absolute(), _suffix(output)
    loaded = load(file).with_params(parse_overrides(settings))
    report((scenes := loaded.sample(index + 1, seed=seed)).diagnostics)
    scene = scenes[-1].record
    controllers = python_controllers(scene, loaded.registry)
    if suffix in EXPORTS:
        write_file(path, export_scene(scene, EXPORTS[suffix], road, time or 0.0, controllers))
        return
    pose = _numbers(camera) if camera else None
    view = view or ("chase" if scene.agents else "top")
    shot = Shot(view, *_size(size), scale, agent, pose, PICTURES.get(suffix, "jpg"), road)
    if suffix in CLIPS:
        frames = render_clip(scene, shot, path, duration, fps, time or 0.0, controllers)
        echo(f"{output}: {frames} frames")
        return
    moment = (0.0 if view == "top" else 4.0) if time is None else time
    write_file(path, render_picture(scene, shot, moment, controllers))
    echo(f"{output}: {shot.width} x {shot.height}")


def _suffix(output: str) -> str:
    suffix = Path(output).suffix.lower()
    if suffix not in PICTURES and suffix not in CLIPS and suffix not in EXPORTS:
        help = "end its name in .png, .jpg, .avi, .glb or .tscn"
        raise DiagnosticError(
            diagnose(Code.UNKNOWN_CHOICE, what="output format", name=suffix, help=help)
        )
    return suffix


def _size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    if not (width.isdigit() and height.isdigit() and 16 <= int(width) <= 8192 >= int(height) >= 16):
        raise click.BadParameter(f"`{text}` is no size such as 1280x720", param_hint="--size")
    return int(width), int(height)


def _numbers(text: str) -> tuple[float, ...]:
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != 5:
        raise click.BadParameter("five numbers: x,y,z,yaw,pitch", param_hint="--camera")
    return numbers
