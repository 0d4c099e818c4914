# A platoon of trucks keeps its time gaps while the first one brakes and speeds up again.
scenario platoon "Five trucks in a row behind a leader that slows down"

road highway {
  draw with segments { pieces: [straight(400m), arc(800m, 30deg), straight(900m)] }
  right: [drive(3.75m), drive(3.75m), shoulder(2.5m)]
}

agent leader is truck on highway at 250m {
  lane: -2
  drive with lane_follow { speed: 80km/h }
  drive with speed_profile {
    points: [(0m, 80km/h), (60m..120m, (30km/h)..(50km/h)), (400m, 80km/h)]
    when: leader.station > 400m
  }
}
agent follower is truck on highway at leader.start - 160m {
  lane: -2
  count: 4
  spacing: 36m
  drive with car_follow { speed: 85km/h, headway: 1s..1.4s, acceleration: 1m/s^2 }
}

expect no_crash: always (leader.contacts == 0 and follower.contacts == 0)
expect keeps_off: always (gap(follower, leader) > 4m)
expect slows: eventually (follower.speed < 60km/h)
expect closes_up: eventually[40s, 70s] (follower.speed > 65km/h and leader.speed > 75km/h)

emit json
emit svg
simulate with builtin { duration: 70s }
