# A town typed as text: the legend says what each character is. A car drives a route through it.
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

agent ego is car on town {
  route: [(36m, 12m), (76m, 24m), (40m, 36m)]     # past these points, by lanes and turns
  drive with pure_pursuit { speed: 8m/s }
}
expect stays: always (abs(ego.cross_track_error) < 2m)

emit json
emit svg
