"""Train the road net that ships with the extractor, from renderings alone."""
