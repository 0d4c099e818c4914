# A parameter sweep over draws of every distribution, also those whose options are drawn.
scenario grid "Grid"

param low = 1m..3m
param high = low..9m
param count = integer(2, 4)
param bell = normal(10m, 2m, within: [8m, 13m])
param pick = choice(1m, 2m)

road main { draw with segments { pieces: [straight(60m + bell), arc(50m, 40deg)] }, width: 6m + pick / 2 }
road bent from main { perturb with bump { at: 30m + high, height: pick, length: 30m } }
agent ego is car on bent at 10m + low
object cones is cone on bent at 40m { count: count, spacing: 2m }

require far: bell + high > 13m
expect start: ego.start > 12m
sample with grid { steps: 2 }
