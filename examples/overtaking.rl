# Overtaking on a country road with oncoming traffic: the car pulls out only if there is time.
scenario overtaking "Overtaking a truck with oncoming traffic"

road country {
  draw with segments { pieces: [straight(900m), arc(600m, 30deg), straight(800m)] }
  lanes: 2
  width: 7.5m
  speed_limit: 100km/h
}

agent ego is car on country at truck.start - (35m..60m) {
  drive with car_follow
  drive with overtake { target: truck, speed: 100km/h }
}
agent truck is truck on country at 90m { drive with lane_follow { speed: 50km/h } }
agent oncoming is car on country at 300m..500m {
  facing: back
  count: 3
  spacing: 180m..420m
  drive with car_follow { speed: (60km/h)..(90km/h) }
}

expect no_crash: always (ego.contacts == 0 and truck.contacts == 0)
expect passes: eventually (ego.station > truck.station + 15m and ego.lane == -1)
expect in_time: always (time_to_collision(ego, oncoming) > 1s)

emit json
emit svg
simulate with builtin { duration: 80s }
