# Twelve cars and vans at an intersection with signals: they turn, wait at red, and do not collide.
scenario signals "Traffic at an intersection with signals"

image plan from """
  ....#....
  ....#....
  ....#....
  ....#....
  #########
  ....#....
  ....#....
  ....#....
  ....#....
""" {
  scale: 30m/px
  legend: { "#": road }
}

network town from plan {
  extract with auto { width: 7m }
  lanes: 2
  speed_limit: 50km/h
  control with signals { green: 12s, yellow: 3s, all_red: 2s, offset: 0s..30s }
}

agent cars is choice(car, van, weights: [3, 1]) on town at random {
  count: 12
  drive with traffic { speed_factor: 0.85..1.1, aggression: 0.3..0.8 }
}

expect untouched: always (cars.contacts == 0)
expect lawful: always (cars.red_light == 0)
expect legal: always (cars.speed < 56km/h)
expect flows: eventually[0s, 60s] (cars.progress > 50%)

simulate with builtin { duration: 60s }

emit json
emit svg
