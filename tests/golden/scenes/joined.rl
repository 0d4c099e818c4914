# Roads end to end: lanes and limits that change, on a slope of curves; traffic that merges and leaves.
scenario joined "Joined roads"

road wide {
  draw with segments { pieces: [straight(90m), arc(200m, 15deg)] }
  right: [drive(3.5m), drive(3.5m), drive(3.25m), shoulder(2m)]
  left: [drive(3.5m)]
  speed_limit: 80km/h
}
road narrow {
  draw with segments { pieces: [straight(70m), arc(60m, -50deg)] }
  right: [drive(3.25m), drive(3m)]
  left: [drive(3m)]
  speed_limit: 50km/h
}
road end { draw with waypoints { points: [(0m, 0m), (40m, 4m), (80m, 0m)] }, lanes: 2, width: 6.4m }
road all from wide { then: [narrow, end], taper: 30m }
road bent from all { perturb with sine { amplitude: 0.5m..1.5m, wavelength: 90m, over: [60m, 240m], taper: 20m } }
road whole from wide { then: narrow, speed_limit: 60km/h }

agent ego is car on bent at 15m { lane: -2, start_speed: 18m/s, drive with traffic }
agent inner is car on bent at 40m { lane: -1, drive with traffic { speed_factor: 0.9 } }
agent outer is truck on bent at 25m { lane: -3, drive with traffic, drive with merge { to: left, within: 120m } }
agent last is van on bent at 2m { lane: -3, start_speed: 12m/s, drive with car_follow { speed: 20m/s } }
agent oncoming is car on bent at 95% { facing: back, drive with traffic }
agent leaves is car on bent at 92% { lane: -1, start_speed: 15m/s, drive with traffic }

expect slow: always (ego.speed <= ego.speed_limit + 1m/s)
expect far: eventually (ego.route_progress > 150m)
expect gone: eventually (leaves.present == 0)
expect apart: always (gap(inner, oncoming) > 0.3m)
simulate with builtin { duration: 13s, step: 0.25s, control_step: 0.1s }
