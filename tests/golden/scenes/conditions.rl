# Controllers that wait for conditions of every form, on two roads that cross.
scenario conditions "Conditions"

road east { draw with segments { pieces: [straight(80m), arc(60m, 40deg), straight(60m)] }, lanes: 2, speed_limit: 60km/h }
road north { draw with waypoints { points: [(50m, -70m), (52m, 0m), (48m, 80m)] }, width: 7m }

agent ego is car on east at 8m {
  drive with lane_follow { speed: 9m/s }
  drive with brake { deceleration: 2m/s^2, speed: 5m/s, when: historically[0s, 1s] (ego.speed > 8m/s) and time > 1.5s }
  drive with lane_follow { speed: 11m/s, when: once[1s, 3s] (ego.speed < 6m/s) }
  drive with brake { deceleration: 4m/s^2, while: distance(ego, crosser) < 12m or gap(ego, walker) < 3m }
}
agent crosser is van on north at 30m {
  drive with pure_pursuit { speed: 8m/s }
  drive with stanley { speed: 12m/s, when: (crosser.speed > 7m/s) since[0s, 2s] (crosser.station > 40m) }
  drive with brake { while: max(abs(ego.x - crosser.x), abs(ego.y - crosser.y)) < 9m and not (time < 2s) }
}
agent follower is car on east at 0m {
  drive with car_follow { speed: 10m/s }
  drive with brake { deceleration: 1m/s^2, when: ego.speed / follower.speed < 0.9 implies follower.progress > 20% }
}
agent walker is pedestrian on north at 100m { side: left, offset: 1m, facing: back, drive with crossing { speed: 1.5m/s, when: min(ego.station, 200m) > 25m } }
agent late is bicycle on north at 60m {
  facing: back
  drive with lane_follow { speed: 4m/s }
  drive with change_lane { to: left, force: true, duration: 2s, when: ego.speed * 1s + 2 * late.station > 30m and ego.heading > -1rad }
}
expect apart: always (gap(ego, crosser) > 0.5m)
expect ttc: always (time_to_collision(ego, crosser) > 0.5s)
expect pet: always (post_encroachment_time(ego, crosser) > 0.5s)
simulate with builtin { duration: 9s, step: 0.2s, control_step: 0.1s }
