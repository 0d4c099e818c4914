extends "thing.gd"
## Sun, sky, fog and rain, and how much grip they leave.

const Looks := preload("looks.gd")

const CLEAR_DAY := 6000.0
const MOST_EXTENT := 50000.0

## Tire friction on the road.
var friction := 0.9
## How far the ground reaches to each side, where an edit has made the scene larger; else 0.
var extent := 0.0

var _sun := DirectionalLight3D.new()
var _environment := Environment.new()
var _sky := ProceduralSkyMaterial.new()
var _message := PackedByteArray()


func build(reader: Reader) -> String:
	_message = reader.rest()
	var settings := Reader.new(_message).json()
	if settings.is_empty():
		return "bad world"
	friction = clampf(_number(settings, "friction", 0.9), 0.01, 5.0)
	extent = clampf(_number(settings, "extent", 0.0), 0.0, MOST_EXTENT)
	var rain := clampf(_number(settings, "rain", 0.0), 0.0, 1.0)
	var cloud := clampf(_number(settings, "cloud", rain), 0.0, 1.0)
	var elevation := _number(settings, "sun_elevation", 0.6)
	_light(elevation, _number(settings, "sun_azimuth", -2.2), cloud)
	_air(elevation, cloud, _number(settings, "visibility", CLEAR_DAY))
	Looks.set_wetness(maxf(rain, clampf(_number(settings, "wet", 0.0), 0.0, 1.0)))
	var world := WorldEnvironment.new()
	world.environment = _environment
	add_child(world)
	add_child(_sun)
	if rain > 0.0 and DisplayServer.get_name() != "headless":
		add_child(_rainfall(rain))
	return ""


func air() -> Environment:
	return _environment


func content() -> PackedByteArray:
	return _message


func _number(settings: Dictionary, key: String, usual: float) -> float:
	var value: Variant = settings.get(key, usual)
	return float(value) if (value is float or value is int) and is_finite(value) else usual


## The sun at its place in the sky: azimuth counter-clockwise from east, like every heading.
func _light(elevation: float, azimuth: float, cloud: float) -> void:
	var above := maxf(elevation, 0.06)
	var from := Vector3(cos(azimuth) * cos(above), sin(above), -sin(azimuth) * cos(above))
	_sun.basis = Basis.looking_at(-from, Vector3.UP)
	var day := smoothstep(-0.1, 0.25, elevation)
	var warmth := smoothstep(0.05, 0.7, elevation)
	_sun.light_color = Color(1.0, 0.72, 0.5).lerp(Color(1.0, 0.96, 0.9), warmth)
	_sun.light_energy = lerpf(0.06, 1.15, day) * lerpf(1.0, 0.25, cloud)
	_sun.shadow_enabled = cloud < 0.9 and day > 0.05
	_sun.shadow_blur = 1.0 + 2.0 * cloud
	_sun.directional_shadow_mode = DirectionalLight3D.SHADOW_PARALLEL_2_SPLITS
	_sun.directional_shadow_max_distance = 140.0
	_sun.light_angular_distance = 0.5


func _air(elevation: float, cloud: float, visibility: float) -> void:
	var day := smoothstep(-0.1, 0.3, elevation)
	var blue := Color(0.2, 0.4, 0.72).lerp(Color(0.5, 0.54, 0.58), cloud)
	var haze := Color(0.85, 0.62, 0.46).lerp(
		Color(0.58, 0.67, 0.77), smoothstep(0.05, 0.6, elevation)
	)
	haze = haze.lerp(Color(0.6, 0.63, 0.66), cloud)
	_sky.sky_top_color = blue * lerpf(0.06, 1.0, day)
	_sky.sky_horizon_color = haze * lerpf(0.08, 1.0, day)
	_sky.ground_horizon_color = _sky.sky_horizon_color
	_sky.ground_bottom_color = Color(0.25, 0.27, 0.2) * lerpf(0.1, 1.0, day)
	_sky.sun_angle_max = 8.0
	var sky := Sky.new()
	sky.sky_material = _sky
	sky.radiance_size = Sky.RADIANCE_SIZE_64
	_environment.sky = sky
	_environment.background_mode = Environment.BG_SKY
	_environment.ambient_light_source = Environment.AMBIENT_SOURCE_SKY
	_environment.ambient_light_energy = lerpf(0.85, 1.1, cloud)
	_environment.ambient_light_color = Color(0.62, 0.6, 0.56) * lerpf(0.1, 1.0, day)
	_environment.ambient_light_sky_contribution = 0.45
	_environment.tonemap_mode = Environment.TONE_MAPPER_FILMIC
	_environment.tonemap_white = 1.6
	_environment.fog_enabled = true
	_environment.fog_light_color = _sky.sky_horizon_color
	_environment.fog_sky_affect = 0.15 if visibility > 2000.0 else 0.9
	# Koschmieder: contrast falls to 2 % at the visibility.
	_environment.fog_density = clampf(3.9 / maxf(visibility, 5.0), 0.0004, 0.8)


func _rainfall(rain: float) -> CPUParticles3D:
	var drops := CPUParticles3D.new()
	drops.amount = int(lerpf(400.0, 4000.0, rain))
	drops.lifetime = 0.8
	drops.preprocess = 0.8
	drops.emission_shape = CPUParticles3D.EMISSION_SHAPE_BOX
	drops.emission_box_extents = Vector3(18, 1, 18)
	drops.direction = Vector3.DOWN
	drops.spread = 2.0
	drops.initial_velocity_min = 11.0
	drops.initial_velocity_max = 14.0
	drops.local_coords = false
	var streak := BoxMesh.new()
	streak.size = Vector3(0.012, 0.45, 0.012)
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.albedo_color = Color(0.8, 0.85, 0.9, 0.35)
	streak.material = material
	drops.mesh = streak
	drops.add_to_group("follows_camera")
	return drops
