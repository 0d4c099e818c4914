extends "controller.gd"
## Pure pursuit of the line at a set speed.

var _speed := 0.0
## Negative: as far as suits the speed.
var _lookahead := -1.0
var _lookahead_time := 0.0


func read() -> void:
	_speed = number("speed", 50.0 / 3.6)
	_lookahead = number("lookahead", -1.0)
	_lookahead_time = number("lookahead_time", 0.0)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	var reach := _near(agent.speed) + _lookahead_time * maxf(agent.speed, 0.0)
	return Vector2(pursuit(agent, reach), toward(agent, bend_speed(agent, _speed)))


func _near(speed: float) -> float:
	return _lookahead if _lookahead >= 0.0 else 6.0 + 0.5 * maxf(speed - 15.0, 0.0)
