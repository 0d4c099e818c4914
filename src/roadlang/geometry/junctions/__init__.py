"""Junctions as places: their area, how far they trim the roads, and the connections of lanes.

`plan.plan_junctions` makes a `model.JunctionPlan` of a network. This is the only package that
imports shapely, and only when a plan is made.
"""
