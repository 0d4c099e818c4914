class_name RoadlangScene
extends Node3D
## One world: everything a client has built in it, by kind and id, and the proof of it.

const Protocol := preload("../net/protocol.gd")
const Reader := preload("../net/reader.gd")
const Thing := preload("thing.gd")
const Segment := preload("segment.gd")
const Patch := preload("patch.gd")
const Paint := preload("paint.gd")
const Signals := preload("signals.gd")
const Tiles := preload("tiles.gd")
const Objects := preload("objects.gd")
const Handles := preload("handles.gd")
const PathPiece := preload("path_piece.gd")
const PathLine := preload("../agents/path_line.gd")
const Agent := preload("../agents/agent.gd")
const Weather := preload("weather.gd")
const Ground := preload("ground.gd")
const SensorCamera := preload("../sensors/camera.gd")
const Labels := preload("../sensors/labels.gd")

var builds := 0
var scene_name := ""
var extent := 0.0

var _things: Dictionary = {}
var _paths: Dictionary = {}
var _removed: Dictionary = {}
var _ground: Ground


func _init() -> void:
	_ground = Ground.new()
	add_child(_ground)


## Prepares an empty world of the given half extent, in meters.
func begin(title: String, reach: float) -> void:
	scene_name = title
	extent = reach
	_ground.cover(reach)


## Builds or rebuilds what a message says; returns "" or what is wrong.
func put(kind: int, thing_id: int, revision: int, reader: Reader) -> String:
	var key := key_of(kind, thing_id)
	var old: Thing = _things.get(key)
	var known: int = old.revision if old != null else int(_removed.get(key, -1))
	if revision <= known:
		return ""
	if _things.size() >= Protocol.MAX_THINGS:
		return "too many things"
	var made := _make(kind)
	made.kind = kind
	made.id = thing_id
	made.revision = revision
	var wrong := made.build(reader)
	if not wrong.is_empty():
		made.free()
		return wrong
	_things[key] = made
	add_child(made)
	if made is Agent and old is Agent:
		(made as Agent).go_on(old as Agent)
	if made is Weather:
		_take_weather(made)
	if old != null:
		_drop(old)
	builds += 1
	_note_path(made)
	return ""


func remove(kind: int, thing_id: int, revision: int) -> void:
	var key := key_of(kind, thing_id)
	var old: Thing = _things.get(key)
	if old != null and old.revision < revision:
		_drop(old)
		_things.erase(key)
		_note_path(old)
		_removed[key] = revision


func all(kind: int) -> Array[Thing]:
	var out: Array[Thing] = []
	for key in sorted_keys():
		var thing: Thing = _things[key]
		if thing.kind == kind:
			out.append(thing)
	return out


func agents() -> Array[Agent]:
	var out: Array[Agent] = []
	for thing in all(Protocol.AGENT):
		out.append(thing as Agent)
	return out


## The center line with this id, or null until all its pieces are there.
func path(path_id: int) -> PathLine:
	if not _paths.has(path_id):
		_paths[path_id] = PathLine.joined(_pieces(path_id))
	return _paths[path_id]


## Gives the agents their paths, before anything drives them.
func give_paths() -> void:
	for agent in agents():
		agent.follow(path(agent.path_id))


func sorted_keys() -> Array:
	var keys: Array = _things.keys()
	keys.sort()
	return keys


## Per thing: kind, id, revision and MD5 of its content, 25 bytes each, in order.
func records() -> PackedByteArray:
	var out := PackedByteArray()
	for key: int in sorted_keys():
		var thing: Thing = _things[key]
		var at := out.size()
		out.resize(at + 9)
		out.encode_u8(at, thing.kind)
		out.encode_u32(at + 1, thing.id)
		out.encode_u32(at + 5, thing.revision)
		out.append_array(Thing.md5(thing.content()))
	return out


func count() -> int:
	return _things.size()


static func key_of(kind: int, thing_id: int) -> int:
	return (kind << 32) | thing_id


func _make(kind: int) -> Thing:
	match kind:
		Protocol.SEGMENT:
			return Segment.new()
		Protocol.PATCH:
			return Patch.new()
		Protocol.PAINT:
			return Paint.new()
		Protocol.SIGNALS:
			return Signals.new()
		Protocol.TILES:
			return Tiles.new()
		Protocol.OBJECTS:
			return Objects.new()
		Protocol.PATH:
			return PathPiece.new()
		Protocol.HANDLES:
			return Handles.new()
		Protocol.AGENT:
			return Agent.new()
		Protocol.CAMERA:
			return SensorCamera.new()
		Protocol.LABELS:
			return Labels.new()
		_:
			return Weather.new()


func _take_weather(weather: Weather) -> void:
	_ground.cut(weather.is_dark())
	if weather.extent > extent:
		extent = weather.extent
		_ground.cover(extent)


func _drop(old: Thing) -> void:
	remove_child(old)
	old.queue_free()


func _note_path(thing: Thing) -> void:
	if thing is PathPiece:
		_paths.erase((thing as PathPiece).path_id())


func _pieces(path_id: int) -> Array[PathPiece]:
	var out: Array[PathPiece] = []
	for thing in all(Protocol.PATH):
		var piece := thing as PathPiece
		if piece.path_id() == path_id:
			out.append(piece)
	return out
