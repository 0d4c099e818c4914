"""The state of all agents of many scenes."""
