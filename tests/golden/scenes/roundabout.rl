# A roundabout that is found in a drawing, with traffic.
scenario roundabout "Roundabout"
image sketch from "ring.png" { scale: 1m/px, legend: { "white": road } }
network town from sketch { extract with pixels, lanes: 2, speed_limit: 35km/h }
agent ego is car on town { route: [(4m, 60m), (116m, 60m)], drive with traffic }
agent cars is choice(car, van) on town at random { count: 4, apart: 5m, drive with traffic }
expect untouched: always (ego.contacts == 0)
expect through: eventually (ego.route_progress > 50m)
simulate with builtin { duration: 8s, step: 0.4s, control_step: 0.1s }
