extends "controller.gd"
## Follows the middle of its lane: the bend's own steering angle, corrected for what is amiss.

var _speed := 0.0


func read() -> void:
	max_acceleration = number("acceleration", 2.0)
	max_deceleration = number("deceleration", 4.0)
	_speed = number("speed", 50.0 / 3.6)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	return Vector2(along_line(agent), toward(agent, bend_speed(agent, _speed)))
