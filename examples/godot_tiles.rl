# The paper's pixel road: one tile for each character, its shape from its four neighbors.
#   roadlang run examples/godot_tiles.rl
#   roadlang render examples/godot_tiles.rl -o tiles.png --view free --road tiles
scenario godot_tiles "A town of tiles"

image plan from """
  ...............
  .#############.
  .#..T.#.BB..T#.
  .#.BB.#.BB...#.
  .#.BB.#...T..#.
  .##########.T#.
  .#.T..#...####.
  .#.BB.#.T.#..#.
  .#....#.BB#.T#.
  .#############.
  ...............
""" {
  scale: 8m/px
  legend: { "#": road, "T": tree, "B": building }
}
network town from plan
road tour from town { select: route((12m, 76m), (108m, 12m)), width: 7m }

agent ego is car on tour at 3% { drive with pure_pursuit { speed: 7m/s, lookahead: 4m } }

expect stays: always (abs(ego.cross_track_error) < 2m)
expect arrives: eventually[0s, 90s] (ego.progress > 95%)

simulate with godot { duration: 90s, road: tiles }
emit json
