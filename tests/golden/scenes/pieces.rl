# Roads of every piece and curve, with lanes, widths and markings of every kind.
scenario pieces "Pieces"

road street {
  draw with segments {
    pieces: [
      straight(40m),
      clothoid(25m, to: 0.02/m),
      arc(50m, 50deg),
      clothoid(20m, to: 0/m, start: 0.02/m),
      arc(30m, -70deg)
    ]
    start: (5m, -3m)
    heading: 20deg
  }
  left: [drive(3m), bike, grass(1.5m), sidewalk(1.8m)]
  right: [drive(3.2m, marking: solid, speed_limit: 60km/h), bus(3.4m), parking, shoulder]
  center_marking: double
  speed_limit: 50km/h
}
road wide {
  draw with waypoints {
    points: [(0m, -60m), (60m, -80m), (120m, -60m), (170m, -90m)]
    curve: polyline
    radius: 18m
  }
  lanes: 5
  sidewalks: 2.2m
}
road ring {
  draw with waypoints { points: [(200m, 0m), (260m, 10m), (270m, 60m), (215m, 55m)] }
  closed: true
  oneway: true
  lanes: 2
  width: 8m
  station_spacing: 2.5m
}
road narrow from street { width: 4m, lanes: 1, station_spacing: 0.7m }

let bend = curvature(street)
let turned = heading(street)
let room = clearance(street)
let inside = margin(street, (-20m, -20m), (150m, 150m))
require gentle: always (abs(bend) < 0.04/m)
require free: always (room > 3m)
expect within: always (inside > 0m)
expect long: length(street) > 150m and length(ring) < 300m
expect turns: eventually (turned > 60deg)
expect same_width: always (width(street) >= 5m)
expect early: eventually[0m, 60m] (bend > 0.015/m)
expect late: always[120m, 160m] (bend < 0/m)

emit json
emit svg
