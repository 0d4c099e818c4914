extends StaticBody3D
## Flat ground under everything, just below the roads, so that nothing falls out of the world.

const Looks := preload("looks.gd")

const DEPTH := 0.05
const THICKNESS := 2.0
## Its number in the table of surfaces.
const TURF := 6
## Of all scenery, for the labels of cameras, that which is ground.
const SCENERY := 1
## Meters: a renderer takes few lamps for each mesh, so ground that is lit by lamps is cut up.
const CHUNK := 50.0
const MOST_CHUNKS_ACROSS := 24

var _shape := BoxShape3D.new()
var _meshes := Node3D.new()
var _extent := 500.0
var _is_cut := false


func _init() -> void:
	var collision := CollisionShape3D.new()
	collision.shape = _shape
	collision.position.y = -DEPTH - THICKNESS * 0.5
	add_child(collision)
	set_meta(&"surface", TURF)
	_meshes.position.y = -DEPTH
	add_child(_meshes)
	cover(_extent)


## Makes the ground reach `extent` meters to each side of the origin.
func cover(extent: float) -> void:
	_extent = extent
	_shape.size = Vector3(2.0 * extent, THICKNESS, 2.0 * extent)
	_draw()


## Draws the ground in pieces, for lamps to light.
func cut(is_cut: bool) -> void:
	if is_cut != _is_cut:
		_is_cut = is_cut
		_draw()


func _draw() -> void:
	for mesh in _meshes.get_children():
		_meshes.remove_child(mesh)
		mesh.free()
	var across := ceili(2.0 * _extent / CHUNK) if _is_cut else 1
	if across > MOST_CHUNKS_ACROSS:
		across = 1
	var size := 2.0 * _extent / across
	var plane := PlaneMesh.new()
	plane.size = Vector2(size, size)
	plane.material = Looks.grass()
	for i in across * across:
		var instance := MeshInstance3D.new()
		instance.mesh = plane
		instance.set_meta("scenery", SCENERY)
		instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		var cell := Vector2(i % across + 0.5, i / across + 0.5) * size - Vector2.ONE * _extent
		instance.position = Vector3(cell.x, 0.0, cell.y)
		_meshes.add_child(instance)
