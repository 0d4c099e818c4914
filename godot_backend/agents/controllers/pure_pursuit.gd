extends "res://agents/controllers/controller.gd"
## Pure pursuit of the line at a set speed.

const LOOKAHEAD_TIME := 0.6
const LEAST_LOOKAHEAD := 4.0
const MOST_LOOKAHEAD := 20.0

var _speed := 0.0
var _lookahead := 0.0


func read() -> void:
	_speed = number("speed", 10.0)
	_lookahead = number("lookahead", 0.0)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	var reach := _lookahead
	if reach <= 0.0:
		reach = clampf(LOOKAHEAD_TIME * agent.speed, LEAST_LOOKAHEAD, MOST_LOOKAHEAD)
	return Vector2(pursuit(agent, reach), towards(agent, _speed))
