extends Node3D
## The whole program: listens, builds what it is sent, drives it, shows it.
##
## Arguments after `--`: --host ADDRESS, --port N, --transport udp|websocket, --still,
## --quit-idle SECONDS without a client, --quit-with-parent when standard input ends.

const Protocol := preload("net/protocol.gd")
const Server := preload("net/server.gd")
const UdpLink := preload("net/udp_link.gd")
const WebSocketLink := preload("net/websocket_link.gd")
const Messages := preload("net/messages.gd")
const Worlds := preload("build/worlds.gd")
const Simulation := preload("agents/simulation.gd")
const View := preload("view/view.gd")

## An idle engine polls this often, so that it does not take a core for nothing.
const IDLE_MSEC := 2

var server: Server
var worlds: Worlds
var simulation: Simulation
var view: View

var _messages: Messages
var _settings: Dictionary = {}
var _last_client := 0
var _parent: Thread


func _ready() -> void:
	_settings = read_arguments(OS.get_cmdline_user_args())
	_last_client = Time.get_ticks_msec()
	var link: RefCounted = (
		WebSocketLink.new() if _settings["transport"] == "websocket" else UdpLink.new()
	)
	if link.listen(_settings["host"], int(_settings["port"])) != OK:
		printerr("roadlang: cannot listen on %s:%s" % [_settings["host"], _settings["port"]])
		get_tree().quit(5)
		return
	if _settings["quit-with-parent"]:
		_parent = Thread.new()
		_parent.start(_follow_parent)
	worlds = Worlds.new()
	add_child(worlds)
	server = Server.new(link)
	simulation = Simulation.new(server, worlds.stages)
	view = View.new()
	view.setup(worlds, server, bool(_settings["still"]))
	add_child(view)
	simulation.while_waiting = view.draw_waiting
	_messages = Messages.new(worlds, simulation, view, server)
	server.handler = _messages.handle
	server.greeter = _messages.greet
	print(
		(
			"roadlang: listening on %s:%d (%s)"
			% [_settings["host"], link.port(), _settings["transport"]]
		)
	)


func _process(_dt: float) -> void:
	if server == null:
		return
	var busy := server.poll(true)
	_quit_when_forgotten()
	if not busy and not simulation.running() and DisplayServer.get_name() == "headless":
		OS.delay_msec(IDLE_MSEC)


## Standard input ends with the process that started this one, however that ended. Nothing is saved
## here, so that nothing is lost.
func _follow_parent() -> void:
	while not OS.read_string_from_stdin().is_empty():
		pass
	OS.kill(OS.get_process_id())


## Whoever started this engine may be gone without a goodbye.
func _quit_when_forgotten() -> void:
	var now := Time.get_ticks_msec()
	var patience := float(_settings["quit-idle"])
	if server.connected():
		_last_client = now
	elif patience > 0.0 and now - _last_client > patience * 1000.0:
		if _parent == null:
			get_tree().quit()
		else:
			# A thread that waits for standard input holds up a quit until it has read.
			OS.kill(OS.get_process_id())


func _physics_process(dt: float) -> void:
	if simulation != null:
		simulation.step(dt)


static func read_arguments(given: PackedStringArray) -> Dictionary:
	var settings := {
		"host": "127.0.0.1", "port": "4242", "transport": "udp", "still": false, "quit-idle": "0"
	}
	settings["quit-with-parent"] = false
	var i := 0
	while i < given.size():
		var key := given[i].trim_prefix("--")
		if settings.get(key) is bool:
			settings[key] = true
		elif settings.has(key) and i + 1 < given.size():
			i += 1
			settings[key] = given[i]
		i += 1
	return settings
