extends RefCounted
## The materials and meshes that the built things share.

const RoadShader := preload("shaders/road.gdshader")
const GrassShader := preload("shaders/grass.gdshader")

## Surfaces of lanes, by number: color, meters between joints or stall lines across (0 for none),
## and whether these are painted.
const MARKED := 0
const PLAIN := 1
## The line of a border that is a curb (`shaders/road.gdshader`).
const CURB_LINE := 4
const SURFACES: Array[Array] = [
	[Color(0.25, 0.25, 0.26), 0.0, false],
	[Color(0.25, 0.25, 0.26), 0.0, false],
	[Color(0.24, 0.2, 0.19), 0.0, false],
	[Color(0.33, 0.15, 0.13), 0.0, false],
	[Color(0.28, 0.28, 0.29), 5.5, true],
	[Color(0.46, 0.45, 0.43), 1.5, false],
	[Color(0.2, 0.3, 0.12), 0.0, false],
]

## What lies on them, by the numbers of the table of the world: its color (transparent: none), how
## wet and how snowy it looks, its grain, and whether paint is seen through it.
const COVERS: Array[Array] = [
	[Color.TRANSPARENT, 0.0, 0.0, 1.0, true],
	[Color.TRANSPARENT, 0.0, 0.0, 1.0, true],
	[Color.TRANSPARENT, 1.0, 0.0, 1.0, true],
	[Color.TRANSPARENT, 0.0, 1.0, 1.0, true],
	[Color(0.66, 0.76, 0.82), 0.6, 0.0, 0.6, false],
	[Color(0.45, 0.4, 0.34), 0.0, 0.0, 3.5, false],
	[Color(0.2, 0.3, 0.12), 0.0, 0.0, 2.0, false],
]

## The mark of meshes that label cameras do not see: twins in label colors, and what is but shade.
const UNLABELED := &"label_twin"

static var _materials: Dictionary = {}
static var _wetness := 0.0
static var _snow := 0.0


## A strip of lanes with the lines along its left and right border. `material_number`: of what it is
## made, in the table of the world.
static func road(surface: int, left: int, right: int, material_number: int = 0) -> ShaderMaterial:
	var cover: Array = _cover(material_number)
	var name := "road %d %d %d" % [surface, left, right]
	if material_number > 0:
		name += " of %d" % material_number
	if not cover[4]:
		left = left if left == CURB_LINE else 0
		right = right if right == CURB_LINE else 0
	var material := _shared(name, RoadShader)
	var look: Array = SURFACES[clampi(surface, 0, SURFACES.size() - 1)]
	var color: Color = cover[0]
	material.set_shader_parameter("marked", surface == MARKED and cover[4])
	material.set_shader_parameter("surface", look[0] if color.a == 0.0 else color)
	material.set_shader_parameter("grain", cover[3])
	material.set_meta("wetness", cover[1])
	material.set_meta("snow", cover[2])
	_set_ground_of(material)
	material.set_shader_parameter("joint", look[1])
	material.set_shader_parameter("joint_painted", look[2])
	material.set_shader_parameter("left_line", left)
	material.set_shader_parameter("right_line", right)
	return material


## Whether paint is seen on a surface of this number.
static func is_painted(material_number: int) -> bool:
	return _cover(material_number)[4]


static func _cover(material_number: int) -> Array:
	return COVERS[material_number if material_number < COVERS.size() else 0]


## The upright side of a curb.
static func curb() -> StandardMaterial3D:
	var material := plain(Color(0.5, 0.49, 0.47))
	material.cull_mode = BaseMaterial3D.CULL_DISABLED
	return material


static func grass() -> ShaderMaterial:
	return _shared("grass", GrassShader)


static func plain(color: Color, roughness: float = 0.9) -> StandardMaterial3D:
	var key := "plain %s %s" % [color.to_html(), roughness]
	if not _materials.has(key):
		var material := StandardMaterial3D.new()
		material.albedo_color = color
		material.roughness = roughness
		_materials[key] = material
	return _materials[key]


## What shines by itself, with this energy.
static func glowing(color: Color, energy: float) -> StandardMaterial3D:
	var key := "glowing %s %s" % [color.to_html(), energy]
	if not _materials.has(key):
		var material := StandardMaterial3D.new()
		material.albedo_color = color
		material.roughness = 0.3
		material.emission_enabled = energy > 0.0
		material.emission = color
		material.emission_energy_multiplier = energy
		_materials[key] = material
	return _materials[key]


static func glass() -> StandardMaterial3D:
	var material := plain(Color(0.05, 0.07, 0.09), 0.1)
	material.metallic = 0.4
	return material


## Windows of houses: some are lit at night.
static func window(is_lit: bool) -> StandardMaterial3D:
	var name := "window lit" if is_lit else "window dark"
	if not _materials.has(name):
		var material := StandardMaterial3D.new()
		material.albedo_color = Color(0.1, 0.13, 0.17)
		material.roughness = 0.15
		material.emission = Color(1.0, 0.74, 0.36)
		material.emission_energy_multiplier = 0.9
		_materials[name] = material
	return _materials[name]


## The glass of street lamps.
static func lantern() -> StandardMaterial3D:
	if not _materials.has("lantern"):
		var material := StandardMaterial3D.new()
		material.albedo_color = Color(0.85, 0.82, 0.72)
		material.emission = Color(1.0, 0.8, 0.5)
		material.emission_energy_multiplier = 3.5
		_materials["lantern"] = material
	return _materials["lantern"]


## Glass to see through.
static func clear_glass() -> StandardMaterial3D:
	var material := plain(Color(0.6, 0.7, 0.75, 0.35), 0.1)
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	return material


## Lights windows and lamps at night.
static func set_night(is_night: bool) -> void:
	window(true).emission_enabled = is_night
	lantern().emission_enabled = is_night


## How wet the ground is, and how much snow lies on it, from 0 to 1.
static func set_ground(wetness: float, snow: float) -> void:
	_wetness = wetness
	_snow = snow
	for name: String in _materials:
		if _materials[name] is ShaderMaterial:
			_set_ground_of(_materials[name])


static func _set_ground_of(material: ShaderMaterial) -> void:
	var wetness: float = material.get_meta("wetness", 0.0)
	var snow: float = material.get_meta("snow", 0.0)
	material.set_shader_parameter("wetness", maxf(_wetness, wetness))
	material.set_shader_parameter("snow", maxf(_snow, snow))


static func _shared(name: String, shader: Shader) -> ShaderMaterial:
	if not _materials.has(name):
		var material := ShaderMaterial.new()
		material.shader = shader
		_set_ground_of(material)
		_materials[name] = material
	return _materials[name]
