"""The transports whose packages may be missing."""

from __future__ import annotations

from roadlang.api import Code

from ..faults import fault
from .link import DatagramLink


def websocket_link(host: str, port: int) -> DatagramLink:
    """A WebSocket to an engine. Raises RL516 where the package for it is missing."""
    try:
        from .link_websocket import WebSocketLink
    except ImportError as error:
        raise fault(Code.WEBSOCKETS_MISSING, help='pip install "roadlang[websocket]"') from error
    return WebSocketLink(host, port)
