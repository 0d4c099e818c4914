# Time of day, weather and friction, for backends that can show them.
include "street.rl"

scenario weather "One street in every weather"

world {
  time_of_day: 6h..20h
  weather: choice(clear, rain, fog, weights: [6, 3, 1])
  friction: 0.4..0.9
}

agent ego is car on street at 5m { drive with pure_pursuit { speed: speed_limit } }
expect in_lane: always (abs(ego.cross_track_error) < 1m)
