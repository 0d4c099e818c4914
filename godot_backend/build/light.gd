extends RefCounted
## The light and the air of a time of day: colors and energies from the height of the sun, cloud and
## visibility.

const SkyShader := preload("shaders/sky.gdshader")

## Radians of the sun's height: night below the first, full day above the second.
const NIGHT := -0.3
const DAY := 0.2
## Meters of visibility below which there is fog.
const FOG := 500.0
## Below this height of the sun the moon shines instead.
const SUNSET := -0.1
## Of the moon, which shines from one place all night.
const MOON := Vector3(0.45, 0.75, 0.5)
const MOONLIGHT := Color(0.74, 0.8, 0.98)
const NIGHT_AMBIENT := Color(0.36, 0.38, 0.45)

## A copy without a file, so that it becomes part of a scene that is exported.
static var _own_shader: Shader

## 0 at night, 1 by day.
var day := 1.0
var elevation := 0.6
var azimuth := -2.2
var cloud := 0.0
var visibility := 20000.0
var snow := 0.0


## Whether lamps shine.
func is_dark() -> bool:
	return elevation < 0.06 or visibility < 150.0


## Whether what it shines on casts shadows that are seen: not under clouds, nor in fog, of which
## light comes from all sides.
func casts_shadows() -> bool:
	return cloud < 0.9 and visibility > FOG


func prepare() -> void:
	day = smoothstep(NIGHT, DAY, elevation)


## Where the sun is, or the moon.
func direction() -> Vector3:
	if elevation < SUNSET:
		return MOON.normalized()
	var above := maxf(elevation, 0.05)
	return Vector3(cos(azimuth) * cos(above), sin(above), -sin(azimuth) * cos(above))


func set_sun(sun: DirectionalLight3D) -> void:
	sun.basis = Basis.looking_at(-direction(), Vector3.UP)
	var warmth := smoothstep(0.02, 0.6, elevation)
	var daylight := Color(1.0, 0.62, 0.36).lerp(Color(1.0, 0.96, 0.9), warmth)
	sun.light_color = MOONLIGHT if elevation < SUNSET else daylight
	var clear := (
		0.3 if elevation < SUNSET else lerpf(0.15, 0.92, smoothstep(SUNSET, DAY, elevation))
	)
	sun.light_energy = clear * lerpf(1.0, 0.22, cloud)
	sun.shadow_enabled = casts_shadows()
	sun.shadow_normal_bias = 3.0
	sun.shadow_blur = 1.0 + 2.0 * cloud
	sun.directional_shadow_mode = DirectionalLight3D.SHADOW_PARALLEL_2_SPLITS
	sun.directional_shadow_max_distance = 160.0
	sun.light_angular_distance = 0.5


func set_air(environment: Environment) -> void:
	var horizon := _horizon()
	environment.background_mode = Environment.BG_SKY
	environment.sky = _sky(horizon)
	environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	var ambient := Color(0.66, 0.72, 0.82).lerp(Color(0.72, 0.73, 0.75), cloud)
	environment.ambient_light_color = NIGHT_AMBIENT.lerp(ambient, day)
	var twilight := 1.0 - absf(2.0 * day - 1.0)
	environment.ambient_light_energy = (
		0.45 * twilight + lerpf(0.9, lerpf(0.6, 0.75, cloud), day) + 0.4 * snow
	)
	environment.tonemap_mode = Environment.TONE_MAPPER_FILMIC
	environment.tonemap_white = 1.8
	environment.glow_enabled = is_dark()
	environment.glow_intensity = 0.5
	environment.glow_bloom = 0.03
	environment.glow_hdr_threshold = 1.0
	environment.fog_enabled = true
	environment.fog_light_color = horizon
	environment.fog_sky_affect = clampf(inverse_lerp(3000.0, 300.0, visibility), 0.0, 1.0)
	# Koschmieder: contrast falls to 2 % at the visibility.
	environment.fog_density = clampf(3.9 / maxf(visibility, 5.0), 0.0001, 0.8)


func _horizon() -> Color:
	var low_sun := 1.0 - smoothstep(0.03, 0.45, elevation)
	var clear := Color(0.62, 0.71, 0.8).lerp(Color(0.86, 0.6, 0.42), low_sun)
	var overcast := Color(0.62, 0.65, 0.68).lerp(Color(0.8, 0.82, 0.84), snow)
	return Color(0.1, 0.125, 0.19).lerp(clear.lerp(overcast, cloud), day)


func _sky(horizon: Color) -> Sky:
	var material := ShaderMaterial.new()
	if _own_shader == null:
		_own_shader = SkyShader.duplicate()
	material.shader = _own_shader
	var zenith := Color(0.16, 0.36, 0.68).lerp(Color(0.46, 0.5, 0.55), cloud)
	var evening := Color(0.2, 0.27, 0.5).lerp(zenith, smoothstep(0.0, 0.4, elevation))
	material.set_shader_parameter("zenith", Color(0.025, 0.035, 0.08).lerp(evening, day))
	material.set_shader_parameter("horizon", horizon)
	material.set_shader_parameter(
		"below", Color(0.02, 0.025, 0.03).lerp(Color(0.24, 0.27, 0.2), day)
	)
	var shine := lerpf(0.05, 1.0, day) * (1.0 - cloud)
	var glow := Color(1.0, 0.6, 0.3).lerp(Color(1.0, 0.93, 0.8), smoothstep(0.05, 0.5, elevation))
	material.set_shader_parameter("glow", glow * shine)
	var lit := Color(0.9, 0.62, 0.5).lerp(Color(0.95, 0.96, 0.97), smoothstep(0.02, 0.4, elevation))
	lit = lit.lerp(Color(0.6, 0.63, 0.66), cloud)
	material.set_shader_parameter("cloud_color", Color(0.05, 0.06, 0.09).lerp(lit, day))
	material.set_shader_parameter("sun_direction", direction())
	material.set_shader_parameter("cover", clampf(0.3 + 0.7 * cloud, 0.0, 1.0))
	material.set_shader_parameter("night", (1.0 - day) * (1.0 - cloud))
	var sky := Sky.new()
	sky.sky_material = material
	sky.radiance_size = Sky.RADIANCE_SIZE_32
	sky.process_mode = Sky.PROCESS_MODE_INCREMENTAL
	return sky
