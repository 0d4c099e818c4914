extends "controller.gd"
## Slows to a speed, by default to a stop, and keeps it; steering is left to who steered before.

const STANDING := 0.15

var _deceleration := 6.0
var _speed := 0.0


func read() -> void:
	_deceleration = number("deceleration", 6.0)
	_speed = number("speed", 0.0)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	if _speed > 0.0:
		var held := clampf(SPEED_GAIN * (_speed - agent.speed), -_deceleration, max_acceleration)
		return Vector2(NAN, -_deceleration if agent.speed > _speed + STANDING else held)
	# Once it stands, the brake only holds it.
	return Vector2(NAN, -_deceleration if absf(agent.speed) > STANDING else -2.0)
