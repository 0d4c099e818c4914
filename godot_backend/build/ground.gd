extends StaticBody3D
## Flat ground under everything, just below the roads, so that nothing falls out of the world.

const Looks := preload("looks.gd")

const DEPTH := 0.05
const THICKNESS := 2.0
## Of all scenery, for the labels of cameras, that which is ground.
const SCENERY := 1

var _shape := BoxShape3D.new()
var _mesh := PlaneMesh.new()
var _instance := MeshInstance3D.new()


func _init() -> void:
	var collision := CollisionShape3D.new()
	collision.shape = _shape
	collision.position.y = -DEPTH - THICKNESS * 0.5
	add_child(collision)
	_instance.mesh = _mesh
	_instance.set_meta("scenery", SCENERY)
	_instance.position.y = -DEPTH
	_instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(_instance)
	_mesh.material = Looks.grass()
	cover(500.0)


## Makes the ground reach `extent` meters to each side of the origin.
func cover(extent: float) -> void:
	_shape.size = Vector3(2.0 * extent, THICKNESS, 2.0 * extent)
	_mesh.size = Vector2(2.0 * extent, 2.0 * extent)
