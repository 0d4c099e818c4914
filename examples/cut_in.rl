# A car cuts in closely on a highway: does the car behind brake in time, and gently?
scenario cut_in "A car changes lanes closely in front of another"

road highway {
  draw with segments { pieces: [straight(300m), arc(500m, 40deg), straight(700m)] }
  right: [drive(3.5m), drive(3.5m), shoulder(2.5m)]
  speed_limit: 100km/h
}

agent ego is car on highway at 100m..140m { lane: -2, drive with car_follow { speed: 80km/h } }
agent cutter is car on highway at ego.start - (20m..40m) {
  lane: -1
  drive with car_follow { speed: 90km/h }
  drive with cut_in { target: ego, gap: 6m..14m, duration: 2s..4s }
}

expect cuts_in: eventually (cutter.lane == -2 and gap(ego, cutter) < 16m)
expect no_crash: always (ego.contacts == 0)
expect keeps_off: always (gap(ego, cutter) > 1m)
expect recovers: eventually[15s, 30s] (time_headway(ego, cutter) > 1s and ego.speed > 60km/h)

emit json
emit svg
simulate with builtin { duration: 30s }
