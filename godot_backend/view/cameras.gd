extends Node3D
## Chase, top and free camera. Keys 1, 2, 3 choose; the wheel zooms; the right button looks around.

enum Kind { CHASE, TOP, FREE }

const Worlds := preload("../build/worlds.gd")
const Protocol := preload("../net/protocol.gd")
const Agent := preload("../agents/agent.gd")
const Stage := preload("../build/stage.gd")
const Surroundings := preload("../build/surroundings.gd")

## Position of the chase camera, meters behind the center of a car and above the ground, and the
## size of that car.
const CHASE := Vector2(7.5, 2.2)
const CAR := Vector2(4.5, 1.45)
## Extra meters behind for each meter by which the followed agent is taller.
const BACK_FOR_TALL := 2.5
const TOP_HEIGHT := 400.0
const FLY_SPEED := 25.0
## Vertical field of view, in degrees.
const FIELD := 60.0

var kind := Kind.CHASE
var camera := Camera3D.new()

var _worlds: Worlds
var _agent := 0
var _center := Vector2.ZERO
var _top_size := 200.0
var _yaw := 0.6
var _pitch := -0.35
var _place := Vector3(0.0, 30.0, 60.0)
## The scene for which the free camera was placed so that it sees all of it.
var _framed := ""
var _field := FIELD


func setup(worlds: Worlds) -> void:
	_worlds = worlds
	camera.far = 6000.0
	camera.near = 0.1
	add_child(camera)


func make_current() -> void:
	camera.make_current()


## Handles a request: {camera, agent, x, y, z, yaw, pitch, size, field}; angles in radians, x east,
## y north, z up.
func take(wish: Dictionary) -> void:
	match wish.get("camera", ""):
		"chase":
			kind = Kind.CHASE
		"top":
			kind = Kind.TOP
		"free":
			kind = Kind.FREE
	_agent = int(Agent.number(wish, "agent", _agent))
	_center.x = Agent.number(wish, "x", _center.x)
	_center.y = Agent.number(wish, "y", _center.y)
	_top_size = clampf(Agent.number(wish, "size", _top_size), 5.0, 20000.0)
	_yaw = Agent.number(wish, "yaw", _yaw)
	_pitch = Agent.number(wish, "pitch", _pitch)
	_field = clampf(Agent.number(wish, "field", _field), 10.0, 120.0)
	if kind != Kind.CHASE and not _worlds.stage(0) == null:
		_framed = _worlds.stage(0).scene_name
	if kind == Kind.FREE:
		_place = Vector3(_center.x, Agent.number(wish, "z", _place.y), -_center.y)
	aim(camera)


## Moves a camera to the current view.
func aim(target: Camera3D) -> void:
	target.far = 6000.0
	target.fov = _field
	target.environment = null
	match kind:
		Kind.TOP:
			target.environment = _without_fog()
			target.projection = Camera3D.PROJECTION_ORTHOGONAL
			target.size = _top_size
			target.near = 1.0
			target.transform = Transform3D(
				Basis(Vector3.RIGHT, -PI / 2), Vector3(_center.x, TOP_HEIGHT, -_center.y)
			)
		Kind.FREE:
			target.projection = Camera3D.PROJECTION_PERSPECTIVE
			# Depth is most precise when the near plane is far away.
			target.near = clampf(0.05 * _place.y, 0.1, 10.0)
			target.transform = free_pose(_place, _yaw, _pitch)
		Kind.CHASE:
			_chase(target)


## Direction of the free camera: radians counterclockwise from east, and upward.
static func free_pose(place: Vector3, yaw: float, pitch: float) -> Transform3D:
	return Transform3D(Basis(Vector3.UP, yaw - PI / 2) * Basis(Vector3.RIGHT, pitch), place)


## How far the chase camera is behind and above an agent of this length and height: above its roof,
## and far enough away that the agent does not fill the picture.
static func chase_offset(size: Vector3) -> Vector2:
	var taller := maxf(size.y - CAR.y, 0.0)
	var longer := maxf(size.x - CAR.x, 0.0)
	return CHASE + Vector2(0.5 * longer + BACK_FOR_TALL * taller, taller)


## Prepares the world for this kind of camera.
func surround(target: Camera3D) -> void:
	var stage := _worlds.stage(0)
	if stage != null:
		Surroundings.prepare(stage, target.global_position, kind != Kind.TOP)


func has_no_scene() -> bool:
	return _worlds.stage(0) == null


## Places the top and free cameras so that they see the whole scene, unless the client has moved
## them.
func _frame() -> void:
	var stage := _worlds.stage(0)
	if stage == null or stage.scene_name == _framed:
		return
	_framed = stage.scene_name
	var around := roads_of(stage)
	var middle := around.get_center()
	var reach := maxf(0.5 * maxf(around.size.x, around.size.y), 20.0)
	_center = Vector2(middle.x, -middle.y)
	_top_size = 2.1 * reach
	_yaw = PI / 4
	_pitch = -0.45
	_place = Vector3(middle.x - 1.2 * reach, 0.85 * reach + 5.0, middle.y + 1.2 * reach)


## The bounds of the roads in x and z: after edits the ground may be much larger.
static func roads_of(stage: Stage) -> Rect2:
	var out := Rect2()
	for road_kind: int in [Protocol.SEGMENT, Protocol.PATCH, Protocol.TILES]:
		for thing in stage.all(road_kind):
			for drawn: VisualInstance3D in thing.find_children(
				"*", "VisualInstance3D", true, false
			):
				var box := drawn.get_aabb()
				var flat := Rect2(box.position.x, box.position.z, box.size.x, box.size.z)
				out = out.merge(flat) if out.has_area() else flat
	return out


## The requested agent, or else the first one.
func _followed() -> Agent:
	var stage := _worlds.stage(0)
	var agents: Array[Agent] = []
	if stage != null:
		agents = stage.agents()
	for agent in agents:
		if agent.id == _agent:
			return agent
	return null if agents.is_empty() else agents[0]


## From high above, there would be too much fog between camera and ground.
func _without_fog() -> Environment:
	var stage := _worlds.stage(0)
	if stage == null or stage.all(Protocol.WORLD).is_empty():
		return null
	var clear: Environment = stage.all(Protocol.WORLD)[0].air().duplicate()
	clear.fog_enabled = false
	return clear


func _chase(target: Camera3D) -> void:
	target.projection = Camera3D.PROJECTION_PERSPECTIVE
	target.near = 0.3
	var agent := _followed()
	if agent == null:
		return
	var at := agent.body.global_position
	var heading: float = agent.body.heading()
	var forward := Vector3(cos(heading), 0.0, -sin(heading))
	var off := chase_offset(agent.size())
	var eye := at - forward * off.x + Vector3.UP * off.y
	target.look_at_from_position(eye, at + forward * 8.0 + Vector3.UP * 0.9, Vector3.UP)


func _process(dt: float) -> void:
	if kind == Kind.FREE:
		_fly(dt)
	aim(camera)
	surround(camera)


func _fly(dt: float) -> void:
	var way := Vector3.ZERO
	var keys := {
		KEY_I: Vector3.FORWARD,
		KEY_K: Vector3.BACK,
		KEY_J: Vector3.LEFT,
		KEY_L: Vector3.RIGHT,
		KEY_U: Vector3.DOWN,
		KEY_O: Vector3.UP
	}
	for key: Key in keys:
		if Input.is_physical_key_pressed(key):
			way += keys[key]
	_place += camera.basis * way * FLY_SPEED * dt


func _unhandled_input(event: InputEvent) -> void:
	if event is InputEventKey and event.is_pressed():
		match (event as InputEventKey).keycode:
			KEY_1:
				kind = Kind.CHASE
			KEY_2:
				kind = Kind.TOP
				_frame()
			KEY_3:
				kind = Kind.FREE
				_frame()
			KEY_TAB:
				_agent += 1
				if _followed() == null or _followed().id != _agent:
					_agent = 0
	if event is InputEventMouseButton and event.is_pressed():
		match (event as InputEventMouseButton).button_index:
			MOUSE_BUTTON_WHEEL_UP:
				_top_size = maxf(_top_size * 0.9, 5.0)
			MOUSE_BUTTON_WHEEL_DOWN:
				_top_size = minf(_top_size * 1.1, 20000.0)
	var motion := event as InputEventMouseMotion
	if motion != null and Input.is_mouse_button_pressed(MOUSE_BUTTON_RIGHT):
		if kind == Kind.TOP:
			var meters := _top_size / get_viewport().get_visible_rect().size.y
			_center += Vector2(-motion.relative.x, motion.relative.y) * meters
		else:
			_yaw -= motion.relative.x * 0.005
			_pitch = clampf(_pitch - motion.relative.y * 0.005, -1.5, 1.5)
