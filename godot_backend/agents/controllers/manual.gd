extends "res://agents/controllers/controller.gd"
## A human at the keyboard: arrows or WASD steer and drive, space brakes hard.

const FULL_STEER := 0.5

var _speed := 20.0


func read() -> void:
	_speed = number("speed", 20.0)


func command(agent: Agent, _signals: Callable, _dt: float) -> Vector2:
	var left := _held(KEY_LEFT, KEY_A) - _held(KEY_RIGHT, KEY_D)
	var drive := _held(KEY_UP, KEY_W) - _held(KEY_DOWN, KEY_S)
	# Fast cars steer less, so that a tap on a key is no spin.
	var steer := left * FULL_STEER / (1.0 + 0.01 * agent.speed * agent.speed)
	if Input.is_physical_key_pressed(KEY_SPACE):
		return Vector2(steer, -max_deceleration)
	if drive > 0.0:
		return Vector2(steer, toward(agent, _speed))
	if drive < 0.0:
		return Vector2(steer, -max_deceleration)
	return Vector2(steer, -0.5 if agent.speed > 0.2 else 0.0)


func _held(key: Key, other: Key) -> float:
	var held := Input.is_physical_key_pressed(key) or Input.is_physical_key_pressed(other)
	return 1.0 if held else 0.0
