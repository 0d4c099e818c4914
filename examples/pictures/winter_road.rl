# A road through the hills, with traffic both ways, for pictures.
#   roadlang render examples/pictures/winter_road.rl --at 6 -o winter.png
scenario winter_road "A road in winter"

param hour = 10h
param sky = "snow"

road pass {
  draw with segments {
    pieces: [
      straight(60m),
      clothoid(30m, to: 0.016/m),
      arc(50m, 45deg),
      clothoid(40m, to: -0.014/m),
      arc(70m, -60deg),
      straight(90m)
    ]
  }
  width: 7.5m
  speed_limit: 50km/h
}

agent ego is car on pass at 20m { lane: -1, drive with car_follow { speed: 40km/h } }
agent lead is truck on pass at 55m { lane: -1, drive with car_follow { speed: 30km/h } }
agent oncoming is choice(car, bus, van) on pass at 35%..80% {
  lane: 1
  count: 3
  drive with car_follow { speed: 45km/h }
}

object trees is tree on pass at 0%..100% {
  count: 90
  side: left
  offset: 3m..24m
  height: 6m..12m
}
object woods is tree on pass at 0%..100% {
  count: 60
  side: right
  offset: 4m..20m
  height: 6m..12m
}
object rail is guardrail on pass at 75m { count: 4, spacing: 21m, side: right, offset: 0.7m }

world { time_of_day: hour, weather: sky }
simulate with builtin { duration: 20s }
