# The same idea without a picture: a character is a thing. A route through the town is driven.
scenario typed_town "A town typed as text"

param cell = 8m/px

image plan from """
  ..#########..
  ..#..T.T.#BB.
  ..#......#BB.
  ###########..
  ..#.TTT..#...
""" {
  scale: cell
  legend: { "#": road, "T": tree, "B": building }
}
network town from plan
road tour from town { select: route((20m, 4m), (76m, 36m)), width: 6m }

agent ego is car on tour at 14% { drive with pure_pursuit { speed: 8m/s } }
expect stays: always (abs(ego.cross_track_error) < 2m)

emit json
emit svg
