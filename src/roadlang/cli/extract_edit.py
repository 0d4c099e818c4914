"""`roadlang extract IMAGE --edit SCENE`: the page on which roads are corrected by hand."""

from __future__ import annotations

import os
from pathlib import Path
from threading import Thread

import click

from .console import echo, note


def edit_roads(image: str, scene: str, scale: float | None, opens_browser: bool) -> None:
    """Serve the page until it is closed there, or by Ctrl-C here. A scene file that does not exist
    is written first."""
    from secrets import token_urlsafe

    from ..correcting.picture_roads import PictureRoads
    from ..correcting.server import CorrectionServer

    path = Path(scene)
    if not os.path.exists(path):
        _write_scene(path, image, scale)
    elif scale is not None:
        raise click.UsageError("`--scale` is for a new scene file; this one has its own scale.")
    roads = PictureRoads.of(path, Path(image))
    with CorrectionServer(roads, token_urlsafe(16)) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        echo(server.address)
        note("close the page in the browser, or press Ctrl-C here, when you are done")
        if opens_browser:
            import webbrowser

            webbrowser.open(server.address)
        try:
            server.done.wait()
        except KeyboardInterrupt:
            note("closed")
        finally:
            server.shutdown()
    if server.fault is not None:
        raise server.fault


def _write_scene(path: Path, image: str, scale: float | None) -> None:
    """A scene file of two lines: the picture, and the network of its roads."""
    from ..files.writing import write_file
    from ..images.image_file import open_image

    known = open_image(Path(image), image, None).scale
    if scale is None and known is None:
        raise click.UsageError(
            f"the size of a pixel of {image} is not known: give it with `--scale`, in meters."
        )
    stated = "" if scale is None else f" {{ scale: {scale:g}m/px }}"
    name = os.path.relpath(image, path.parent).replace(os.sep, "/")
    write_file(path, f'image photo from "{name}"{stated}\nnetwork town from photo\n')
    note(f"wrote {path}")
