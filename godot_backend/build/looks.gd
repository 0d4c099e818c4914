extends RefCounted
## The materials and meshes that the built things share.

const RoadShader := preload("res://build/shaders/road.gdshader")
const TileShader := preload("res://build/shaders/tile.gdshader")
const GrassShader := preload("res://build/shaders/grass.gdshader")

## Surfaces of a road.
const MARKED := 0
const PLAIN := 1

static var _materials: Dictionary = {}


static func road(surface: int) -> ShaderMaterial:
	var material := _shared("road %d" % surface, RoadShader)
	material.set_shader_parameter("marked", surface == MARKED)
	return material


static func grass() -> ShaderMaterial:
	return _shared("grass", GrassShader)


## The unit square of a tile whose neighbors are `mask`, north at -z.
static func tile(mask: int) -> Mesh:
	var material := _shared("tile %d" % mask, TileShader)
	material.set_shader_parameter("mask", mask)
	var plane := PlaneMesh.new()
	plane.size = Vector2.ONE
	plane.material = material
	return plane


static func plain(color: Color, roughness: float = 0.9) -> StandardMaterial3D:
	var key := "plain %s %s" % [color.to_html(), roughness]
	if not _materials.has(key):
		var material := StandardMaterial3D.new()
		material.albedo_color = color
		material.roughness = roughness
		_materials[key] = material
	return _materials[key]


static func glass() -> StandardMaterial3D:
	var material := plain(Color(0.05, 0.07, 0.09), 0.1)
	material.metallic = 0.4
	return material


## How wet the ground is, from 0 to 1.
static func set_wetness(wetness: float) -> void:
	for name: String in _materials:
		if _materials[name] is ShaderMaterial:
			(_materials[name] as ShaderMaterial).set_shader_parameter("wetness", wetness)


static func _shared(name: String, shader: Shader) -> ShaderMaterial:
	if not _materials.has(name):
		var material := ShaderMaterial.new()
		material.shader = shader
		_materials[name] = material
	return _materials[name]
