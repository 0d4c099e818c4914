extends "controller.gd"
## Pure pursuit of the line at a set speed.

var _speed := 0.0
var _lookahead := 0.0
var _lookahead_time := 0.0


func read() -> void:
	_speed = number("speed", 50.0 / 3.6)
	_lookahead = number("lookahead", 6.0)
	_lookahead_time = number("lookahead_time", 0.0)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	var reach := _lookahead + _lookahead_time * maxf(agent.speed, 0.0)
	return Vector2(pursuit(agent, reach), toward(agent, bend_speed(agent, _speed)))
