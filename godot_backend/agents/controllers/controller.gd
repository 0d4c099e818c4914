extends RefCounted
## What drives an agent: from where it is to a steering angle and an acceleration, once a step.

const Agent := preload("../agent.gd")

## Gain from a difference in speed to an acceleration, 1/s.
const SPEED_GAIN := 2.0
## Share of the greatest deceleration with which drivers plan to brake before a bend.
const PLANNED_SHARE := 0.5
## Seconds by which the curvature is looked up ahead.
const PREVIEW_TIME := 0.12
## Below it, a cross-track error is corrected as at this speed.
const SLOWEST := 3.0
## Seconds: steering angle for each rad/s of a yaw rate that is not that of the line.
const YAW_DAMPING := 0.1
## Radians for each m/s^2 to the side by which a car steers more, as its tires slip.
const SLIP := 1.0 / (12.0 * GRAVITY)
const GRAVITY := 9.81

var max_acceleration := 3.0
var max_deceleration := 6.0
## In bends; it slows down before them.
var max_lateral := 4.5

var _options: Dictionary = {}


func take(options: Dictionary) -> void:
	_options = options
	max_acceleration = number("acceleration", 3.0)
	max_deceleration = number("deceleration", 6.0)
	max_lateral = number("lateral_acceleration", 4.5)
	read()


## Reads the options of the kind.
func read() -> void:
	pass


func reset() -> void:
	pass


## Remembers what another controller of this kind does.
func go_on(_earlier: RefCounted) -> void:
	pass


## Steering angle (left positive; NAN leaves it to another controller) and acceleration.
func command(_agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	return Vector2(NAN, 0.0)


func number(key: String, usual: float) -> float:
	var value: Variant = _options.get(key)
	return value if value is float and is_finite(value) else usual


## Acceleration toward a speed, held within what the car may do.
func toward(agent: Agent, target: float) -> float:
	return clampf(SPEED_GAIN * (target - agent.speed), -max_deceleration, max_acceleration)


## A target speed, or what the bends ahead allow: asked for early by as much as `toward` lags
## behind a target that falls.
func bend_speed(agent: Agent, target: float) -> float:
	if agent.path == null:
		return target
	for ahead: float in [0.0, agent.speed / SPEED_GAIN]:
		var place := agent.station + agent.direction * ahead
		var planned := PLANNED_SHARE * max_deceleration
		var limit := agent.path.bend_speed(place, agent.direction, max_lateral, planned)
		target = minf(target, limit)
	return target


## Steering angle that keeps to the line: its curvature, looked up ahead, and a correction of the
## errors in place and heading.
static func along_line(agent: Agent) -> float:
	if agent.path == null:
		return 0.0
	var wheelbase: float = agent.body.wheelbase
	var curvature := agent.line_curvature(PREVIEW_TIME * maxf(agent.speed, 0.0))
	var bend := atan(wheelbase * curvature)
	# A car on a circle points along the circle at its rear axle.
	var turn := angle_difference(agent.heading, agent.line_heading(-0.5 * wheelbase))
	var correction := atan(2.0 * agent.cross_track_error / maxf(agent.speed, SLOWEST))
	var turning := agent.speed * curvature
	var slip := SLIP * clampf(agent.speed * turning, -GRAVITY, GRAVITY)
	return bend + slip + turn - correction - YAW_DAMPING * (agent.yaw_rate - turning)


## Steering angle of pure pursuit (Coulter 1992): the arc from the rear axle through the line
## to follow, `reach` meters on.
static func pursuit(agent: Agent, reach: float) -> float:
	if agent.path == null:
		return 0.0
	var wheelbase: float = agent.body.wheelbase
	var rear := Vector2(agent.x, agent.y) - 0.5 * wheelbase * Vector2.from_angle(agent.heading)
	var to := agent.ahead(reach) - rear
	var bearing := angle_difference(agent.heading, to.angle())
	return atan2(2.0 * wheelbase * sin(bearing), maxf(to.length(), 0.5))
