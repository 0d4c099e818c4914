extends "res://agents/controllers/controller.gd"
## Follows the middle of its lane: the bend's own steering angle, corrected for what is amiss.

const PREVIEW_TIME := 0.12

var _speed := 0.0


func read() -> void:
	max_acceleration = number("acceleration", 2.0)
	max_deceleration = number("deceleration", 4.0)
	_speed = number("speed", 50.0 / 3.6)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	if agent.path == null:
		return Vector2(0.0, toward(agent, bend_speed(agent, _speed)))
	var preview := PREVIEW_TIME * maxf(agent.speed, 0.0)
	var wheelbase: float = agent.body.wheelbase
	var bend := atan(wheelbase * agent.line_curvature(preview))
	# A car on a circle points along the circle at its rear axle.
	var turn := angle_difference(agent.heading, agent.line_heading(-0.5 * wheelbase))
	var reach := maxf(agent.speed, 3.0)
	var steer := bend + turn - atan(2.0 * agent.cross_track_error / reach)
	return Vector2(steer, toward(agent, bend_speed(agent, _speed)))
