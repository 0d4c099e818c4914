extends Node3D
## The whole program: a stage in a window of its own.
##
## Arguments after `--`: --host ADDRESS, --port N, --transport udp|websocket, --still,
## --quit-idle SECONDS without a client, --quit-with-parent when standard input ends. Then the
## folder of the file --log, to which the parent has directed the output, is removed in its stead.

const Stage := preload("roadlang_stage.gd")

var stage := Stage.new()

var _settings: Dictionary = {}
var _last_client := 0
var _parent: Thread


func _ready() -> void:
	# Seen in the editor alone.
	$Preview.free()
	_settings = read_arguments(OS.get_cmdline_user_args())
	_last_client = Time.get_ticks_msec()
	stage.host = _settings["host"]
	stage.port = int(_settings["port"])
	stage.transport = _settings["transport"]
	stage.eyes = Stage.View.Eyes.STILL if _settings["still"] else Stage.View.Eyes.WINDOW
	stage.listens_at_once = false
	stage.forgets_silent_clients = not _settings["quit-with-parent"]
	add_child(stage)
	if stage.listen() != OK:
		get_tree().quit(5)
	elif _settings["quit-with-parent"]:
		_parent = Thread.new()
		_parent.start(_follow_parent)


func _process(_dt: float) -> void:
	_quit_when_forgotten()


## Standard input ends with the process that started this one, however that ended. Nothing is saved
## here, so that nothing is lost.
func _follow_parent() -> void:
	while not OS.read_string_from_stdin().is_empty():
		pass
	var log_file: String = _settings["log"]
	if not log_file.is_empty():
		DirAccess.remove_absolute(log_file)
		DirAccess.remove_absolute(log_file.get_base_dir())
	OS.kill(OS.get_process_id())


## Whoever started this engine may be gone without a goodbye.
func _quit_when_forgotten() -> void:
	var now := Time.get_ticks_msec()
	var patience := float(_settings["quit-idle"])
	if stage.is_connected_to_client():
		_last_client = now
	elif patience > 0.0 and now - _last_client > patience * 1000.0:
		if _parent == null:
			get_tree().quit()
		else:
			# A thread that waits for standard input holds up a quit until it has read.
			OS.kill(OS.get_process_id())


static func read_arguments(given: PackedStringArray) -> Dictionary:
	var settings := {
		"host": "127.0.0.1", "port": "4242", "transport": "udp", "still": false, "quit-idle": "0"
	}
	settings["quit-with-parent"] = false
	settings["log"] = ""
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
