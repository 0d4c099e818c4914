extends RefCounted
## A scene of plain nodes as the bytes of a binary glTF file.

const Instances := preload("../build/instances.gd")

const PLACES := &"places"


## The bytes, empty where it fails. Many copies of one mesh share it in the file.
static func bytes_of(root: Node3D) -> PackedByteArray:
	var copied := _with_one_each(root)
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	if document.append_from_scene(root, state) != OK:
		return PackedByteArray()
	for one in copied:
		_add_copies(state, one)
	return document.generate_buffer(state)


## Puts one instance of its mesh in the place of every multimesh, which remembers the places of
## all. Godot's own conversion asks the renderer for them, and a headless one does not know.
static func _with_one_each(root: Node3D) -> Array[MeshInstance3D]:
	var out: Array[MeshInstance3D] = []
	for many: MultiMeshInstance3D in root.find_children("*", "MultiMeshInstance3D", true, false):
		var places := Instances.places_of(many.multimesh)
		if places.is_empty():
			continue
		var one := MeshInstance3D.new()
		one.mesh = many.multimesh.mesh
		one.material_override = many.material_override
		one.set_meta(PLACES, places)
		one.transform = many.transform * places[0]
		many.replace_by(one)
		many.free()
		out.append(one)
	return out


static func _add_copies(state: GLTFState, one: MeshInstance3D) -> void:
	var nodes := state.get_nodes()
	var first: GLTFNode = nodes[state.get_node_index(one)]
	var places: Array[Transform3D] = one.get_meta(PLACES)
	var above := first.xform * places[0].affine_inverse()
	var siblings: GLTFNode = nodes[first.parent]
	var children := siblings.children
	for i in range(1, places.size()):
		var copy := GLTFNode.new()
		copy.resource_name = "%s %d" % [one.name, i + 1]
		copy.mesh = first.mesh
		copy.parent = first.parent
		copy.xform = above * places[i]
		children.append(nodes.size())
		nodes.append(copy)
	siblings.children = children
	state.set_nodes(nodes)
