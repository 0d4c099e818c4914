extends RefCounted
## What each message asks for, passed on to the part that does it.

## A client has begun a scene in the first world.
signal begun(title: String)
## A client has asked for the proof of what is built in the first world.
signal proved

const Protocol := preload("protocol.gd")
const Reader := preload("reader.gd")
const Server := preload("server.gd")
const Worlds := preload("../build/worlds.gd")
const Stage := preload("../build/stage.gd")
const Thing := preload("../build/thing.gd")
const Simulation := preload("../agents/simulation.gd")
const Agent := preload("../agents/agent.gd")
const View := preload("../view/view.gd")
const Exporter := preload("../export/exporter.gd")

const RECORD_BYTES := 25
const RECORDS_A_REPORT := 40
const MOST_EXTENT := 50000.0
const PROBE_FROM := 200.0

var _worlds: Worlds
var _simulation: Simulation
var _view: View
var _exporter: Exporter
var _server: Server


func _init(worlds: Worlds, simulation: Simulation, view: View, server: Server) -> void:
	_worlds = worlds
	_simulation = simulation
	_view = view
	_exporter = Exporter.new(worlds, server)
	_server = server


## What is sent to a new client about this engine.
func greet(_hello: Dictionary) -> Dictionary:
	_simulation.abandon()
	_view.abandon()
	return {
		"godot": Engine.get_version_info()["string"],
		"physics": ProjectSettings.get_setting("physics/3d/physics_engine"),
		"ticks": Engine.physics_ticks_per_second,
		"pictures": DisplayServer.get_name() != "headless",
	}


## Does what a message asks; returns "" or what is wrong with it.
func handle(type: int, payload: PackedByteArray) -> String:
	var reader := Reader.new(payload)
	if Protocol.is_thing(type):
		return _put(type, reader)
	match type:
		Protocol.BEGIN:
			return _begin(reader)
		Protocol.REMOVE:
			return _remove(reader)
		Protocol.COMMIT:
			return _commit(reader)
		Protocol.LIST:
			return _list(reader)
		Protocol.PROBE:
			return _probe(reader)
		Protocol.RUN:
			var settings := reader.json()
			return "bad run" if reader.failed else _run(settings)
		Protocol.STEP:
			return _simulation.take_step(payload)
		Protocol.STOP:
			_simulation.stop("stopped")
			return ""
		Protocol.VIEW, Protocol.SHOT, Protocol.NOTE, Protocol.LOOK:
			var wish := reader.json()
			return "bad view" if reader.failed else _view.take(type, wish)
		Protocol.EXPORT:
			var wish := reader.json()
			return "bad export" if reader.failed else _exporter.take(wish)
	return "this engine does not know this message"


func _begin(reader: Reader) -> String:
	var world := reader.u16()
	var flags := reader.u16()
	var settings := reader.json()
	if reader.failed or world >= Protocol.MAX_WORLDS:
		return "bad begin"
	_simulation.stop("new scene")
	if flags & 1:
		for other: int in _worlds.stages.keys():
			_worlds.drop(other)
	var ticks := int(Agent.number(settings, "ticks", 60.0))
	Engine.physics_ticks_per_second = clampi(ticks, 30, 1000)
	var extent := clampf(Agent.number(settings, "extent", 500.0), 50.0, MOST_EXTENT)
	_worlds.begin(world, str(settings.get("name", "")), extent)
	_view.scene_changed()
	if world == 0:
		begun.emit(_worlds.stage(0).scene_name)
	return ""


func _put(type: int, reader: Reader) -> String:
	var stage := _worlds.stage(reader.u16())
	reader.u16()
	var id := reader.u32()
	var revision := reader.u32()
	if reader.failed or stage == null:
		return "a thing for no world"
	var wrong := stage.put(type, id, revision, reader)
	if wrong.is_empty():
		_view.scene_changed()
		if type in [Protocol.AGENT, Protocol.WORLD, Protocol.SIGNALS]:
			_simulation.refresh()
		elif type == Protocol.OBJECTS:
			_simulation.take_objects(stage, id)
	return wrong


func _remove(reader: Reader) -> String:
	var stage := _worlds.stage(reader.u16())
	reader.u16()
	var id := reader.u32()
	var revision := reader.u32()
	var kind := reader.u8()
	if not reader.at_end() or stage == null:
		return "bad remove"
	stage.remove(kind, id, revision)
	if kind == Protocol.AGENT:
		_simulation.refresh()
	_view.scene_changed()
	return ""


func _commit(reader: Reader) -> String:
	var world := reader.u16()
	reader.u16()
	var commit := reader.u32()
	var stage := _worlds.stage(world)
	if not reader.at_end() or stage == null:
		return "bad commit"
	var out := PackedByteArray()
	out.resize(16)
	out.encode_u16(0, world)
	out.encode_u32(4, commit)
	out.encode_u32(8, stage.count())
	out.encode_u32(12, stage.builds)
	out.append_array(Thing.md5(stage.records()))
	_server.send(Protocol.BUILT, out)
	stage.give_paths()
	if world == 0:
		proved.emit()
	return ""


func _list(reader: Reader) -> String:
	var world := reader.u16()
	reader.u16()
	var request := reader.u32()
	var stage := _worlds.stage(world)
	if not reader.at_end() or stage == null:
		return "bad list"
	var records := stage.records()
	var most := RECORDS_A_REPORT * RECORD_BYTES
	var parts := maxi(1, ceili(float(records.size()) / most))
	for part in parts:
		var out := PackedByteArray()
		out.resize(8)
		out.encode_u32(0, request)
		out.encode_u16(4, part)
		out.encode_u16(6, parts)
		out.append_array(records.slice(part * most, (part + 1) * most))
		_server.send(Protocol.REPORT, out)
	return ""


## How high the ground is at a place, as physics sees it.
func _probe(reader: Reader) -> String:
	var request := reader.u32()
	var world := reader.u16()
	reader.u16()
	var x := reader.f32(Protocol.MAX_COORDINATE)
	var y := reader.f32(Protocol.MAX_COORDINATE)
	var stage := _worlds.stage(world)
	if not reader.at_end() or stage == null:
		return "bad probe"
	var query := PhysicsRayQueryParameters3D.create(
		Vector3(x, PROBE_FROM, -y), Vector3(x, -PROBE_FROM, -y)
	)
	var hit := stage.get_world_3d().direct_space_state.intersect_ray(query)
	var out := PackedByteArray()
	out.resize(12)
	out.encode_u32(0, request)
	out.encode_u8(4, int(not hit.is_empty()))
	if not hit.is_empty():
		out.encode_float(8, hit["position"].y)
	_server.send(Protocol.PROBED, out)
	return ""


func _run(settings: Dictionary) -> String:
	return _simulation.start(settings)
