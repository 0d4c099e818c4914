# Merging from an on-ramp: the acceleration lane ends, and traffic may or may not leave a gap.
scenario on_ramp "Merging from an on-ramp"

road before {
  draw with segments { pieces: [straight(250m)] }
  lanes: 2
  oneway: true
  speed_limit: 100km/h
}
road beside {
  draw with segments { pieces: [straight(250m)] }
  lanes: 3
  oneway: true
  speed_limit: 100km/h
}
road after {
  draw with segments { pieces: [arc(900m, 20deg)] }
  lanes: 2
  oneway: true
  speed_limit: 100km/h
}
road highway from before { then: [beside, after], taper: 60m }

agent ego is car on highway at 320m {
  lane: -3
  start_speed: 60km/h
  drive with car_follow
  drive with merge { to: left, within: 160m }
}
agent flow is choice(car, truck, weights: [3, 1]) on highway at 20m..60m {
  lane: -2
  count: 6
  spacing: 40m..75m
  drive with car_follow { speed: (75km/h)..(90km/h) }
}

expect no_crash: always (ego.contacts == 0 and flow.contacts == 0)
expect merges: eventually (ego.lane == -2)
expect on_road: always (ego.off_road < 0m)
expect no_stop: always[0s, 20s] (ego.speed > 10km/h)

emit json
emit svg
simulate with builtin { duration: 30s }
