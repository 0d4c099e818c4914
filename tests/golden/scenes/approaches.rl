# Agents before every junction of a network, from every road, and relative to those.
scenario approaches "Approaches"

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
  left: [drive(3.2m), drive(3m)]
  right: [drive(3.2m), bike(1.5m)]
  speed_limit: 30km/h
  control with stop
}
agent a0 is car on town at junction(1, before: 0m) { overlap: true }
agent b0 is car on town at behind(a0, 2m) { overlap: true }
agent a1 is van on town at junction(1, road: 1, before: 2.5m) { overlap: true }
agent c1 is car on town at ahead_of(a1, 5m) { overlap: true }
agent a2 is bicycle on town at junction(1, road: 2, before: 9m) { overlap: true }
agent d2 is motorcycle on town at beside(a2, left) { overlap: true }
agent a3 is car on town at junction(1, road: 3, before: 40m) { overlap: true }
agent b3 is car on town at behind(a3, 5m) { overlap: true }
agent a4 is van on town at junction(3, before: 200m) { overlap: true }
agent c4 is car on town at ahead_of(a4, 11m) { overlap: true }
agent a5 is bicycle on town at junction(3, road: 3, before: 0m) { overlap: true }
agent a6 is car on town at junction(3, road: 4, before: 2.5m) { overlap: true }
agent b6 is car on town at behind(a6, 8m) { overlap: true }
agent d6 is motorcycle on town at beside(a6, right) { overlap: true }
agent a7 is van on town at junction(3, road: 5, before: 9m) { overlap: true }
agent c7 is car on town at ahead_of(a7, 17m) { overlap: true }
agent a8 is bicycle on town at junction(4, before: 40m) { overlap: true }
agent a9 is car on town at junction(4, road: 4, before: 200m) { overlap: true }
agent b9 is car on town at behind(a9, 11m) { overlap: true }
agent a10 is van on town at junction(4, road: 6, before: 0m) { overlap: true }
agent c10 is car on town at ahead_of(a10, 23m) { overlap: true }
agent d10 is motorcycle on town at beside(a10, left) { overlap: true }
agent a11 is bicycle on town at junction(4, road: 7, before: 2.5m) { overlap: true }
