extends RefCounted
## The materials and meshes that the built things share.

const RoadShader := preload("shaders/road.gdshader")
const TileShader := preload("shaders/tile.gdshader")
const GrassShader := preload("shaders/grass.gdshader")

## Surfaces of lanes, by number: color, meters between joints or stall lines across (0 for none),
## and whether these are painted.
const MARKED := 0
const PLAIN := 1
const SURFACES: Array[Array] = [
	[Color(0.19, 0.19, 0.2), 0.0, false],
	[Color(0.19, 0.19, 0.2), 0.0, false],
	[Color(0.24, 0.2, 0.19), 0.0, false],
	[Color(0.33, 0.15, 0.13), 0.0, false],
	[Color(0.23, 0.23, 0.24), 5.5, true],
	[Color(0.46, 0.45, 0.43), 1.5, false],
	[Color(0.2, 0.3, 0.12), 0.0, false],
]

static var _materials: Dictionary = {}


## A strip of lanes with the lines along its left and right border.
static func road(surface: int, left: int, right: int) -> ShaderMaterial:
	var material := _shared("road %d %d %d" % [surface, left, right], RoadShader)
	var look: Array = SURFACES[clampi(surface, 0, SURFACES.size() - 1)]
	material.set_shader_parameter("marked", surface == MARKED)
	material.set_shader_parameter("surface", look[0])
	material.set_shader_parameter("joint", look[1])
	material.set_shader_parameter("joint_painted", look[2])
	material.set_shader_parameter("left_line", left)
	material.set_shader_parameter("right_line", right)
	return material


## The upright side of a curb, lit as if it lay flat: it is too low for its own shade to matter.
static func curb() -> StandardMaterial3D:
	var material := plain(Color(0.55, 0.54, 0.51))
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
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
