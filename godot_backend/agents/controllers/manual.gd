extends "controller.gd"
## A human: arrows or WASD steer and drive, space brakes hard; or the left stick and the triggers of
## a gamepad.

## rad/s: how fast hands turn the wheels.
const STEERING_RATE := 1.0
const DEAD_ZONE := 0.08
## m/s^2: without a foot on any pedal.
const COASTING := 0.5
const STANDING := 0.2

var _speed := 30.0
var _full_steering := 0.5
var _steering := 0.0


func read() -> void:
	_speed = number("speed", 30.0)
	_full_steering = number("steering", 0.5)
	max_acceleration = number("acceleration", 4.0)
	max_deceleration = number("deceleration", 8.0)


func reset() -> void:
	_steering = 0.0


func go_on(earlier: RefCounted) -> void:
	_steering = earlier._steering


func command(agent: Agent, _signals: Callable, dt: float) -> Vector2:
	# Fast cars steer less, so that a tap on a key is no spin.
	var full := _full_steering / (1.0 + 0.01 * agent.speed * agent.speed)
	_steering = move_toward(_steering, _wheel() * full, STEERING_RATE * dt)
	if Input.is_physical_key_pressed(KEY_SPACE):
		return Vector2(_steering, -max_deceleration)
	var pedals := _pedals()
	if pedals < 0.0:
		return Vector2(_steering, pedals * max_deceleration)
	if pedals > 0.0:
		return Vector2(_steering, minf(pedals * max_acceleration, toward(agent, _speed)))
	return Vector2(_steering, -COASTING if agent.speed > STANDING else 0.0)


## 1 for as far to the left as it goes, -1 to the right.
func _wheel() -> float:
	var keys := _held(KEY_LEFT, KEY_A) - _held(KEY_RIGHT, KEY_D)
	return keys if keys != 0.0 else -_axis(JOY_AXIS_LEFT_X)


## 1 for full drive, -1 for full brakes.
func _pedals() -> float:
	var keys := _held(KEY_UP, KEY_W) - _held(KEY_DOWN, KEY_S)
	if keys != 0.0:
		return keys
	var brake := _axis(JOY_AXIS_TRIGGER_LEFT)
	return -brake if brake > 0.0 else _axis(JOY_AXIS_TRIGGER_RIGHT)


func _axis(axis: JoyAxis) -> float:
	var value := Input.get_joy_axis(0, axis)
	return 0.0 if absf(value) < DEAD_ZONE else value


func _held(key: Key, other: Key) -> float:
	var held := Input.is_physical_key_pressed(key) or Input.is_physical_key_pressed(other)
	return 1.0 if held else 0.0
