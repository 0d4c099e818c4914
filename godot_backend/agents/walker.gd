extends AnimatableBody3D
## Someone on foot: moves as told, pushed by nothing.

const Looks := preload("res://build/looks.gd")

const HEIGHT := 1.75
const RADIUS := 0.25

var touching := 0
var size := Vector3(0.5, HEIGHT, 0.5)
var wheelbase := 0.5

var _speed := 0.0
var _heading := 0.0
var _height := HEIGHT


func assemble(height: float, clothes: Color) -> void:
	_height = height
	size.y = height
	sync_to_physics = false
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
	global_transform = Transform3D(Basis(Vector3.UP, toward + PI / 2), at)


## Walks on for one step at a speed, in a direction.
func walk(toward: float, meters_per_second: float, dt: float) -> void:
	var at := global_position
	at += Vector3(cos(toward), 0.0, -sin(toward)) * meters_per_second * dt
	place(at, toward, meters_per_second)


func command(steer: float, acceleration: float, dt: float) -> void:
	_speed = maxf(0.0, _speed + acceleration * dt)
	walk(_heading + _speed * tan(clampf(steer, -1.2, 1.2)) / wheelbase * dt, _speed, dt)


func steer_angle() -> float:
	return 0.0


func speed() -> float:
	return _speed


func heading() -> float:
	return _heading


func wheels_down() -> int:
	return 15


func set_friction(_friction: float) -> void:
	pass


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
