extends RefCounted
## Forces of tires, by the formulas of `roadlang/simulation/vehicles/vehicle_dynamics.py`: a brush
## model whose grip is shared between braking and cornering by a circle for each wheel.

const LEAST_POWER_SPEED := 1.0


## Share of the grip that a tire uses sideways, -1 to 1, at a slip of 1 where it begins to slide.
static func brush(slip: float) -> float:
	var part := clampf(slip, -1.0, 1.0)
	return part * (3.0 - 3.0 * absf(part) + part * part)


## The tangent of the angle of steered wheels after a tick: they follow what is wanted with a `lag`
## in seconds, and turn by at most `rate` in rad/s.
static func turned(tangent: float, wanted: float, rate: float, lag: float, dt: float) -> float:
	var most := rate * dt * (1.0 + tangent * tangent)
	return tangent + clampf((wanted - tangent) * dt / (lag + dt), -most, most)


## Share of the grip that drive or brakes use, -1 to 1. `power` is in W/kg, `grip` is friction times
## gravity, `rolling` slows down as well. Brakes hold what stands, and do not push it back.
static func demand(
	wanted: float, speed: float, power: float, grip: float, rolling: float, dt: float
) -> float:
	var pace := absf(speed)
	var driven := minf(wanted, power / maxf(pace, LEAST_POWER_SPEED))
	if driven < 0.0:
		driven = -signf(speed) * minf(-driven, maxf(pace / dt - rolling, 0.0))
	return clampf(driven / grip, -1.0, 1.0)


## Force along the wheel and to its left, of a wheel that carries `load` newtons. `along`, `left`:
## velocity of the ground contact in the axes of the wheel; `slope`: share of the slip at which it
## slides, for each unit of slip, which below the speed `slow` is as at that speed.
static func force(
	along: float, left: float, used: float, load: float, friction: float, slope: float, slow: float
) -> Vector2:
	var side := brush(slope * left / maxf(absf(along), slow))
	var grip := friction * load / maxf(sqrt(used * used + side * side), 1.0)
	return Vector2(used * grip, -side * grip)
