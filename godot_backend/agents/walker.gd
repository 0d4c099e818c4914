extends AnimatableBody3D
## Someone on foot: moves as told, pushed by nothing.

const Looks := preload("res://build/looks.gd")

const HEIGHT := 1.75
const RADIUS := 0.25
const GROUND_LAYER := 1
const BODY_LAYER := 2
## Steps up to this high are taken.
const STEP := 0.3

var size := Vector3(0.5, HEIGHT, 0.5)
var wheelbase := 0.5

var _speed := 0.0
var _heading := 0.0
var _height := HEIGHT


func assemble(height: float, clothes: Color) -> void:
	_height = height
	size.y = height
	sync_to_physics = false
	collision_layer = BODY_LAYER
	var capsule := CapsuleShape3D.new()
	capsule.radius = RADIUS
	capsule.height = height
	var collision := CollisionShape3D.new()
	collision.shape = capsule
	collision.position.y = 0.5 * height
	add_child(collision)
	_add_look(clothes)


func place(at: Vector3, toward: float, forward_speed: float) -> void:
	_heading = toward
	_speed = forward_speed
	var ground := Vector3(at.x, _ground_below(at), at.z)
	global_transform = Transform3D(Basis(Vector3.UP, toward + PI / 2), ground)


## Goes on as another body, which may be that of a vehicle.
func go_on(other: PhysicsBody3D) -> void:
	collision_layer = other.collision_layer
	place(other.global_position, other.call("heading"), other.call("speed"))


## Moves it to a place, in the time of one step.
func carry(at: Vector3, toward: float, dt: float) -> void:
	place(at, toward, (at - global_position).slide(Vector3.UP).length() / dt)


func let_go() -> void:
	pass


func rest() -> void:
	pass


## Faces another way, at once.
func turn(toward: float) -> void:
	_heading = toward


## Goes at a speed from now on, at once.
func pace(meters_per_second: float) -> void:
	_speed = meters_per_second


## Walks on for one step.
func command(steer: float, acceleration: float, dt: float) -> void:
	_speed = maxf(0.0, _speed + acceleration * dt)
	var toward := _heading + _speed * tan(clampf(steer, -1.2, 1.2)) / wheelbase * dt
	var step := Vector3(cos(toward), 0.0, -sin(toward)) * _speed * dt
	place(global_position + step, toward, _speed)


func steer_angle() -> float:
	return 0.0


func speed() -> float:
	return _speed


func heading() -> float:
	return _heading


## Over the ground: x east, y north.
func ground_velocity() -> Vector2:
	return Vector2.from_angle(_heading) * _speed


## Nobody on foot feels a touch: what they touch does.
func take_touched() -> Array[Array]:
	return []


func wheels_down() -> int:
	return 15


func set_friction(_friction: float) -> void:
	pass


## Height of what can be stood on, at a place.
func _ground_below(at: Vector3) -> float:
	if not is_inside_tree():
		return at.y
	var ray := PhysicsRayQueryParameters3D.create(
		Vector3(at.x, at.y + STEP, at.z), Vector3(at.x, at.y - STEP, at.z), GROUND_LAYER
	)
	var hit := get_world_3d().direct_space_state.intersect_ray(ray)
	return at.y if hit.is_empty() else float(hit["position"].y)


func _add_look(clothes: Color) -> void:
	var legs := _cylinder(0.13, 0.46 * _height, Looks.plain(Color(0.12, 0.14, 0.22)))
	legs.position.y = 0.23 * _height
	var trunk := _cylinder(0.2, 0.38 * _height, Looks.plain(clothes))
	trunk.position.y = 0.64 * _height
	var ball := SphereMesh.new()
	ball.radius = 0.12
	ball.height = 0.25
	ball.material = Looks.plain(Color(0.78, 0.6, 0.48))
	var head := MeshInstance3D.new()
	head.mesh = ball
	head.position.y = 0.92 * _height
	add_child(head)


func _cylinder(radius: float, height: float, look: Material) -> MeshInstance3D:
	var cylinder := CylinderMesh.new()
	cylinder.top_radius = radius
	cylinder.bottom_radius = radius * 0.85
	cylinder.height = height
	cylinder.radial_segments = 12
	cylinder.material = look
	var instance := MeshInstance3D.new()
	instance.mesh = cylinder
	add_child(instance)
	return instance
