# A sweep over a table of values, a road from CSV.
scenario table "Table"

param radius = choice(30m, 45m)
param speed = 8m/s..12m/s
road track from "track.csv" {
  closed: true
  lanes: 1
  read with csv { x: "east", y: "north", width: "wide" }
}
road street { draw with segments { pieces: [straight(60m), arc(radius, 90deg), straight(60m)] } }
agent ego is car on street at 5m { drive with pure_pursuit { speed: speed } }
require tight: always (abs(curvature(track)) < 0.5/m)
sample with grid { steps: 3 }
emit json
