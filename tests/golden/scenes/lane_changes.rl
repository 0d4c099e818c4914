# Lane changes, a cut-in, a merge before the lane ends, an overtaking, a queue that hits its leader.
scenario lane_changes "Lane changes"

road motorway {
  draw with segments { pieces: [straight(150m), arc(300m, 25deg), straight(200m)] }
  right: [drive(3.5m), drive(3.5m), drive(3.5m), shoulder(2m)]
  left: [drive(3.5m)]
  speed_limit: 90km/h
}
agent ego is car on motorway at 60m { lane: -2, drive with car_follow { speed: 70km/h } }
agent cutter is car on motorway at 40m {
  lane: -1
  drive with car_follow { speed: 80km/h }
  drive with cut_in { target: ego, gap: 7m, duration: 2.5s }
}
agent changer is van on motorway at 120m {
  lane: -3
  drive with lane_follow { speed: 60km/h }
  drive with change_lane { to: left, duration: 3s, when: time > 2s }
}
agent presser is car on motorway at 160m {
  lane: -1
  drive with lane_follow { speed: 65km/h }
  drive with change_lane { to: -2, distance: 40m, force: true, when: time > 1s }
}
agent merger is car on motorway at 20m {
  lane: -3
  drive with merge { to: left, within: 120m, speed: 75km/h }
}
agent slow is truck on motorway at 215m { lane: -3, drive with lane_follow { speed: 35km/h } }
agent crasher is car on motorway at 190m { lane: -3, drive with lane_follow { speed: 60km/h } }
agent oncoming is car on motorway at 400m { facing: back, drive with car_follow { speed: 60km/h } }

expect cuts: eventually (cutter.lane == -2 and gap(ego, cutter) < 9m)
expect no_crash: always (ego.contacts == 0)
expect hits: eventually (crasher.contacts > 0)
expect impact: always (crasher.collision < 5m/s)
expect headway: always (time_headway(ego, cutter) > 0.3s)

simulate with builtin { duration: 12s, step: 0.25s, control_step: 0.1s }
