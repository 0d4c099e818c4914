# Groups whose copies are placed by numbers of the copies of other groups, and by draws of their own.
scenario copies "Copies"

road main { draw with segments { pieces: [straight(150m), arc(80m, 40deg), straight(60m)] }, lanes: 2 }
param first = 10m..20m

agent ego is car on main at first { lane: -1 }
agent row is choice(car, van) on main at 40m { lane: -1, count: 3, spacing: 9m..12m }
agent beyond is bicycle on main at row.start + 3m { count: 3, lane: 1, overlap: true }
agent nobody is car on main at 9m { count: 0 }
object cones is cone on main at row.start / 2 + 90m { count: 3, offset: 0.4m * 2, overlap: true }
object posts is sign on main at min(row.start + ego.start, 100m) + 20m { count: 2, side: right, offset: 1m..2m }
object boxes is choice(box, rock) on main at beyond.start * 2 - cones.start / 4 + 30m {
  count: integer(1, 3)
  length: choice(0.5m, 0.6m..0.9m)
  overlap: true
}
object last is tree on main at max(row.start, ego.start + 60m) { side: left, offset: 2m, overlap: true }

require apart: row.start > ego.start + 9m
require lane: row.start_lane < 0 and gap(ego, cones) > 20m
expect far: distance(row, posts) > 1m
expect close: gap(row, beyond) < 30m
