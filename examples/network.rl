# A photo with several streets: all are perturbed, and the junctions stay connected.
scenario streets "Streets from a photo, bent, with connected junctions"

image photo from "village.jpg" { scale: 0.5m/px }
network town from photo

param amount = 1m..4m                               # named: one draw for the whole scene

network bent from town {
  perturb with random_walk { amplitude: amount, correlation: 20m..60m }   # unnamed: one for each road
}

let e1 = deviation(bent, town)                      # over a network: must hold on every road

require phi1: always (e1 < 4m)

emit json
emit svg
