extends RefCounted
## The underside of a body in a side view, with room for the wheels.

const ROOM := 0.06
const STEPS := 7


## Points from front to rear at the height of the floor, cut out around both axles. Behind the rear
## wheels the floor rises by some meters, so that they are seen from behind.
static func underside(
	size: Vector3, wheelbase: float, radius: float, floor_height: float, rise := 0.0
) -> PackedVector2Array:
	var out := PackedVector2Array()
	var reach := radius + ROOM
	var half := sqrt(maxf(reach * reach - pow(radius - floor_height, 2.0), 0.01))
	for axle: float in [0.5 * wheelbase, -0.5 * wheelbase]:
		if absf(axle) + half > 0.5 * size.x - 0.03:
			continue
		for i in STEPS + 1:
			var across := lerpf(half, -half, float(i) / STEPS)
			var up := radius + sqrt(maxf(reach * reach - across * across, 0.0))
			if i == 0 or i == STEPS:
				up = floor_height
			out.append(Vector2(axle + across, up))
	out.append(Vector2(-0.49 * size.x, floor_height + rise))
	return out
