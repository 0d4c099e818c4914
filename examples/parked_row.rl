# A row of parked cars hides a child who steps out: a car at the speed limit has to stop.
scenario parked_row "A child steps out from behind a row of parked cars"

road street {
  draw with segments { pieces: [straight(80m), arc(120m, 30deg), straight(120m)] }
  left: [drive(3m), sidewalk(2m)]
  right: [drive(3m), parking(2.2m), sidewalk(2m)]
  speed_limit: 30km/h
}

agent ego is car on street at 10m {
  drive with car_follow
  drive with brake { deceleration: 6m/s^2, when: distance(ego, child) < 16m and child.speed > 0m/s }
}
object parked is choice(parked_car, parked_van) on street at 60m {
  lane: parking
  count: 8
  spacing: 7m..7.5m
}
agent child is pedestrian on street at 119m {
  lane: parking
  drive with crossing { speed: 1.2m/s..2m/s, when: distance(ego, child) < 14m..26m }
}

expect unharmed: always (ego.contacts == 0 and child.contacts == 0)
expect crosses: eventually (child.speed > 1m/s)
expect waits: eventually (distance(ego, child) < 16m)

emit json
emit svg
simulate with builtin { duration: 40s }
