"""Writers of scenes in the formats of other tools."""
