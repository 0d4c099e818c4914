extends "res://agents/controllers/controller.gd"
## Slows to a stop and stays there; steering is left to whoever steered before.

const STANDING := 0.15

var _deceleration := 6.0


func read() -> void:
	_deceleration = number("deceleration", 6.0)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	# Once it stands, the brake only holds it.
	return Vector2(NAN, -_deceleration if absf(agent.speed) > STANDING else -2.0)
