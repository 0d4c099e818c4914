"""Files of `emit opendrive`, judged by the tools of others."""
