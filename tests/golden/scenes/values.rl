# Every distribution and number, places of every sort, groups, and all of `world`.
scenario values "Values"

param pick = choice(1m, 2m, 5m, weights: [1, 2, 3])
param whole = integer(2, 5)
param bell = normal(10m, 3m)
param cut = normal(0, 1, within: [-0.5, 2])
param part = 10%..40%
param total = (pick + 2 * bell) / 2
let ratio = (total / pick)^2

world {
  time_of_day: 6.5h..19h
  weather: choice(clear, rain, fog, snow, cloudy, overcast)
  friction: 0.4..0.9
  rain: 3mm/h
  visibility: 250m
  sun: { azimuth: 120deg, elevation: 25deg }
}

road street {
  draw with segments { pieces: [straight(90m), arc(80m, 60deg), straight(90m)] }
  left: [drive(3.2m), drive(3m), sidewalk(2m)]
  right: [drive(3.2m), bike(1.5m), parking(2.2m), sidewalk(2m)]
}

agent ego is car on street at part { lane: -1 }
agent ahead is van on street at ahead_of(ego, 12m) { color: "white" }
agent behind is bus on street at behind(ego, 4m)
agent next_to is motorcycle on street at beside(ego, left)
agent row is choice(car, truck, weights: [2, 1]) on street at 120m {
  lane: 1
  count: whole
  spacing: 14m..18m
}
agent rider is bicycle on street at 50% { lane: bike }
agent walker is pedestrian on street at ego.start + 30m { side: right, offset: 0.5m, facing: back }
agent deer is animal at (30m, 40m) { heading: 200deg }
agent crowd is pedestrian on street at random { count: 4, side: left, offset: 1m..4m, apart: 2m }
object trees is tree on street at 5%..95% { count: 6, side: left, offset: 3m..9m }
object kiosk is building at (60m, -30m) { heading: 30deg, length: 6m, width: 4m }
object vans is parked_van on street at 20m { lane: parking, count: 3, spacing: 8m }
object cones is cone on street at 190m { lane: outer, count: 2, spacing: 3m, offset: -0.4m }
object stone is rock on street at 75% { offset: 0.5m, lane: none, overlap: true }

require wide: gap(ego, ahead) > 8m and distance(ego, deer) > 5m
require lanes: row.start_lane > 0
require value: ratio < 600
expect starts: ego.start < 70m or ahead.start > 40m
expect near: gap(ego, vans) > 2m

emit json
emit svg { labels: true, profiles: false }
