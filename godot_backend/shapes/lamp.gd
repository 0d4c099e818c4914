extends Node3D
## A light that shines when it is dark. A renderer takes few lights at once:
## `build/surroundings.gd` chooses those that do.

const GROUP := "lamps"

## Called with whether it is dark, when that changes.
var darkened := Callable()

var _spot: SpotLight3D
var _direction := Vector3.DOWN
var _range := 20.0
var _angle := 60.0
var _energy := 4.0
var _color := Color.WHITE
var _is_dark := false


## Direction, meters, degrees from the axis to the rim, energy and color.
func aim(direction: Vector3, reach: float, angle: float, energy: float, color: Color) -> void:
	_direction = direction
	_range = reach
	_angle = angle
	_energy = energy
	_color = color


func _enter_tree() -> void:
	add_to_group(GROUP)


func be_dark(dark: bool) -> void:
	if dark == _is_dark:
		return
	_is_dark = dark
	if darkened.is_valid():
		darkened.call(dark)


## Lights its surroundings, or not.
func shine(on: bool) -> void:
	if on and _spot == null:
		_spot = SpotLight3D.new()
		_spot.spot_range = _range
		_spot.spot_angle = _angle
		_spot.spot_angle_attenuation = 0.8
		_spot.spot_attenuation = 0.9
		_spot.light_energy = _energy
		_spot.light_color = _color
		_spot.light_specular = 0.3
		var up := Vector3.FORWARD if absf(_direction.normalized().y) > 0.9 else Vector3.UP
		_spot.basis = Basis.looking_at(_direction, up)
		add_child(_spot)
	if _spot != null:
		_spot.visible = on
