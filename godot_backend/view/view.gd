extends Node3D
## What a person sees and does: cameras, pictures, the overlay, handles.

## It works in a window of roadlang, without a window (where only requested pictures are drawn), and
## in a game that keeps its own cameras, window and landscape.
enum Eyes { WINDOW, STILL, GUEST }

const Protocol := preload("../net/protocol.gd")
const Server := preload("../net/server.gd")
const Worlds := preload("../build/worlds.gd")
const Cameras := preload("cameras.gd")
const Shots := preload("shots.gd")
const Overlay := preload("overlay.gd")
const Hands := preload("hands.gd")
const Detail := preload("detail.gd")
const Scenery := preload("scenery.gd")
const SensorLooks := preload("../sensors/looks.gd")

var cameras := Cameras.new()

var _headless := true
var _eyes := Eyes.WINDOW
var _server: Server
var _shots: Shots
var _looks: SensorLooks
var _overlay: Overlay
var _scenery: Scenery
var _stale := false


func setup(worlds: Worlds, server: Server, eyes: Eyes, window: Viewport) -> void:
	_headless = DisplayServer.get_name() == "headless"
	_server = server
	_eyes = eyes
	if _headless:
		return
	cameras.setup(worlds)
	add_child(cameras)
	_shots = Shots.new(cameras, server)
	add_child(_shots)
	_looks = SensorLooks.new(worlds, server)
	add_child(_looks)
	cameras.set_process_unhandled_input(eyes == Eyes.WINDOW)
	if eyes == Eyes.GUEST:
		return
	_scenery = Scenery.new(worlds)
	add_child(_scenery)
	_looks.scenery = _scenery
	if eyes == Eyes.STILL:
		return
	cameras.make_current()
	_overlay = Overlay.new()
	add_child(_overlay)
	var hands := Hands.new()
	hands.setup(worlds, cameras, server)
	_overlay.add_child(hands)
	add_child(Detail.new(worlds, hands, window))


func _ready() -> void:
	if _eyes == Eyes.STILL and not _headless:
		get_viewport().disable_3d = true
		RenderingServer.render_loop_enabled = false


## Records that something was built or removed.
func scene_changed() -> void:
	_stale = true


## Handles a request of the client; returns "" or the reason why it is refused.
func take(type: int, wish: Dictionary) -> String:
	if _headless:
		return "" if type == Protocol.NOTE else "this engine runs headless: it has no pictures"
	match type:
		Protocol.VIEW:
			cameras.take(wish)
		Protocol.SHOT:
			_refresh()
			return _shots.take(wish)
		Protocol.LOOK:
			_refresh()
			return _looks.take(wish)
		Protocol.NOTE:
			if _overlay != null:
				_overlay.take(wish)
	return ""


## The client has disconnected: its requests are dropped.
func abandon() -> void:
	if _shots != null:
		_shots.forget()
		_looks.forget()


## Draws pending requests, in a frame that lasts until the client's next step.
func draw_waiting() -> void:
	if _shots != null:
		_shots.draw_waiting()
		_looks.draw_waiting()


func _process(_dt: float) -> void:
	if not _headless and _eyes == Eyes.WINDOW:
		_refresh()
		_overlay.welcome(_server.port(), cameras.has_no_scene())


func _refresh() -> void:
	if _stale and _scenery != null:
		_stale = false
		_scenery.rebuild()
