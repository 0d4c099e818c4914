extends MultiMeshInstance3D
## Rain or snow around the camera: drops in a lattice of equal cells, so that it looks the same
## wherever the camera is, and falls with the time of the drive, not of the clock.

const Instances := preload("instances.gd")

const GROUP := "follows_camera"
## Meters: the edge of a cell, and how many cells lie along each axis.
const CELL := 7.0
const CELLS := 3

var _fall := 9.0
var _time := 0.0


## `dense`: 0 to 1.
func assemble(dense: float, is_snow: bool) -> void:
	_fall = 1.1 if is_snow else 9.0
	var random := RandomNumberGenerator.new()
	random.seed = 5
	var places: Array[Transform3D] = []
	for i in int((90.0 if is_snow else 130.0) * clampf(dense, 0.1, 1.0)):
		var at := Vector3(random.randf(), random.randf(), random.randf()) * CELL
		var turned := Basis(Vector3.FORWARD, random.randf_range(-0.12, 0.12))
		for x in CELLS:
			for y in CELLS:
				for z in CELLS:
					places.append(Transform3D(turned, at + Vector3(x, y, z) * CELL))
	multimesh = Instances.make(_flake() if is_snow else _streak(), places)
	cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_to_group(GROUP)


func show_at(time: float) -> void:
	_time = time


## Takes its place around a camera.
func follow(eye: Vector3) -> void:
	var sunk := Vector3.DOWN * fposmod(_fall * _time, CELL)
	var corner := ((eye - Vector3.ONE * 0.5 * CELL * (CELLS - 1)) / CELL).floor() * CELL
	global_position = corner + sunk


func _flake() -> Mesh:
	var mesh := SphereMesh.new()
	mesh.radius = 0.012
	mesh.height = 0.024
	mesh.radial_segments = 5
	mesh.rings = 3
	mesh.material = _look(Color(0.97, 0.98, 1.0, 0.9))
	return mesh


func _streak() -> Mesh:
	var mesh := BoxMesh.new()
	mesh.size = Vector3(0.004, 0.5, 0.004)
	mesh.material = _look(Color(0.8, 0.86, 0.92, 0.3))
	return mesh


func _look(color: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.shading_mode = BaseMaterial3D.SHADING_MODE_UNSHADED
	material.transparency = BaseMaterial3D.TRANSPARENCY_ALPHA
	material.albedo_color = color
	return material
