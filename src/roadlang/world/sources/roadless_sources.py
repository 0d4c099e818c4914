"""What to do about a picture or file in which there is no road."""

from __future__ import annotations

from ...evaluate.candidates import CandidateBatch
from ...ir.scenario import FileSource, ScenarioImage, ScenarioNetwork, TextSource


def advice_without_roads(network: ScenarioNetwork, candidates: CandidateBatch) -> str:
    """A sentence for the author of the scene file."""
    if isinstance(network.source, FileSource):
        return f"`roadlang view {network.source.path}` shows what is in the file"
    image = candidates.scenario.source_of(network)
    if isinstance(image, ScenarioImage) and isinstance(image.source, TextSource):
        if image.options.get("legend"):
            return "draw some with the character that the `legend` calls `road`"
        return 'say which characters are roads: `legend: { "#": road }`'
    return (
        "choose an extractor: `extract with contour` for a drawing, `extract with aerial` for a "
        "photo; `roadlang extract IMAGE --overlay FILE` shows what was found"
    )
