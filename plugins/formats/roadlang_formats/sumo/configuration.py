"""The configuration with which SUMO runs a scene."""

from __future__ import annotations

from xml.etree.ElementTree import Element, indent, tostring

from ..opendrive.elements import put


def configuration_text(network: str, routes: str, additional: str | None, step: float) -> str:
    """The `.sumocfg`: names of the files, and the time step (s). It ends when all have arrived."""
    root = Element("sumoConfiguration")
    files = put(root, "input")
    put(files, "net-file", value=network)
    put(files, "route-files", value=routes)
    if additional is not None:
        put(files, "additional-files", value=additional)
    time = put(root, "time")
    put(time, "begin", value=0)
    put(time, "step-length", value=step)
    indent(root, " ")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{tostring(root, encoding="unicode")}\n'
