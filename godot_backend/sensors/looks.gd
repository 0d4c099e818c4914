extends Node
## Looks through the cameras that a client asks for, those of an agent in one frame, and sends what
## they see.

const Protocol := preload("../net/protocol.gd")
const Server := preload("../net/server.gd")
const Agent := preload("../agents/agent.gd")
const Objects := preload("../build/objects.gd")
const Stage := preload("../build/stage.gd")
const Surroundings := preload("../build/surroundings.gd")
const Worlds := preload("../build/worlds.gd")
const SensorCamera := preload("camera.gd")
const Twins := preload("twins.gd")

const SHADOW_PIXELS := 1024
const MOST_WAITING := 64

## What surrounds the first world, if anything does.
var scenery: Node

var _worlds: Worlds
var _server: Server
var _twins := Twins.new()
## Of shadows in a window.
var _shadow_pixels: int = ProjectSettings.get_setting(
	"rendering/lights_and_shadows/directional_shadow/size"
)
## Wishes, with the frames in which they came.
var _queue: Array[Array] = []


func _init(worlds: Worlds, server: Server) -> void:
	_worlds = worlds
	_server = server


## Takes a wish: {id, world, cameras: their ids, none for all}; returns "" or what is wrong.
func take(wish: Dictionary) -> String:
	if _worlds.stage(_world(wish)) == null or not wish.get("cameras", []) is Array:
		return "bad look"
	if _queue.size() >= MOST_WAITING:
		return "too many looks at once: wait for their frames"
	_queue.append([wish, Engine.get_process_frames()])
	return ""


## Looks where that is wished for. In lock-step no frame comes before the client's next step, so
## the simulation calls this while it waits.
func draw_waiting() -> void:
	while not _queue.is_empty() and not _server.is_behind():
		_look(_queue.pop_front()[0])


## The client that wished for something is gone.
func forget() -> void:
	_queue.clear()


func _process(_dt: float) -> void:
	# What was built in this frame is in its place from the next one on.
	if not _queue.is_empty() and Engine.get_process_frames() > int(_queue[0][1]) + 1:
		draw_waiting()


func _look(wish: Dictionary) -> void:
	var stage := _worlds.stage(_world(wish))
	if stage == null:
		return
	var wanted: Array = wish.get("cameras", [])
	var cameras: Array[SensorCamera] = []
	for thing in stage.all(Protocol.CAMERA):
		if wanted.is_empty() or wanted.has(float(thing.id)):
			cameras.append(thing as SensorCamera)
	_draw(stage, cameras, scenery if _world(wish) == 0 else null)
	var bytes := _report(stage, cameras).compress(FileAccess.COMPRESSION_DEFLATE)
	_server.send_parts(Protocol.FRAMES, Agent.count(wish, "id", 0), bytes)


func _draw(stage: Stage, cameras: Array[SensorCamera], around: Node) -> void:
	_twins.refresh(stage, around)
	# What has moved since the last frame is else drawn where it was.
	stage.propagate_call(&"force_update_transform")
	if around != null:
		around.propagate_call(&"force_update_transform")
	RenderingServer.directional_shadow_atlas_set_size(SHADOW_PIXELS, true)
	# A window is not drawn with them: its next frame comes soon enough.
	var window := get_tree().root
	var was_flat := window.disable_3d
	window.disable_3d = true
	var by_agent := {}
	for camera in cameras:
		by_agent.get_or_add(camera.agent, [] as Array[SensorCamera]).append(camera)
	for together: Array[SensorCamera] in by_agent.values():
		# Rain falls and lamps shine around one place at a time.
		Surroundings.prepare(stage, together[0].pose(stage).origin)
		for camera in together:
			camera.aim(camera.pose(stage))
		RenderingServer.force_draw(false)
	window.disable_3d = was_flat
	if RenderingServer.render_loop_enabled:
		RenderingServer.directional_shadow_atlas_set_size(_shadow_pixels, true)


## What moves and where it is, and each camera with its pose and pixels.
func _report(stage: Stage, cameras: Array[SensorCamera]) -> PackedByteArray:
	var out := StreamPeerBuffer.new()
	var movers := _movers(stage)
	out.put_u16(cameras.size())
	out.put_u16(movers.size())
	for mover in movers:
		out.put_u16(mover[0])
		out.put_u16(int((mover[1] as Node3D).is_visible_in_tree()))
		out.put_data(_packed(mover[2]))
	for camera in cameras:
		out.put_u32(camera.id)
		out.put_u16(camera.width)
		out.put_u16(camera.height)
		out.put_u32(camera.outputs)
		out.put_data(_packed(camera.pose(stage)))
		out.put_data(camera.seen())
	return out.data_array


## Numbers of the instances that move, their bodies, and those with the axes of an agent's.
func _movers(stage: Stage) -> Array[Array]:
	var out: Array[Array] = []
	for agent in stage.agents():
		out.append([_twins.label_of(agent).y, agent.body, agent.body.global_transform])
	for thing in stage.all(Protocol.OBJECTS):
		var first := _twins.label_of(thing).y
		var bodies := (thing as Objects).light_bodies()
		for i in bodies.size():
			# Ahead is +x of objects, +z of agents.
			var turned := Transform3D(Basis(Vector3.UP, PI / 2), Vector3.ZERO)
			out.append([first + i, bodies[i], bodies[i].global_transform * turned])
	return out


## The axes of a body, left, up and ahead, and its place: 12 f32.
static func _packed(place: Transform3D) -> PackedByteArray:
	var b := place.basis
	return PackedVector3Array([b.x, b.y, b.z, place.origin]).to_byte_array()


static func _world(wish: Dictionary) -> int:
	return int(Agent.number(wish, "world", 0.0))
