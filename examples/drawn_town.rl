# A drawn town: the legend says what each color is. White is road, green a tree, red a building.
# Use any drawing program and any colors.
scenario drawn_town "A drawn town with trees and buildings"

image sketch from "town.png" {
  scale: 1m/px
  legend: { "white": road, "#2e7d32": tree, "#b71c1c": building }
}
network town from sketch { extract with pixels }
network bent from town {
  perturb with random_walk { amplitude: 0m..1.5m, correlation: 20m..60m }
}

require near: always (deviation(bent, town) < 2m)

emit json
emit svg
