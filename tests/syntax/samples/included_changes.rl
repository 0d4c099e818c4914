# For: one street twice, one of them of another width.
include "street.rl" as left
include "street.rl" as right

# What is not named stays as it is.
override right.street {   # narrow
  width: 6m
}
agent ego is car on right.street at 5m { drive with pure_pursuit { speed: 5m/s } }
