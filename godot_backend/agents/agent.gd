class_name RoadlangAgent
extends "../build/thing.gd"
## Something that moves: a body, the path it should follow, and what drives it.

const Protocol := preload("../net/protocol.gd")
const Agent := preload("agent.gd")
const PathLine := preload("path_line.gd")
const FollowedLine := preload("followed_line.gd")
const Vehicle := preload("vehicle.gd")
const Walker := preload("walker.gd")
const Driver := preload("driver.gd")

const NO_PATH := -1
const ARRIVED := 0.5
## How far along its line an agent may be from where it was, in meters, and for each meter that it
## has driven: on the inside of a bend the line is longer.
const SLACK := 5.0
const WIDEST_BEND := 2.0

var agent_name := ""
var path_id := NO_PATH
var path: PathLine
## +1 along the path, -1 against it.
var direction := 1.0
var line := FollowedLine.new()
var body: PhysicsBody3D
var driver: Driver

## Since the last step.
var x := 0.0
var y := 0.0
var heading := 0.0
var speed := 0.0
var acceleration := 0.0
var jerk := 0.0
var yaw_rate := 0.0
## Along the path; looked up when it is asked for.
var station := 0.0:
	get:
		if _is_station_old:
			find_station()
		return station
## Left of the line to follow, seen along the direction of travel.
var cross_track_error := 0.0:
	get:
		if _is_station_old:
			find_station()
		return cross_track_error
## Along the path, in its direction of travel.
var traveled := 0.0:
	get:
		if _is_station_old:
			find_station()
		return traveled
## How many agents and objects it has touched.
var contacts := 0
## How often an edit has changed its start.
var placed := 0
## Whether it goes on as one that it has replaced.
var goes_on := false
## At the end of its path: nobody sees it or touches it any more.
var has_left := false

var _segment := -1
var _is_station_old := false
## Driven since its station was looked up, backward negative.
var _way := 0.0
var _start := Vector2.ZERO
var _start_heading := 0.0
var _start_speed := 0.0
var _start_station := 0.0
var _spec := PackedByteArray()


func build(reader: Reader) -> String:
	_spec = reader.rest()
	var spec := Reader.new(_spec).json()
	if spec.is_empty() or not spec.get("drives", []) is Array:
		return "bad agent"
	agent_name = str(spec.get("name", "agent"))
	path_id = int(number(spec, "path", NO_PATH))
	direction = -1.0 if number(spec, "direction", 1.0) < 0.0 else 1.0
	line = FollowedLine.new(number(spec, "offset", 0.0), spec.get("offsets"))
	_start = Vector2(number(spec, "x", 0.0), number(spec, "y", 0.0))
	_start_heading = number(spec, "heading", 0.0)
	_start_speed = number(spec, "speed", 0.0)
	_start_station = number(spec, "start", 0.0)
	placed = int(number(spec, "placed", 0.0))
	driver = Driver.new()
	var wrong := driver.take(spec.get("drives", []))
	if wrong.is_empty():
		_add_body(spec)
	return wrong


## What the scene tree holds of this agent: nothing where its body is gone.
func content() -> PackedByteArray:
	return _spec if is_instance_valid(body) and body.get_parent() == self else PackedByteArray()


## A finite number of a JSON object, or the usual one.
static func number(spec: Dictionary, key: String, usual: float) -> float:
	var value: Variant = spec.get(key)
	if value is float and is_finite(value) and absf(value) < Protocol.MAX_COORDINATE * 10.0:
		return value
	return usual


## A whole number of a JSON object, from 0 to 2^32 - 1, or the usual one.
static func count(spec: Dictionary, key: String, usual: int) -> int:
	var value: Variant = spec.get(key)
	return int(value) if value is float and value >= 0.0 and value < 4294967296.0 else usual


## Whether a JSON object has `true` there.
static func flag(spec: Dictionary, key: String) -> bool:
	var value: Variant = spec.get(key)
	return value is bool and value


## Back to the start, at the start's speed.
func reset(surfaces: PackedVector2Array) -> void:
	body.place(Vector3(_start.x, 0.0, -_start.y), _start_heading, _start_speed)
	body.set_surfaces(surfaces)
	driver.reset()
	x = _start.x
	y = _start.y
	traveled = 0.0
	contacts = 0
	acceleration = 0.0
	heading = _start_heading
	speed = _start_speed
	_way = 0.0
	_is_station_old = false
	_segment = -1
	if path != null:
		_segment = path.segment_at(_start_station)


## Goes on as an agent that it replaces, at its pose and speed, unless it was placed anew. Both are
## in the scene tree.
func go_on(earlier: Agent) -> void:
	if earlier.placed != placed:
		return
	goes_on = true
	body.go_on(earlier.body)
	driver.go_on(earlier.driver)
	x = earlier.x
	y = earlier.y
	heading = earlier.heading
	speed = earlier.speed
	acceleration = earlier.acceleration
	traveled = earlier.traveled
	contacts = earlier.contacts
	station = earlier.station
	has_left = earlier.has_left
	body.visible = earlier.body.visible


## Reads where the body has got to, `dt` after it was last read.
func observe(dt: float) -> void:
	var at := body.global_position
	var now: float = body.speed()
	var driven := Vector2(x, y).distance_to(Vector2(at.x, -at.z))
	_way += -driven if now < 0.0 else driven
	x = at.x
	y = -at.z
	var turned: float = body.heading()
	yaw_rate = angle_difference(heading, turned) / dt
	heading = turned
	jerk = ((now - speed) / dt - acceleration) / dt
	acceleration = (now - speed) / dt
	speed = now


## Finds where that is along the path.
func find_station() -> void:
	var way := _way if _is_station_old else 0.0
	var reach := SLACK + WIDEST_BEND * absf(way)
	var was_old := _is_station_old
	_is_station_old = false
	_way = 0.0
	if path == null:
		return
	var before := station
	_segment = path.nearest_to(x, y, before, reach) if was_old else path.nearest(x, y, _segment)
	station = path.station(_segment, x, y)
	var moved := station - before
	if path.closed:
		# Several laps may have passed.
		var usual := direction * way
		moved = wrapf(moved, usual - 0.5 * path.length, usual + 0.5 * path.length)
	traveled += moved * direction
	cross_track_error = direction * (path.offset(_segment, x, y) - line_offset(station))


## Its place along the path has changed: it is found when somebody asks for it.
func forget_station() -> void:
	_is_station_old = true


## Takes the path as it now is, after it was sent or changed.
func follow(line: PathLine) -> void:
	if line == path:
		return
	if _is_station_old:
		find_station()
	path = line
	_segment = -1
	if path != null:
		_segment = path.nearest(x, y)
		station = path.station(_segment, x, y)


func start_station() -> void:
	station = _start_station


## Length, height and width.
func size() -> Vector3:
	return body.size


## Share of the path that has been driven; 1 where the agent has arrived at its end.
func progress() -> float:
	if path == null or path.length <= 0.0:
		return 0.0
	if at_end():
		return 1.0
	if path.closed:
		return traveled / path.length
	var s := station if direction > 0.0 else path.length - station
	return s / path.length


## Within `ARRIVED` meters of the end of the path, where a drive is over.
func at_end() -> bool:
	if path == null:
		return false
	if path.closed:
		return traveled >= path.length
	return path.length - (station if direction > 0.0 else path.length - station) < ARRIVED


## The point of the line to follow that is `ahead` meters on, and its direction of travel there.
func ahead(meters: float) -> Vector2:
	var s := station + direction * meters
	return path.point(s, line_offset(s))


func line_heading(meters: float = 0.0) -> float:
	var s := station + direction * meters
	var along := path.heading(s) + line.turned(path, s)
	return along if direction > 0.0 else along + PI


func line_curvature(meters: float = 0.0) -> float:
	var s := station + direction * meters
	return direction * (path.curvature(s) + line.bend(path, s))


## Of the line to follow, left of the path's center line at an arc length.
func line_offset(s: float) -> float:
	return line.offset(path, s)


func _add_body(spec: Dictionary) -> void:
	var size := Vector3(
		clampf(number(spec, "length", 4.5), 0.2, 30.0),
		clampf(number(spec, "height", 1.45), 0.2, 6.0),
		clampf(number(spec, "width", 1.8), 0.2, 6.0)
	)
	var paint := Color.from_string(str(spec.get("color", "")), Color.DIM_GRAY).darkened(0.3)
	var category := str(spec.get("category", "car"))
	if str(spec.get("body", "")) == "walker":
		var walker := Walker.new()
		walker.assemble(size)
		walker.dress(category, size, paint)
		body = walker
	else:
		var vehicle := Vehicle.new()
		var numbers: Variant = spec.get("vehicle", {})
		var known: Dictionary = numbers if numbers is Dictionary else {}
		var read := func(key: String, usual: float) -> float: return number(known, key, usual)
		vehicle.assemble(size, read)
		vehicle.dress(category, paint, flag(spec, "marked"))
		vehicle.rest()
		body = vehicle
	add_child(body)
	body.transform = Transform3D(
		Basis(Vector3.UP, _start_heading + PI / 2), Vector3(_start.x, 0.0, -_start.y)
	)
