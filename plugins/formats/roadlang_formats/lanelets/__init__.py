"""A scene as lanelets: parts of lanes with a left and a right border, and how they are linked."""
