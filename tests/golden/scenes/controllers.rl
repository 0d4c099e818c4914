# Every controller that follows a road, side by side, with signals of all of them.
scenario controllers "Controllers"

road street {
  draw with segments {
    pieces: [straight(60m), arc(40m, 70deg), straight(40m), arc(35m, -60deg), straight(90m)]
  }
  right: [drive(3.4m), drive(3.4m), sidewalk(2m)]
  left: [drive(3.4m), sidewalk(2m)]
  speed_limit: 45km/h
}
agent ego is car on street at 12m {
  lane: -1
  start_speed: 30km/h
  drive with pure_pursuit { speed: 11m/s, lookahead: 5m, lookahead_time: 0.3s }
  drive with brake { deceleration: 5m/s^2, speed: 3m/s, when: ego.station > 150m }
}
agent second is van on street at 30m { lane: -2, drive with stanley { gain: 2/s } }
agent third is car on street at 60m { lane: -1, drive with lane_follow { speed: 8m/s } }
agent fourth is truck on street at 2m { lane: -2, drive with car_follow { headway: 1.2s, gap: 3m } }
agent rider is motorcycle on street at 200m {
  facing: back
  drive with lane_follow { speed: 12m/s }
  drive with speed_profile { points: [(0m, 12m/s), (30m, 5m/s), (80m, 14m/s)], when: time > 1s }
}
agent halter is bicycle on street at 100m {
  lane: -2
  drive with lane_follow { speed: 5m/s }
  drive with stop_at { station: 120m, deceleration: 1.5m/s^2 }
}
agent walker is pedestrian on street at 90m {
  side: right
  offset: 0.5m
  drive with walk { along: edge, speed: 1.6m/s }
}
agent child is pedestrian on street at 140m {
  side: left
  offset: 1m
  facing: back
  drive with crossing { speed: 2m/s, beyond: 0.5m, when: distance(ego, child) < 45m }
}
agent stroller is pedestrian on street at 40m { side: left, offset: 1m, drive with walk }

expect slow: always (ego.speed < 12m/s)
expect smooth: always (abs(ego.acceleration) < 6m/s^2)
expect track: always (abs(ego.cross_track_error) < 1m)
expect half: eventually (ego.progress > 60%)
expect far: eventually[0s, 12s] (ego.station > 120m)
expect steers: always (abs(ego.steering) < 20deg)
expect heads: eventually (ego.heading > 60deg)
expect grips: always (abs(ego.lateral_acceleration) < 4.6m/s^2)
expect jerks: always (abs(ego.jerk) < 80m/s^3)
expect yaws: always (abs(ego.yaw_rate) < 0.4rad/s)
expect alone: always (ego.contacts == 0)
expect off: always (distance(ego, child) > 2m)
expect room: always (gap(ego, third) > 1m)
expect east: always (ego.x > 0m and ego.y > -10m)
expect ttc: always (time_to_collision(ego, third) > 1.5s)
expect pet: always (post_encroachment_time(ego, child) > 1s)
expect lane: always (ego.lane == -1)
expect center: always (abs(ego.lane_offset) < 0.8m)
expect route: eventually (ego.route_progress > 100m)
expect legal: always (ego.speed <= ego.speed_limit)
expect on_lane: always (ego.off_road < 0m)
expect stays: always[2s, 8s] (fourth.speed > 2m/s or second.speed > 5m/s)
expect red: always (ego.red_light == 0)
expect unhurt: always (child.collision < 1m/s)
expect follows: always (time_headway(fourth, second) > 0.5s)
expect stops: eventually (halter.speed < 0.1m/s)

simulate with builtin { duration: 14s, step: 0.2s }
