# Overtaking on a country road with oncoming traffic.
scenario overtake "Overtake"
road country {
  draw with segments { pieces: [straight(300m), arc(400m, 20deg), straight(300m)] }
  lanes: 2
  width: 7.5m
  speed_limit: 100km/h
}
agent ego is car on country at 30m {
  drive with car_follow
  drive with overtake { target: truck, speed: 95km/h, duration: 2s }
}
agent truck is truck on country at 60m { drive with lane_follow { speed: 40km/h } }
agent oncoming is car on country at 200m { facing: back, drive with car_follow { speed: 70km/h } }
expect passes: eventually (ego.station > truck.station + 8m and ego.lane == -1)
expect in_time: always (time_to_collision(ego, oncoming) > 1s)
expect no_crash: always (ego.contacts == 0)
simulate with builtin { duration: 20s, step: 0.25s, control_step: 0.1s }
