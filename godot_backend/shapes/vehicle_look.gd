extends Node3D
## A vehicle as it is seen: wheels that roll, steer and stay on the ground, and lamps.

const Paints := preload("paints.gd")
const VehicleShapes := preload("vehicle_shapes.gd")
const Lamp := preload("lamp.gd")
const Looks := preload("../build/looks.gd")

## Share of the way down at which headlamps point.
const DIP := 0.17
## Meters that the light comes from above the lamps: else the road, which it meets at a small angle,
## would stay darker than all that stands on it.
const RAISED := 2.0
## Of the light that a vehicle keeps from the ground below it, whatever the sky; height and distance
## in meters at which and to which that is drawn.
const SHADE := 0.6
const SHADE_HEIGHT := 0.015
const SHADE_FAR := 120.0

static var _shade_paint: StandardMaterial3D

var _radius := 0.32
var _hubs: Array[Node3D] = []
var _tires: Array[Node3D] = []
var _is_narrow := false
var _front := MeshInstance3D.new()
var _rear := MeshInstance3D.new()
var _headlight: Lamp
var _is_dark := false
var _is_braking := false


## Length, height and width; wheels stand below `mounts`: front left and right, rear left and right.
func assemble(
	category: String, size: Vector3, mounts: PackedVector3Array, paint: Color, is_marked: bool
) -> void:
	_is_narrow = category in VehicleShapes.NARROW
	_radius = VehicleShapes.wheel_radius(category, size)
	var wheelbase := mounts[0].z - mounts[2].z
	var hull := MeshInstance3D.new()
	hull.mesh = VehicleShapes.hull(category, size, wheelbase, paint, is_marked)
	add_child(hull)
	var wheel := VehicleShapes.wheel(category, _radius)
	for i: int in [0, 2] if _is_narrow else [0, 1, 2, 3]:
		_add_wheel(wheel, Vector3(0.0 if _is_narrow else mounts[i].x, _radius, mounts[i].z))
	_front.mesh = VehicleShapes.lamps(category, size, true)
	_rear.mesh = VehicleShapes.lamps(category, size, false)
	add_child(_front)
	add_child(_rear)
	_add_shade(size)
	_headlight = Lamp.new()
	var place := VehicleShapes.lamp_place(category, size, true) * Vector3(0, 1, 1)
	_headlight.position = place + Vector3(0, RAISED, 0.1)
	_headlight.aim(Vector3(0, -DIP, 1), 48.0, 36.0, 15.0, VehicleShapes.HEADLIGHT)
	_headlight.darkened = _be_dark
	add_child(_headlight)
	_show_lamps()


## The ground below a wheel is `height` meters below where it is at rest.
func drop(wheel: int, height: float) -> void:
	if _is_narrow:
		if wheel % 2 == 0:
			_hubs[wheel / 2].position.y = _radius - height
	else:
		_hubs[wheel].position.y = _radius - height


## Rolls on by some meters, the front wheels turned by an angle to the left.
func roll(meters: float, steering: float) -> void:
	for i in _hubs.size():
		_hubs[i].rotation.y = steering if i < _hubs.size() / 2 else 0.0
		_tires[i].rotate_object_local(Vector3.RIGHT, meters / _radius)


## Brake lights.
func brake(is_braking: bool) -> void:
	if is_braking != _is_braking:
		_is_braking = is_braking
		_show_lamps()


func _be_dark(dark: bool) -> void:
	_is_dark = dark
	_show_lamps()


func _show_lamps() -> void:
	_front.material_override = Paints.lamp(VehicleShapes.HEADLIGHT, 4.0 if _is_dark else 0.0)
	var bright := Color(1.0, 0.08, 0.05) if _is_braking else VehicleShapes.TAIL
	var energy := 2.5 if _is_braking else (1.0 if _is_dark else 0.0)
	_rear.material_override = Paints.lamp(bright, energy)


## What is dark below a vehicle under an overcast sky, too. Cameras that label see through it.
func _add_shade(size: Vector3) -> void:
	var shade := MeshInstance3D.new()
	var plane := PlaneMesh.new()
	plane.size = Vector2(1.15 * size.z, 1.06 * size.x)
	plane.material = _shade()
	shade.mesh = plane
	shade.position.y = SHADE_HEIGHT
	shade.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	shade.visibility_range_end = SHADE_FAR
	shade.set_meta(Looks.UNLABELED, true)
	add_child(shade)


static func _shade() -> StandardMaterial3D:
	if _shade_paint == null:
		var gradient := Gradient.new()
		gradient.offsets = PackedFloat32Array([0.0, 0.55, 1.0])
		gradient.colors = PackedColorArray(
			[Color(0, 0, 0, SHADE), Color(0, 0, 0, 0.8 * SHADE), Color(0, 0, 0, 0)]
		)
		var texture := GradientTexture2D.new()
		texture.gradient = gradient
		texture.fill = GradientTexture2D.FILL_SQUARE
		texture.fill_from = Vector2(0.5, 0.5)
		texture.fill_to = Vector2(1.0, 0.5)
		_shade_paint = StandardMaterial3D.new()
		_shade_paint.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
		_shade_paint.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
		_shade_paint.albedo_texture = texture
	return _shade_paint


func _add_wheel(mesh: ArrayMesh, at: Vector3) -> void:
	var hub := Node3D.new()
	hub.position = at
	add_child(hub)
	_hubs.append(hub)
	var tire := MeshInstance3D.new()
	tire.mesh = mesh
	hub.add_child(tire)
	_tires.append(tire)
