"""OpenDRIVE files read: records of what they say, and the network that they describe."""
