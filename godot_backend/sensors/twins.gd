extends RefCounted
## Twins of all that is drawn, in the colors of their labels, on a layer that label cameras see.

const Thing := preload("../build/thing.gd")
const Objects := preload("../build/objects.gd")
const Falling := preload("../build/falling.gd")
const Stage := preload("../build/stage.gd")
const Labels := preload("labels.gd")
const Looks := preload("../build/looks.gd")
const LabelShader := preload("labels.gdshader")
const Protocol := preload("../net/protocol.gd")

## Beyond the 20 layers that cameras see unless told otherwise.
const LAYER := 1 << 20
const SCENERY_META := &"scenery"
## The key of all that has no label of its own.
const OTHERS := 0

static var _two_sided: Shader

var _labels: Dictionary = {}
## By label and sides.
var _materials: Dictionary = {}
var _seen: Dictionary = {}


## Makes the twins of what was built since the last call.
func refresh(stage: Stage, scenery: Node) -> void:
	if _seen.get(stage.get_instance_id(), -1) == stage.builds:
		return
	_seen = {stage.get_instance_id(): stage.builds}
	_labels.clear()
	for labels in stage.all(Protocol.LABELS):
		_labels.merge((labels as Labels).labels, true)
	_add_twins(stage, _labels.get(OTHERS, Vector3i.ZERO), null)
	if scenery != null:
		_add_twins(scenery, _labels.get(OTHERS, Vector3i.ZERO), null)


## Class, first number and step of a thing.
func label_of(thing: Thing) -> Vector3i:
	return _label(thing.kind, thing.id)


func _label(kind: int, id: int) -> Vector3i:
	return _labels.get(Stage.key_of(kind, id), _labels.get(OTHERS, Vector3i.ZERO))


func _add_twins(node: Node, label: Vector3i, owner: Thing) -> void:
	if node is Thing:
		owner = node
		label = label_of(owner)
	elif node.has_meta(SCENERY_META):
		var id: int = node.get_meta(SCENERY_META)
		label = _label(Labels.SCENERY, id)
	elif label.z != 0 and owner is Objects and node is RigidBody3D:
		label.y += (owner as Objects).number_of(node, 0)
	for child in node.get_children():
		if not child.has_meta(Looks.UNLABELED) and not child is Falling:
			_add_twins(child, label, owner)
	if node is MeshInstance3D or node is MultiMeshInstance3D:
		_give_twin(node, label)


func _give_twin(original: GeometryInstance3D, label: Vector3i) -> void:
	var twin := _twin_of(original)
	if twin == null:
		twin = _made_twin(original)
		original.add_child(twin)
	var counted := label.z if original is MultiMeshInstance3D else 0
	twin.material_override = _material(label.x, label.y, counted, _shows_both_sides(original))


static func _made_twin(original: GeometryInstance3D) -> GeometryInstance3D:
	var twin: GeometryInstance3D
	if original is MeshInstance3D:
		twin = MeshInstance3D.new()
		twin.mesh = (original as MeshInstance3D).mesh
	else:
		twin = MultiMeshInstance3D.new()
		twin.multimesh = (original as MultiMeshInstance3D).multimesh
	twin.set_meta(Looks.UNLABELED, true)
	twin.layers = LAYER
	twin.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	twin.visibility_range_begin = original.visibility_range_begin
	twin.visibility_range_end = original.visibility_range_end
	return twin


static func _twin_of(original: Node) -> GeometryInstance3D:
	for child in original.get_children():
		if child.has_meta(Looks.UNLABELED):
			return child
	return null


func _material(label: int, first: int, step: int, two_sided: bool) -> ShaderMaterial:
	var key := "%d %d %d %s" % [label, first, step, two_sided]
	if not _materials.has(key):
		var material := ShaderMaterial.new()
		material.shader = _both_sides() if two_sided else LabelShader
		material.set_shader_parameter("label", label)
		material.set_shader_parameter("first", first)
		material.set_shader_parameter("step", step)
		_materials[key] = material
	return _materials[key]


static func _both_sides() -> Shader:
	if _two_sided == null:
		_two_sided = Shader.new()
		_two_sided.code = LabelShader.code.replace("cull_back", "cull_disabled")
	return _two_sided


static func _shows_both_sides(original: GeometryInstance3D) -> bool:
	var material := original.material_override
	if material == null:
		var mesh := _mesh_of(original)
		if mesh != null and mesh.get_surface_count() > 0:
			material = mesh.surface_get_material(0)
	if material is BaseMaterial3D:
		return (material as BaseMaterial3D).cull_mode == BaseMaterial3D.CULL_DISABLED
	if material is ShaderMaterial and (material as ShaderMaterial).shader != null:
		return (material as ShaderMaterial).shader.code.contains("cull_disabled")
	return false


static func _mesh_of(original: GeometryInstance3D) -> Mesh:
	if original is MeshInstance3D:
		return (original as MeshInstance3D).mesh
	var multimesh := (original as MultiMeshInstance3D).multimesh
	return null if multimesh == null else multimesh.mesh
