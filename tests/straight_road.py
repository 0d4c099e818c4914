"""The simplest road: 200 m to the east, 8 m wide."""

STRAIGHT = """
road main { draw with waypoints { points: [(0m, 0m), (100m, 0m), (200m, 0m)] }, width: 8m }
"""
