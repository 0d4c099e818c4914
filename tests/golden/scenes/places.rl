# Agents and objects in a network: by points, shares, junctions, rows, beside, ahead and behind.
scenario places "Places in a network"

image plan from """
  ....#......
  ....#......
  ####.......
  ....#######
  ....#...#..
  ....#...###
  ....#......
""" { scale: 16m/px, legend: { "#": road } }
network town from plan {
  left: [drive(3.2m), parking(2m), sidewalk(1.5m)]
  right: [drive(3.2m), drive(3m), bike(1.5m)]
  speed_limit: 30km/h
  control with signals { green: 8s }
}
world { traffic: left }

agent ego is car on town at (110m, 56m)
agent ahead is van on town at ahead_of(ego, 10m)
agent behind is car on town at behind(ego, 3m) { overlap: true }
agent near is motorcycle on town at beside(ego, right) { overlap: true }
agent waiting is car on town at junction(3, before: 4m) { overlap: true }
agent row is choice(car, van) on town at (160m, 56m) { count: 3, spacing: 8m..9m, overlap: true }
agent queue is car on town at (75m, 30m) { count: 3, spacing: 9m, lane: outer, overlap: true }
agent rider is bicycle on town at (140m, 55m) { lane: bike, overlap: true }
agent riders is bicycle on town at random { count: 3, lane: bike, overlap: true }
agent walker is pedestrian on town at (70m, 20m) { side: right, offset: 0.5m, overlap: true }
agent crowd is pedestrian on town at random { count: 4, side: left, offset: 0.2m..1m, overlap: true }
object parked is parked_car on town at (30m, 60m) { lane: parking, count: 3, spacing: 6m..7m, overlap: true }
object cones is cone on town at random { count: 3, lane: none, offset: -1m..1m, overlap: true }
object post is sign on town at (72m, 5m) { side: right, offset: 1m, overlap: true }
object tail is barrier on town at ahead_of(parked, 6m) { overlap: true }

expect gap_to_bus: gap(ego, behind) > 1m
expect first_lane: ego.start_lane != 0
