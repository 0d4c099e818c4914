# A drawn picture, adjusted, and its roads found again.
scenario picture "Picture"

image sketch from "sketch.png" {
  scale: 0.8m/px
  legend: { "white": road, "#2e7d32": tree, "#b71c1c": building }
}
image gray from "bend.png" { scale: 0.5m/px }
image worse from gray {
  adjust with brightness { factor: 0.9..1.1 }
  adjust with contrast { factor: 0.8 }
  adjust with sharpness { factor: 1.5 }
  adjust with blur { radius: 1px }
  adjust with noise { sigma: 2% }
  adjust with shadows { count: 2, size: 12px, darkness: 0.2 }
}
network drawn from sketch { extract with pixels { thickness: 5px } }
network good from gray { extract with contour { blur: 1px, width: 6m } }
network seen from worse { extract with contour { blur: 2px, road: dark, min_length: 8m } }
network self from gray
road truth from good { select: longest }
road found from seen { select: longest }

expect same: always (distance(found, truth) < 3m)
expect length: abs(length(found) / length(truth) - 1) < 20%

emit json
emit svg { photo: gray, fade: 0.5 }
