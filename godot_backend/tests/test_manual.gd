extends RefCounted
## What keys and sticks of a human mean.

const Agent := preload("../agents/agent.gd")
const Vehicle := preload("../agents/vehicle.gd")
const Manual := preload("../agents/controllers/manual.gd")


func test_keys_drive_and_brake() -> String:
	var drive := _command([_key(KEY_W, true)])
	var brake := _command([_key(KEY_W, false), _key(KEY_SPACE, true)])
	_command([_key(KEY_SPACE, false)])
	return "" if drive.y == 4.0 and brake.y == -8.0 else "%s %s" % [drive, brake]


func test_a_stick_steers_and_a_trigger_drives() -> String:
	var found := _command([_axis(JOY_AXIS_LEFT_X, -1.0), _axis(JOY_AXIS_TRIGGER_RIGHT, 0.5)])
	var loose := _command([_axis(JOY_AXIS_LEFT_X, 0.01), _axis(JOY_AXIS_TRIGGER_RIGHT, 0.0)])
	var right := found.x > 0.05 and absf(found.y - 2.0) < 1e-3 and loose.x == 0.0 and loose.y <= 0.0
	return "" if right else "%s %s" % [found, loose]


## What is decided at 5 m/s after some events, a tenth of a second later.
func _command(events: Array[InputEvent]) -> Vector2:
	for event in events:
		Input.parse_input_event(event)
	Input.flush_buffered_events()
	var agent := Agent.new()
	agent.body = Vehicle.new()
	agent.speed = 5.0
	var manual := Manual.new()
	manual.take({})
	var found: Vector2 = manual.command(agent, Callable(), 0.1)
	agent.body.free()
	agent.free()
	return found


func _key(key: Key, pressed: bool) -> InputEventKey:
	var event := InputEventKey.new()
	event.keycode = key
	event.physical_keycode = key
	event.pressed = pressed
	return event


func _axis(axis: JoyAxis, value: float) -> InputEventJoypadMotion:
	var event := InputEventJoypadMotion.new()
	event.axis = axis
	event.axis_value = value
	return event
