# A town typed by hand: each character stands for a thing. Change the map and compile again.
scenario town "A typed town"

image plan from """
  ..#########..
  ..#..T.T.#BB.
  ..#......#BB.
  ###########..
  ..#.TTT..#...
""" {
  scale: 8m/px
  legend: { "#": road, "T": tree, "B": building }
}

network streets from plan
network bent from streets {
  perturb with random_walk { amplitude: 0m..1m, correlation: 20m..40m }
}

require near: always (deviation(bent, streets) < 1.5m)

emit json
emit svg
