# A recording is replayed; a car follows it in left-hand traffic.
scenario replay "Replay"
world { traffic: left, friction: 0.5 }
road street {
  draw with segments { pieces: [straight(60m), arc(30m, 90deg), straight(60m)] }
  lanes: 2
  speed_limit: 50km/h
}
agent lead is car on street at 40m {
  drive with lane_follow { speed: 7m/s }
  drive with replay { file: "recorded.csv", when: time > 1s }
}
agent ego is car on street at 10m { drive with car_follow { speed: 10m/s, headway: 1s } }
agent back is van on street at 90m { facing: back, drive with stanley { speed: 8m/s } }
expect off: always (gap(ego, lead) > 2m)
expect left: always (ego.lane == 1)
simulate with builtin { duration: 8s, step: 0.2s, control_step: 0.1s }
