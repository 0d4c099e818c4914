extends Node
## Renders pictures of the main world in any size, and sends them to the client.

const Protocol := preload("../net/protocol.gd")
const Server := preload("../net/server.gd")
const Agent := preload("../agents/agent.gd")
const Cameras := preload("cameras.gd")

const MOST_PIXELS := 8192
const MOST_WAITING := 64
## Size of the shadow map for each column of a picture, rounded to a power of two: with less,
## shadows are blocky in the foreground; more takes time and makes no visible difference. Cameras of
## agents use less.
const SHADOW_PIXELS := 3
const LEAST_SHADOW := 1024
const MOST_SHADOW := 4096

var _cameras: Cameras
var _server: Server
var _viewport := SubViewport.new()
var _camera := Camera3D.new()
var _queue: Array[Wish] = []


## A picture that was requested in an earlier frame.
class Wish:
	extends RefCounted
	var settings: Dictionary
	var frame: int

	func _init(wanted: Dictionary, since: int) -> void:
		settings = wanted
		frame = since


func _init(cameras: Cameras, server: Server) -> void:
	_cameras = cameras
	_server = server
	_viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	_viewport.msaa_3d = Viewport.MSAA_2X
	_viewport.add_child(_camera)
	add_child(_viewport)


## Handles a request: {id, width, height, format: png or jpg}; returns "" or what is wrong.
func take(wish: Dictionary) -> String:
	if _queue.size() >= MOST_WAITING:
		return "too many pictures at once: wait for them"
	_queue.append(Wish.new(wish, Engine.get_process_frames()))
	return ""


## The client that requested pictures has disconnected.
func forget() -> void:
	_queue.clear()


## Draws the requested pictures. In lockstep no frame comes before the client's next step, so
## the simulation calls this while it waits.
func draw_waiting() -> void:
	while not _queue.is_empty() and not _server.is_behind():
		_picture((_queue.pop_front() as Wish).settings)


func _process(_dt: float) -> void:
	# What was built in this frame is only in place in the next one.
	if not _queue.is_empty() and Engine.get_process_frames() > _queue[0].frame + 1:
		draw_waiting()


func _picture(wish: Dictionary) -> void:
	var width := clampi(int(Agent.number(wish, "width", 1280.0)), 16, MOST_PIXELS)
	var height := clampi(int(Agent.number(wish, "height", 720.0)), 16, MOST_PIXELS)
	_viewport.size = Vector2i(width, height)
	_viewport.world_3d = get_tree().root.find_world_3d()
	_camera.make_current()
	_cameras.aim(_camera)
	_camera.force_update_transform()
	_cameras.surround(_camera)
	_viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
	var shadow := clampi(nearest_po2(SHADOW_PIXELS * width), LEAST_SHADOW, MOST_SHADOW)
	RenderingServer.directional_shadow_atlas_set_size(shadow, true)
	RenderingServer.force_draw(false)
	var image := _viewport.get_texture().get_image()
	image.convert(Image.FORMAT_RGB8)
	var bytes := (
		image.save_jpg_to_buffer(0.92)
		if str(wish.get("format", "")) == "jpg"
		else image.save_png_to_buffer()
	)
	_server.send_parts(Protocol.PICTURE, Agent.count(wish, "id", 0), bytes)
