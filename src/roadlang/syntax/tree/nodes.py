"""The whole syntax tree under one name: `from ..tree import nodes as ast`."""

from .blocks import *  # noqa: F403
from .expressions import *  # noqa: F403
from .statements import *  # noqa: F403
