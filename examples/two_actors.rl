# One file included twice, under two names: `slow.driver`, `fast.driver`.
scenario two_actors "A fast car overtakes a slow one: one file, included twice"

include "lane_car.rl" as slow { speed: 25km/h }
include "lane_car.rl" as fast { y: 8m, speed: 45km/h }

expect beside: always (gap(slow.driver, fast.driver) > 2m)
expect slow_on_road: always (slow.driver.off_road < 0m)
expect fast_on_road: always (fast.driver.off_road < 0m)
expect lawful: always (fast.driver.speed < fast.driver.speed_limit)
expect overtakes: eventually (fast.driver.x > slow.driver.x + 20m)

simulate with builtin { duration: 30s }
