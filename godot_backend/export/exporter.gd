extends RefCounted
## The scene that is shown as a file that opens without roadlang: a Godot scene or glTF.
##
## The bytes go to the client, who writes them: this engine writes where no client says.

const Protocol := preload("../net/protocol.gd")
const Server := preload("../net/server.gd")
const Worlds := preload("../build/worlds.gd")
const Agent := preload("../agents/agent.gd")
const Cameras := preload("../view/cameras.gd")
const GltfFile := preload("gltf_file.gd")
const PlainScene := preload("plain_scene.gd")
const PlainMaterials := preload("plain_materials.gd")

var _worlds: Worlds
var _server: Server


func _init(worlds: Worlds, server: Server) -> void:
	_worlds = worlds
	_server = server


## Takes a wish: {id, format: tscn or glb, x, y, z, yaw, pitch of the camera}; returns "" or what is
## wrong.
func take(wish: Dictionary) -> String:
	var stage := _worlds.stage(0)
	if stage == null:
		return "no scene to export"
	var bytes := PackedByteArray()
	var materials := PlainMaterials.new()
	match wish.get("format"):
		"tscn":
			var root := PlainScene.with_bodies(stage, _eye(wish))
			materials.bundle(root)
			bytes = _as_scene(root)
			root.free()
		"glb":
			var root := PlainScene.to_look_at(stage)
			materials.simplify(root)
			bytes = GltfFile.bytes_of(root)
			root.free()
		_:
			return "an export is tscn or glb"
	if bytes.is_empty():
		return "the scene cannot be exported"
	_server.send_parts(Protocol.EXPORTED, Agent.count(wish, "id", 0), bytes)
	return ""


static func _eye(wish: Dictionary) -> Transform3D:
	var place := Vector3(
		Agent.number(wish, "x", 0.0), Agent.number(wish, "z", 100.0), -Agent.number(wish, "y", 0.0)
	)
	return Cameras.free_pose(
		place, Agent.number(wish, "yaw", 0.0), Agent.number(wish, "pitch", -PI / 2)
	)


## Godot saves scenes to files only: to one in this program's own folder, which goes at once.
static func _as_scene(root: Node3D) -> PackedByteArray:
	var packed := PackedScene.new()
	if packed.pack(root) != OK:
		return PackedByteArray()
	var path := "user://export-%d.tscn" % OS.get_process_id()
	if ResourceSaver.save(packed, path) != OK:
		return PackedByteArray()
	var bytes := FileAccess.get_file_as_bytes(path)
	DirAccess.remove_absolute(path)
	return bytes
