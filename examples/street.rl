# One street drawn from pieces. Other files include it and set its params; see traffic.rl.
scenario street "One street, drawn from pieces"

param speed_limit = 50km/h
param first_bend = 40m..80m                         # random; a file that includes this one can set it

road street {
  draw with segments {
    pieces: [
      straight(80m),
      clothoid(30m, to: 1 / first_bend),
      arc(first_bend, 60deg),
      straight(90m)
    ]
  }
  width: 7m
  lanes: 2
}

emit json
emit svg
