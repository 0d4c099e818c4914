"""From pictures to road networks: what the `extract` kinds share."""
