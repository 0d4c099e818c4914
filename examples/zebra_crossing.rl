# People wait at a zebra crossing: traffic in both directions lets them cross.
scenario zebra_crossing "People at a zebra crossing"

road street {
  draw with segments { pieces: [straight(90m), arc(150m, 25deg), straight(110m)] }
  left: [drive(3.25m), sidewalk(2.5m)]
  right: [drive(3.25m), bike(1.5m), sidewalk(2.5m)]
  speed_limit: 50km/h
}

object zebra is crosswalk on street at 110m..170m
agent people is choice(pedestrian, child) at beside(zebra, right) {
  count: integer(1, 3)
  spacing: 1m
  drive with crossing {
    speed: 1.1m/s..1.7m/s
    wait_for: gap
    when: distance(ego, zebra) < 35m..45m
  }
}
agent ego is car on street at 20m { drive with traffic }
agent oncoming is choice(car, van) on street at ahead_of(zebra, 30m..70m) {
  lane: 1
  drive with traffic
}
object trees is tree on street at 0%..100% { count: 12, side: left, offset: 2m..8m }

expect unharmed: always (people.contacts == 0 and gap(ego, people) > 0.5m)
expect yields: eventually (ego.speed < 20km/h)
expect across: eventually[0s, 40s] (people.cross_track_error > 3m)
expect goes_on: eventually (ego.progress > 90%)

simulate with builtin { duration: 50s }

emit json
emit svg
