# Halton sampling with a left-hand road.
scenario halton "Halton"
world { traffic: left }
param a = 10m..40m
param b = -1..1
road main { draw with segments { pieces: [straight(a), arc(60m, 40deg), straight(100m)] } lanes: 3 }
agent ego is car on main at 10m { drive with lane_follow { speed: 9m/s } }
agent group is bicycle on main at a { count: 2, spacing: 6m, facing: back }
require positive: b > -0.5
sample with halton
emit json
emit svg
