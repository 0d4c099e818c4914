# A child runs out from behind a parked van. The car brakes for what its lidar sees, with delay and noise.
scenario emergency_brake "A child behind a parked van, seen by a lidar"

road street {
  draw with segments { pieces: [straight(130m), arc(80m, 30deg)] }
  width: 7m
  lanes: 2
}

agent ego is car on street at 5m {
  drive with lane_follow { speed: 30km/h..40km/h }
  drive with emergency_brake { sensor: "front", deceleration: 9m/s^2, reaction: 0.3s, margin: 0.2m }
  sense with ranges as front {
    at: (2.2m, 0m, 0.5m)
    rays: 61
    angle: 60deg
    range: 50m
    noise: 3cm
    lost_rays: 2%
    delay: 80ms
  }
  sense with gps { noise: 0.5m, every: 200ms }      # recorded beside the trace
}

object van is parked_van on street at 80m { side: right, offset: -0.3m }

agent walker is child on street at 85m {
  side: right
  offset: 0m
  drive with crossing { speed: 1.5m/s, when: gap(ego, walker) < 20m }
}

expect unharmed: always (ego.contacts == 0)
expect brakes: eventually (ego.acceleration < -5m/s^2)

simulate with builtin { duration: 15s }
emit json
emit svg
