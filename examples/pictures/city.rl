# A few blocks of a town in any light and weather, for pictures.
#   roadlang render examples/pictures/city.rl --view free -o city.png
#   roadlang render examples/pictures/city.rl --set hour=21h --set sky=rain -o night.png
scenario city "A few blocks of a town"

param hour = 9.5h
param sky = "clear"

image plan from """
  ..#......#....
  ..#......#....
  ..#......#....
  ##############
  ..#......#....
  ..#......#....
  ..#......#....
  ..#......#....
  ##############
  ..#......#....
  ..#......#....
  ..#......#....
""" {
  scale: 13m/px
  legend: { "#": road }
}

network town from plan {
  extract with pixels
  left: [drive(3.5m), sidewalk(2.2m)]
  right: [drive(3.5m), sidewalk(2.2m)]
  speed_limit: 40km/h
  control with signals { green: 10s, yellow: 3s, all_red: 2s }
}

agent ego is car on town { route: [(123m, 12m), (123m, 100m), (40m, 110m)], drive with traffic }
agent cars is choice(car, van, taxi, weights: [5, 1, 1]) on town at random {
  count: 13
  drive with traffic { speed_factor: 0.85..1.1 }
}
agent heavy is choice(bus, truck) on town at random { count: 3, drive with traffic }
agent riders is choice(bicycle, motorcycle) on town at random { count: 4, drive with traffic }

object houses is building on town at random {
  count: 24
  side: left
  offset: 6m..9m
  height: 6m..13m
}
object trees is tree on town at random {
  count: 40
  side: right
  offset: 2m..12m
  height: 5m..9m
}
object lamps is lamp on town at random { count: 16, side: right, offset: 0.4m, apart: 4m }

world { time_of_day: hour, weather: sky }
simulate with builtin { duration: 30s }
