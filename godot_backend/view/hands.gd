extends Control
## Lets a person drag handles with the mouse: circles of the same size on screen for every camera.
##
## The handle under the pointer is highlighted; a click selects it. Delete removes the selected
## handle, Insert adds one at the pointer, Ctrl+Z and Ctrl+Y undo and redo. Every edit is sent to
## the client.

const Protocol := preload("../net/protocol.gd")
const Server := preload("../net/server.gd")
const Worlds := preload("../build/worlds.gd")
const Stage := preload("../build/stage.gd")
const Handles := preload("../build/handles.gd")
const Agent := preload("../agents/agent.gd")
const Cameras := preload("cameras.gd")

## Greatest distance in pixels at which the pointer grabs a handle.
const GRIP := 14.0
## Pixels that the pointer must move before a press becomes a drag.
const SLACK := 4.0
const RADIUS := 6.0
## Distance in meters beyond which a camera near the ground shows no handles.
const FAR := 300.0
const ABOVE := 0.2
const TELL_USEC := 20000
const NOTHING := {"id": 0, "index": 0}
const COLORS: Array[Color] = [
	Color(1.0, 0.8, 0.2),
	Color(0.4, 0.85, 1.0),
	Color(0.55, 0.95, 0.45),
	Color(1.0, 0.5, 0.75),
	Color(1.0, 0.45, 0.25),
	Color(0.4, 0.85, 1.0)
]

var _worlds: Worlds
var _cameras: Cameras
var _server: Server
## Handles by the id of the thing that they belong to and their index in it.
var _hovered := NOTHING
var _selected := NOTHING
var _held := NOTHING
## The pixel of the press, and whether the pointer has moved since.
var _pressed := Vector2.ZERO
var _is_dragged := false
## Offset from the place of the pointer on the ground to the dragged handle.
var _offset := Vector2.ZERO
var _to := Vector2.ZERO
## Place of the dragged handle when it was grabbed.
var _from := Vector2.ZERO
var _drag := 0
var _told := 0


func setup(worlds: Worlds, cameras: Cameras, server: Server) -> void:
	_worlds = worlds
	_cameras = cameras
	_server = server
	mouse_filter = MOUSE_FILTER_IGNORE
	set_anchors_preset(PRESET_FULL_RECT)


## Whether a handle is being dragged.
func is_dragging() -> bool:
	return _is_dragged and not _same(_held, NOTHING)


## Grabs a handle, or releases it.
func hold(handle: Dictionary) -> void:
	_held = handle
	_is_dragged = not _same(handle, NOTHING)


## The place on the ground under a pixel: x east, y north.
static func on_ground(camera: Camera3D, pixel: Vector2) -> Vector2:
	var origin := camera.project_ray_origin(pixel)
	var direction := camera.project_ray_normal(pixel)
	if absf(direction.y) < 1e-6:
		return Vector2(origin.x, -origin.z)
	var hit := origin - direction * (origin.y / direction.y)
	return Vector2(hit.x, -hit.z)


## The handle that the pointer would grab, with its place; agents can be grabbed anywhere on their
## bodies too.
func under(pixel: Vector2) -> Dictionary:
	var best := NOTHING
	var least := GRIP
	for handles in _all():
		for index in handles.count():
			for place in _grips(handles, index):
				var away := _pixel(place).distance_to(pixel)
				if away < least:
					least = away
					best = {"id": handles.id, "index": index, "place": place}
	return best


func _process(_dt: float) -> void:
	queue_redraw()


func _draw() -> void:
	for handles in _all():
		for index in handles.count():
			var this := {"id": handles.id, "index": index}
			var is_held := _same(this, _held)
			var at := _pixel(_to if is_held else handles.place(index))
			if not at.is_finite():
				continue
			var is_lit := is_held or _same(this, _hovered)
			draw_circle(at, RADIUS + 3.0 if is_lit else RADIUS, Color(0, 0, 0, 0.5))
			draw_circle(at, RADIUS + 1.5 if is_lit else RADIUS - 1.5, COLORS[handles.sort])
			if _same(this, _selected):
				draw_arc(at, RADIUS + 6.0, 0.0, TAU, 32, Color.WHITE, 2.0)
			if is_lit:
				draw_string(ThemeDB.fallback_font, at + Vector2(14, -8), handles.title)


func _unhandled_input(event: InputEvent) -> void:
	var button := event as InputEventMouseButton
	if button != null and button.button_index == MOUSE_BUTTON_LEFT:
		if button.pressed:
			_take(button.position)
		elif not _same(_held, NOTHING):
			_move_to(button.position, true)
			hold(NOTHING)
	var motion := event as InputEventMouseMotion
	if motion != null and _same(_held, NOTHING):
		_hovered = under(motion.position)
	elif motion != null:
		_move_to(motion.position, false)
	var key := event as InputEventKey
	if key != null and key.pressed and not key.echo:
		_press(key)


func _take(pixel: Vector2) -> void:
	var found := under(pixel)
	_selected = found
	hold(found)
	_is_dragged = false
	_hovered = found
	if _same(found, NOTHING):
		return
	_pressed = pixel
	_drag += 1
	_to = found["place"]
	_from = _to
	_offset = _to - on_ground(_cameras.camera, pixel)


func _move_to(pixel: Vector2, done: bool) -> void:
	_is_dragged = _is_dragged or pixel.distance_to(_pressed) > SLACK
	if not _is_dragged:
		return
	var to := on_ground(_cameras.camera, pixel) + _offset
	var is_new := not to.is_equal_approx(_to)
	_to = to
	if done or (is_new and Time.get_ticks_usec() - _told > TELL_USEC):
		_told = Time.get_ticks_usec()
		var ends := {"from": [_from.x, _from.y], "to": [_to.x, _to.y]}
		ends.merge({"drag": _drag, "done": done})
		_tell("move", _held, ends)


func _press(key: InputEventKey) -> void:
	var is_command := key.is_command_or_control_pressed()
	if is_command and key.keycode == KEY_Z:
		_tell("redo" if key.shift_pressed else "undo", NOTHING)
	elif is_command and key.keycode == KEY_Y:
		_tell("redo", NOTHING)
	elif key.keycode == KEY_DELETE and not _same(_selected, NOTHING):
		_tell("remove", _selected)
		_selected = NOTHING
	elif key.keycode == KEY_INSERT:
		var place := on_ground(_cameras.camera, get_viewport().get_mouse_position())
		var near := _nearest_of_roads(place)
		if not _same(near, NOTHING):
			_tell("insert", near, {"to": [place.x, place.y]})


func _tell(what: String, handle: Dictionary, more: Dictionary = {}) -> void:
	var edit := {"what": what, "id": handle["id"], "index": handle["index"]}
	edit.merge(more)
	_server.send_json(Protocol.EDIT, edit)


func _nearest_of_roads(place: Vector2) -> Dictionary:
	var best := NOTHING
	var least := INF
	for handles in _all():
		for index in handles.count() if handles.is_of_road() else 0:
			var away := handles.place(index).distance_to(place)
			if away < least:
				least = away
				best = {"id": handles.id, "index": index}
	return best


func _all() -> Array[Handles]:
	var out: Array[Handles] = []
	var stage := _worlds.stage(0)
	if stage != null:
		for thing in stage.all(Protocol.HANDLES):
			out.append(thing as Handles)
	return out


func _grips(handles: Handles, index: int) -> Array[Vector2]:
	var out: Array[Vector2] = [handles.place(index)]
	if handles.sort == Handles.Sort.AGENT:
		for agent in _worlds.stage(0).agents():
			if agent.agent_name == handles.title:
				out.append(Vector2(agent.body.global_position.x, -agent.body.global_position.z))
	return out


## The pixel at which the camera sees a place; infinite if it does not see it.
func _pixel(place: Vector2) -> Vector2:
	var camera := _cameras.camera
	var at := Vector3(place.x, ABOVE, -place.y)
	if camera.is_position_behind(at):
		return Vector2.INF
	var is_flat := camera.projection == Camera3D.PROJECTION_ORTHOGONAL
	if not is_flat and camera.global_position.distance_to(at) > FAR:
		return Vector2.INF
	return camera.unproject_position(at)


static func _same(one: Dictionary, other: Dictionary) -> bool:
	return one["id"] == other["id"] and one["index"] == other["index"]
