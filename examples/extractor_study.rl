# How reliable is the extractor? The roads of one photo in different light.
# An `expect` over roads is evaluated at compile time: the extractor is the system under test.
scenario extractor_study "One photo in different light"

image photo from "hairpin.jpg" { scale: 0.5m/px }
image worse from photo {
  adjust with brightness { factor: 0.7..1.3 }
  adjust with noise { sigma: 0%..6% }
}

network good from photo
network seen from worse
road truth from good { select: longest }
road found from seen { select: longest }

expect same_road: always (distance(found, truth) < 2m)
expect same_length: abs(length(found) / length(truth) - 1) < 5%

emit json
emit svg
