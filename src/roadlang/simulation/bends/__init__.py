"""The ground that long vehicles cover in bends, and how they make room for it."""
