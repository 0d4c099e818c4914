class_name RoadlangStage
extends Node3D
## Listens for roadlang, and builds and drives the scenes that it sends as children of this node.
##
## Put one at the origin of a game of your own: what is built is in world coordinates (x east, z
## south, y up). The game keeps its own cameras and window; `roadlang compile --emit godot`,
## `roadlang run` and `roadlang watch` reach it at `host` and `port`.

## The engine listens, at this port.
signal listening(port: int)
## A client has begun a scene, of which nothing is built yet.
signal scene_begun(title: String)
## A client has had the scene that is built verified: it is complete.
signal scene_built
## A drive begins, or has ended: by its time (`time`), at the end of the road (`end`), ...
signal drive_begun
signal drive_ended(reason: String)

const Server := preload("net/server.gd")
const UdpLink := preload("net/udp_link.gd")
const WebSocketLink := preload("net/websocket_link.gd")
const Messages := preload("net/messages.gd")
const Worlds := preload("build/worlds.gd")
const Scene := preload("build/stage.gd")
const Agent := preload("agents/agent.gd")
const Simulation := preload("agents/simulation.gd")
const View := preload("view/view.gd")

## An idle engine that nobody watches polls this often, so that it does not take a core for nothing.
const IDLE_MSEC := 2
## The same without a client: only a hello has to wait.
const ALONE_MSEC := 20

## Address to listen on: other machines reach this one at their own risk.
@export var host := "127.0.0.1"
## Port to listen on; 0 takes a free one.
@export var port := 4242
@export_enum("udp", "websocket") var transport := "udp"
## Whether it listens from the beginning; else once `listen` is called.
@export var listens_at_once := true

## What it brings for the eye.
var eyes := View.Eyes.GUEST
## Whether a client that is not heard counts as gone after a minute. One whose end is noticed
## otherwise may be silent for as long as it likes: busy, or put to sleep.
var forgets_silent_clients := true

var _server: Server
var _worlds := Worlds.new()
var _simulation: Simulation
var _view: View
var _messages: Messages


func _ready() -> void:
	# Coordinates are those of the world, wherever this node stands.
	top_level = true
	global_transform = Transform3D.IDENTITY
	if listens_at_once:
		listen()


## Begins to listen. Fails where the port is in use.
func listen() -> Error:
	var link: RefCounted = WebSocketLink.new() if transport == "websocket" else UdpLink.new()
	var failed: Error = link.listen(host, port)
	if failed != OK:
		printerr("roadlang: cannot listen on %s:%s" % [host, port])
		return failed
	_worlds.fresh_spaces = eyes != View.Eyes.GUEST
	add_child(_worlds)
	_server = Server.new(link)
	if not forgets_silent_clients:
		_server.session_timeout_usec = 0
	_simulation = Simulation.new(_server, _worlds.stages)
	_simulation.begun.connect(drive_begun.emit)
	_simulation.ended.connect(drive_ended.emit)
	_view = View.new()
	_view.setup(_worlds, _server, eyes, get_viewport())
	add_child(_view)
	_simulation.while_waiting = _view.draw_waiting
	_messages = Messages.new(_worlds, _simulation, _view, _server)
	_messages.begun.connect(scene_begun.emit)
	_messages.proved.connect(scene_built.emit)
	_server.handler = _messages.handle
	_server.greeter = _messages.greet
	print("roadlang: listening on %s:%d (%s)" % [host, link.port(), transport])
	listening.emit(link.port())
	return OK


## The scene that is shown, or null before the first.
func scene() -> Scene:
	return _worlds.stage(0)


## The agents of the scene that is shown, in the order of their declaration.
func agents() -> Array[Agent]:
	var none: Array[Agent] = []
	return none if scene() == null else scene().agents()


## The agent of this name in the scene that is shown, or null.
func agent(of_name: String) -> Agent:
	for found in agents():
		if found.agent_name == of_name:
			return found
	return null


## Whether a client is there.
func is_connected_to_client() -> bool:
	return _server != null and _server.connected()


## Whether agents are driven.
func is_driving() -> bool:
	return _simulation != null and _simulation.running()


func _process(_dt: float) -> void:
	if _server == null:
		return
	var is_busy := _server.poll(true) or is_driving()
	var is_watched := eyes != View.Eyes.STILL and DisplayServer.get_name() != "headless"
	if eyes != View.Eyes.GUEST and not is_busy and not is_watched:
		OS.delay_msec(IDLE_MSEC if is_connected_to_client() else ALONE_MSEC)


func _physics_process(dt: float) -> void:
	if _simulation != null:
		_simulation.step(dt)
