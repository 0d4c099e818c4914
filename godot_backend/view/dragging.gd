extends Node3D
## Lets a human move objects and road points with the mouse; each move is told to the client.

const Protocol := preload("res://net/protocol.gd")
const Server := preload("res://net/server.gd")
const Worlds := preload("res://build/worlds.gd")
const Stage := preload("res://build/stage.gd")
const Objects := preload("res://build/objects.gd")
const Cameras := preload("res://view/cameras.gd")

const GRIP := 4.0
const TELL_USEC := 33000

var _worlds: Worlds
var _cameras: Cameras
var _server: Server
var _held: Dictionary = {}
var _from := Vector2.ZERO
var _told := 0


func setup(worlds: Worlds, cameras: Cameras, server: Server) -> void:
	_worlds = worlds
	_cameras = cameras
	_server = server


## The place on the ground under a pixel: x east, y north.
static func on_ground(camera: Camera3D, pixel: Vector2) -> Vector2:
	var origin := camera.project_ray_origin(pixel)
	var direction := camera.project_ray_normal(pixel)
	if absf(direction.y) < 1e-6:
		return Vector2(origin.x, -origin.z)
	var hit := origin - direction * (origin.y / direction.y)
	return Vector2(hit.x, -hit.z)


## What can be held near a place: the nearest object, else the nearest path point.
static func grasp(stage: Stage, place: Vector2) -> Dictionary:
	var best: Dictionary = {}
	var least := GRIP
	for thing in stage.all(Protocol.OBJECTS):
		var here := (thing as Objects).places()
		for i in here.size():
			var away := Vector2(here[i].origin.x, -here[i].origin.z).distance_to(place)
			if away < least:
				least = away
				best = {"what": "object", "id": thing.id, "index": i}
	if not best.is_empty():
		return best
	for thing in stage.all(Protocol.PATH):
		var points: PackedFloat32Array = thing.get("points")
		for i in points.size() / 3:
			var away := Vector2(points[3 * i], -points[3 * i + 1]).distance_to(place)
			if away < least:
				least = away
				best = {"what": "road", "id": thing.id, "index": i}
	return best


func _unhandled_input(event: InputEvent) -> void:
	var stage := _worlds.stage(0)
	if stage == null:
		return
	var button := event as InputEventMouseButton
	if button != null and button.button_index == MOUSE_BUTTON_LEFT:
		var place := on_ground(_cameras.camera, button.position)
		if button.pressed:
			_held = grasp(stage, place)
			_from = place
		elif not _held.is_empty():
			_tell(place, true)
			_held = {}
	var motion := event as InputEventMouseMotion
	if motion != null and not _held.is_empty():
		if Time.get_ticks_usec() - _told > TELL_USEC:
			_tell(on_ground(_cameras.camera, motion.position), false)


func _tell(place: Vector2, done: bool) -> void:
	_told = Time.get_ticks_usec()
	var edit := _held.duplicate()
	edit.merge({"from": [_from.x, _from.y], "to": [place.x, place.y], "done": done})
	_server.send_json(Protocol.EDIT, edit)
