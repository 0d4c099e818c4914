# Traffic at a crossing and a side street under the rule `yield`.
scenario cross_yield "Crossing: yield"

image plan from """
  ....#......
  ....#......
  ....#......
  ###########
  ....#...#..
  ....#...#..
""" {
  scale: 15m/px
  legend: { "#": road }
}
network town from plan {
  extract with auto { width: 7m }
  lanes: 2
  speed_limit: 40km/h
  control with yield
}
agent ego is car on town at junction(1, before: 12m) { drive with traffic }
agent cars is choice(car, van, truck) on town at random {
  count: 5
  apart: 4m
  drive with traffic {
    speed_factor: 0.85..1.1
    aggression: 0.3..0.8
    headway: 1.2s
    politeness: 0.7
  }
}
expect untouched: always (ego.contacts == 0 and cars.contacts == 0)
expect lawful: always (ego.red_light == 0)
expect moves: eventually (ego.route_progress > 30m)
expect on_road: always (ego.off_road < 0m)
expect limit: always (cars.speed < 42km/h)
simulate with builtin { duration: 12s, step: 0.3s, control_step: 0.1s }
