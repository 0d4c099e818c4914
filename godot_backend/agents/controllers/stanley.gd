extends "controller.gd"
## The Stanley controller (Hoffmann et al. 2007): heading error plus an angle for the cross-track
## error of the front axle, and against yaw rates that are not those of the line.

var _speed := 0.0
var _gain := 0.0
var _softening := 0.0


func read() -> void:
	_speed = number("speed", 50.0 / 3.6)
	_gain = number("gain", 2.5)
	_softening = number("softening", 1.0)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	if agent.path == null:
		return Vector2(0.0, toward(agent, bend_speed(agent, _speed)))
	var half: float = 0.5 * agent.body.wheelbase
	var direction := agent.line_heading(half)
	var front := Vector2(agent.x, agent.y) + half * Vector2.from_angle(agent.heading)
	var off := front - agent.ahead(half)
	var left := -sin(direction) * off.x + cos(direction) * off.y
	var turn := angle_difference(agent.heading, direction)
	var steer := turn - atan2(_gain * left, _softening + maxf(agent.speed, 0.0))
	var turning := agent.speed * agent.line_curvature(half)
	steer -= YAW_DAMPING * (agent.yaw_rate - turning)
	return Vector2(steer, toward(agent, bend_speed(agent, _speed)))
