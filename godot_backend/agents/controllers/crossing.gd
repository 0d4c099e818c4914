extends "controller.gd"
## Walks across the road, at right angles to it, and stands still on the other side.

const Crossing := preload("crossing.gd")
const Walker := preload("../walker.gd")

var _speed := 1.4
var _beyond := 0.0
var _distance := 0.0
var _walked := 0.0
var _toward := NAN


func read() -> void:
	_speed = number("speed", 1.4)
	_beyond = number("beyond", 1.0)


func reset() -> void:
	_walked = 0.0
	_distance = 0.0
	_toward = NAN


func go_on(earlier: RefCounted) -> void:
	var other := earlier as Crossing
	_walked = other._walked
	_distance = other._distance
	_toward = other._toward


func command(agent: Agent, _signals: Callable, dt: float) -> Vector2:
	if is_nan(_toward):
		_begin(agent)
	var pace := _speed if _walked < _distance else 0.0
	_walked += pace * dt
	if agent.body is Walker:
		(agent.body as Walker).turn(_toward)
		(agent.body as Walker).pace(pace)
	return Vector2(NAN, 0.0)


func _begin(agent: Agent) -> void:
	if agent.path == null:
		_toward = agent.heading
		_distance = 10.0
		return
	var left := agent.direction * agent.cross_track_error + agent.line_offset
	var along := agent.path.heading(agent.station)
	_toward = along + (PI / 2 if left < 0.0 else -PI / 2)
	_distance = absf(left) + agent.path.half_width + _beyond
