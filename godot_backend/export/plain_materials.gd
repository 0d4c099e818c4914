extends RefCounted
## Materials of an exported scene: those of files become its own, or ones that glTF knows.

const LanePaint := preload("lane_paint.gd")

## By the material or shader that each replaces.
var _replacements: Dictionary = {}


## Shaders become part of the scene: their files stay here.
func bundle(root: Node) -> void:
	for drawn: GeometryInstance3D in root.find_children("*", "GeometryInstance3D", true, false):
		for material in _materials_of(drawn):
			var shaded := material as ShaderMaterial
			if shaded != null and not shaded.shader.resource_path.is_empty():
				_set_material(drawn, material, _with_own_shader(shaded))


## Shaders become plain colors, and the lines that they paint strips.
func simplify(root: Node) -> void:
	for drawn: GeometryInstance3D in root.find_children("*", "GeometryInstance3D", true, false):
		for material in _materials_of(drawn):
			if not material is ShaderMaterial:
				continue
			var shaded := material as ShaderMaterial
			if drawn is MeshInstance3D and LanePaint.is_painted(shaded):
				LanePaint.add(drawn as MeshInstance3D, shaded)
			_set_material(drawn, material, _plain(shaded))


func _with_own_shader(material: ShaderMaterial) -> ShaderMaterial:
	if not _replacements.has(material):
		if not _replacements.has(material.shader):
			_replacements[material.shader] = material.shader.duplicate()
		var copy: ShaderMaterial = material.duplicate()
		copy.shader = _replacements[material.shader]
		_replacements[material] = copy
	return _replacements[material]


func _plain(material: ShaderMaterial) -> StandardMaterial3D:
	if not _replacements.has(material):
		var copy := StandardMaterial3D.new()
		copy.albedo_color = _color(material)
		copy.roughness = 0.9
		_replacements[material] = copy
	return _replacements[material]


## That of the shader's first parameter that is a color.
static func _color(material: ShaderMaterial) -> Color:
	var declared := RegEx.create_from_string(
		"uniform vec3 (\\w+)\\s*:\\s*source_color\\s*=\\s*vec3\\(([^)]*)\\)"
	)
	var found := declared.search(material.shader.code)
	if found == null:
		return Color.GRAY
	var value: Variant = material.get_shader_parameter(found.get_string(1))
	if value is Color:
		return value
	var parts := found.get_string(2).split_floats(",")
	return Color(parts[0], parts[1], parts[2]) if parts.size() == 3 else Color.GRAY


static func _materials_of(drawn: GeometryInstance3D) -> Array[Material]:
	var out: Array[Material] = []
	if drawn.material_override != null:
		out.append(drawn.material_override)
	var mesh := _mesh_of(drawn)
	for surface in 0 if mesh == null else mesh.get_surface_count():
		var material := mesh.surface_get_material(surface)
		if material != null and not material in out:
			out.append(material)
	return out


static func _mesh_of(drawn: GeometryInstance3D) -> Mesh:
	if drawn is MultiMeshInstance3D:
		return (drawn as MultiMeshInstance3D).multimesh.mesh
	return (drawn as MeshInstance3D).mesh if drawn is MeshInstance3D else null


## Meshes are shared with the scene that is exported, which is not to change: they are copied.
func _set_material(drawn: GeometryInstance3D, old: Material, new: Material) -> void:
	if drawn.material_override == old:
		drawn.material_override = new
		return
	var mesh := _mesh_of(drawn)
	if not _replacements.has(mesh):
		var copy: Mesh = mesh.duplicate()
		_replacements[mesh] = copy
		_replacements[copy] = copy
	var own: Mesh = _replacements[mesh]
	for surface in own.get_surface_count():
		if own.surface_get_material(surface) == old:
			own.surface_set_material(surface, new)
	if drawn is MultiMeshInstance3D:
		var many := drawn as MultiMeshInstance3D
		var placed: MultiMesh = many.multimesh.duplicate()
		placed.mesh = own
		placed.buffer = many.multimesh.buffer
		many.multimesh = placed
	else:
		(drawn as MeshInstance3D).mesh = own
