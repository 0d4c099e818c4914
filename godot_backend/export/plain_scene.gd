extends RefCounted
## A copy of a built scene in nodes of Godot alone: no scripts, names that a human understands.

const Looks := preload("../build/looks.gd")
const Stage := preload("../build/stage.gd")
const Thing := preload("../build/thing.gd")
const Agent := preload("../agents/agent.gd")
const Protocol := preload("../net/protocol.gd")
const Cameras := preload("../view/cameras.gd")

## What the groups of things are called.
const GROUPS := {
	Protocol.SEGMENT: "Roads",
	Protocol.PATCH: "Roads",
	Protocol.PAINT: "Roads",
	Protocol.TILES: "Roads",
	Protocol.OBJECTS: "Objects",
	Protocol.SIGNALS: "Signals",
	Protocol.AGENT: "Agents",
	Protocol.WORLD: "Sky",
}
## Drawn on this layer is what a human sees.
const SEEN := 1
## Of a node that is copied these are not: they name what the copy does not have.
const OWN: Array[StringName] = [
	&"script", &"owner", &"multiplayer", &"name", &"unique_name_in_owner"
]


## With bodies to drive on and a camera at `eye`, as a scene of Godot.
static func with_bodies(stage: Stage, eye: Transform3D) -> Node3D:
	var root := _copied(stage, true)
	var camera := Camera3D.new()
	camera.name = "Camera"
	camera.far = 6000.0
	camera.fov = Cameras.FIELD
	camera.current = true
	camera.transform = eye
	root.add_child(camera)
	_own(root, root)
	return root


## What is seen, and no more.
static func to_look_at(stage: Stage) -> Node3D:
	var root := _copied(stage, false)
	_own(root, root)
	return root


static func _copied(stage: Stage, bodies: bool) -> Node3D:
	var root := Node3D.new()
	root.name = "Scene" if stage.scene_name.is_empty() else stage.scene_name.validate_node_name()
	for child in stage.get_children():
		var thing := child as Thing
		var kind := 0 if thing == null else thing.kind
		var copy := _node(child, bodies)
		if copy == null:
			continue
		if thing is Agent:
			copy.name = (thing as Agent).agent_name.validate_node_name()
		elif thing != null:
			copy.name = "%s %d" % [thing.kind_name(), thing.id]
		else:
			copy.name = "Ground"
		_group(root, GROUPS.get(kind, "Ground")).add_child(copy, true)
	return root


static func _group(root: Node3D, title: String) -> Node3D:
	if not root.has_node(title):
		var group := Node3D.new()
		group.name = title
		root.add_child(group)
	return root.get_node(title)


## A copy of a node and of what is below it, or null where nothing of it is left.
static func _node(node: Node, bodies: bool) -> Node:
	var copy := _bare(node, bodies)
	for child in node.get_children():
		var below := _node(child, bodies)
		if below != null:
			if copy == null:
				copy = Node3D.new()
			copy.add_child(below, true)
	if copy is Node3D and node is Node3D:
		(copy as Node3D).transform = (node as Node3D).transform
	return copy


## The node itself: null where it is only there to hold others.
static func _bare(node: Node, bodies: bool) -> Node:
	var drawn := node as VisualInstance3D
	if drawn != null:
		# Painted shade is for Godot: other programs do not know its texture.
		var is_real := bodies or not drawn.has_meta(Looks.UNLABELED)
		return _duplicate(node) if is_real and drawn.layers & SEEN and drawn.visible else null
	if node is WorldEnvironment:
		return _duplicate(node) if bodies else null
	if bodies and (node is StaticBody3D or node is CollisionShape3D):
		# Bodies that move on their own would fall or roll; the others stand.
		return _duplicate(node) if _stands(node) else null
	return null


static func _stands(node: Node) -> bool:
	return node is StaticBody3D or node.get_parent() is StaticBody3D


static func _duplicate(node: Node) -> Node:
	var copy: Node = ClassDB.instantiate(node.get_class())
	for property in node.get_property_list():
		var name: StringName = property["name"]
		var usage: int = property["usage"]
		if usage & PROPERTY_USAGE_STORAGE and not usage & PROPERTY_USAGE_SCRIPT_VARIABLE:
			if not name in OWN:
				copy.set(name, node.get(name))
	return copy


static func _own(node: Node, root: Node) -> void:
	for child in node.get_children():
		child.owner = root
		_own(child, root)
