extends "thing.gd"
## Sun, sky, fog, rain and snow, and how much grip they leave.

const Looks := preload("looks.gd")
const Light := preload("light.gd")
const Falling := preload("falling.gd")

const CLEAR_DAY := 20000.0
const MOST_EXTENT := 50000.0

## Of the surfaces by their numbers: friction of tires, and rolling resistance in addition to that
## of a hard road, for each newton of weight. The first is a road that says nothing of its surface.
var surfaces := PackedVector2Array([Vector2(0.9, 0.0)])
## How far the ground reaches to each side, where an edit has made the scene larger; else 0.
var extent := 0.0

var _sun := DirectionalLight3D.new()
var _environment := Environment.new()
var _light := Light.new()
var _falling: Falling
var _message := PackedByteArray()


func build(reader: Reader) -> String:
	_message = reader.rest()
	var settings := Reader.new(_message).json()
	if settings.is_empty():
		return "bad world"
	_read_surfaces(settings.get("surfaces"))
	extent = clampf(_number(settings, "extent", 0.0), 0.0, MOST_EXTENT)
	var rain := clampf(_number(settings, "rain", 0.0), 0.0, 1.0)
	var snow := clampf(_number(settings, "snow", 0.0), 0.0, 1.0)
	_light.cloud = clampf(_number(settings, "cloud", rain), 0.0, 1.0)
	_light.elevation = _number(settings, "sun_elevation", 0.6)
	_light.azimuth = _number(settings, "sun_azimuth", -2.2)
	_light.visibility = _number(settings, "visibility", CLEAR_DAY)
	_light.snow = snow
	_light.prepare()
	_light.set_sun(_sun)
	_light.set_air(_environment)
	Looks.set_ground(maxf(rain, clampf(_number(settings, "wet", 0.0), 0.0, 1.0)), snow)
	Looks.set_night(is_dark())
	var world := WorldEnvironment.new()
	world.environment = _environment
	add_child(world)
	add_child(_sun)
	if maxf(rain, snow) > 0.0 and DisplayServer.get_name() != "headless":
		_falling = Falling.new()
		_falling.assemble(maxf(rain, snow), snow > rain)
		add_child(_falling)
	return ""


## Whether lamps shine.
func is_dark() -> bool:
	return _light.is_dark()


## Whether the sun casts shadows, where it does.
func cast_shadows(casts: bool) -> void:
	_sun.shadow_enabled = casts and _light.casts_shadows()


## Rain and snow as they are at a time of the drive.
func show_at(time: float) -> void:
	if _falling != null:
		_falling.show_at(time)


func air() -> Environment:
	return _environment


func content() -> PackedByteArray:
	return _message


func _read_surfaces(table: Variant) -> void:
	var found := PackedVector2Array()
	for row: Variant in table if table is Array else []:
		var pair: Array = row if row is Array and (row as Array).size() == 2 else [0.9, 0.0]
		var numbers := {"friction": pair[0], "rolling": pair[1]}
		var grip := clampf(_number(numbers, "friction", 0.9), 0.001, 5.0)
		found.append(Vector2(grip, clampf(_number(numbers, "rolling", 0.0), 0.0, 1.0)))
	if not found.is_empty():
		surfaces = found


func _number(settings: Dictionary, key: String, usual: float) -> float:
	var value: Variant = settings.get(key, usual)
	return float(value) if (value is float or value is int) and is_finite(value) else usual
