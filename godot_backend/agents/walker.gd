extends AnimatableBody3D
## Someone on foot: walks as told, until a vehicle strikes. Then the vehicle loses as much momentum
## as the walker gets, who slides to a stop and lies there.

const Walker := preload("walker.gd")
const Touch := preload("touch.gd")
const WalkerLook := preload("../shapes/walker_look.gd")

const HEIGHT := 1.75
const RADIUS := 0.25
const GROUND_LAYER := 1
const VEHICLE_LAYER := 2
const WALKER_LAYER := 4
## Kilograms, of somebody 1.75 m tall; others weigh as much by volume.
const MASS := 75.0
## m/s of a vehicle toward who walks, below which it only touches.
const STRIKING_SPEED := 1.0
## m/s^2: how fast it comes to rest who was struck.
const SLIDING := 6.0
## Steps up to this high are taken.
const STEP := 0.3

var size := Vector3(0.5, HEIGHT, 0.5)
var wheelbase := 0.5

var _speed := 0.0
var _heading := 0.0
var _height := HEIGHT
var _is_struck := false
var _thrown := Vector3.ZERO
var _touched: Array[Touch] = []
var _feeler := Area3D.new()
var _looks: WalkerLook


func assemble(dimensions: Vector3) -> void:
	var height := dimensions.y
	_height = height
	size.y = height
	sync_to_physics = false
	collision_layer = WALKER_LAYER
	collision_mask = 0
	add_child(_capsule(height))
	_feeler.collision_layer = 0
	_feeler.collision_mask = VEHICLE_LAYER
	_feeler.monitorable = false
	_feeler.add_child(_capsule(height))
	_feeler.body_shape_entered.connect(_on_touched)
	add_child(_feeler)


## What it looks like.
func dress(category: String, dimensions: Vector3, paint: Color) -> void:
	_looks = WalkerLook.new()
	# As of vehicles: what nobody sees need not follow the body.
	_looks.top_level = DisplayServer.get_name() == "headless"
	add_child(_looks)
	_looks.assemble(category, dimensions, paint)


## Puts the walker somewhere, on their feet.
func place(at: Vector3, toward: float, forward_speed: float) -> void:
	_is_struck = false
	_touched.clear()
	_put(at, toward, forward_speed)


## What is not present touches nothing.
func be_present(present: bool) -> void:
	collision_layer = WALKER_LAYER if present else 0


func _put(at: Vector3, toward: float, forward_speed: float) -> void:
	_heading = toward
	_speed = forward_speed
	var ground := Vector3(at.x, _ground_below(at), at.z)
	global_transform = Transform3D(Basis(Vector3.UP, toward + PI / 2), ground)


## Goes on as another body, which may be that of a vehicle.
func go_on(other: PhysicsBody3D) -> void:
	place(other.global_position, other.call("heading"), other.call("speed"))
	be_present(other.collision_layer != 0)
	if other is Walker:
		_is_struck = (other as Walker)._is_struck
		_thrown = (other as Walker)._thrown


## Moves it to a place, in the time of one step.
func carry(at: Vector3, toward: float, dt: float) -> void:
	var moved := (at - global_position).slide(Vector3.UP).length()
	_looks.walk(moved)
	_put(at, toward, moved / dt)


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
	if _is_struck:
		_slide(dt)
		return
	_speed = maxf(0.0, _speed + acceleration * dt)
	var toward := _heading + _speed * tan(clampf(steer, -1.2, 1.2)) / wheelbase * dt
	var step := Vector3(cos(toward), 0.0, -sin(toward)) * _speed * dt
	_looks.walk(_speed * dt)
	_put(global_position + step, toward, _speed)


func steer_angle() -> float:
	return 0.0


func speed() -> float:
	return _speed


func heading() -> float:
	return _heading


## Over the ground: x east, y north.
func ground_velocity() -> Vector2:
	if _is_struck:
		return Vector2(_thrown.x, -_thrown.z)
	return Vector2.from_angle(_heading) * _speed


## The vehicles that it has begun to touch since the last call, with the numbers of their shapes.
func take_touched() -> Array[Touch]:
	var out := _touched
	if not _touched.is_empty():
		_touched = []
	return out


func wheels_down() -> int:
	return 15


func set_surfaces(_surfaces: PackedVector2Array) -> void:
	pass


func _on_touched(_rid: RID, other: Node, shape: int, _own: int) -> void:
	if collision_layer == 0:
		return
	_touched.append(Touch.new(other, shape))
	if other is RigidBody3D and not (other as RigidBody3D).freeze:
		_give_way(other as RigidBody3D)


## Both go on with their common velocity.
func _give_way(vehicle: RigidBody3D) -> void:
	var theirs := vehicle.linear_velocity.slide(Vector3.UP)
	var ours := Vector3(cos(_heading), 0.0, -sin(_heading)) * _speed
	var toward := (global_position - vehicle.global_position).slide(Vector3.UP).normalized()
	if (theirs - ours).dot(toward) < STRIKING_SPEED:
		return
	var mass := MASS * pow(_height / HEIGHT, 3.0)
	var common := (mass * ours + vehicle.mass * theirs) / (mass + vehicle.mass)
	vehicle.linear_velocity += common - theirs
	_thrown = common
	_speed = common.length()
	_is_struck = true


func _slide(dt: float) -> void:
	_thrown = _thrown.normalized() * maxf(_thrown.length() - SLIDING * dt, 0.0)
	_put(global_position + _thrown * dt, _heading, _thrown.length())
	transform.basis = transform.basis * Basis(Vector3.RIGHT, -0.5 * PI)


func _capsule(height: float) -> CollisionShape3D:
	var capsule := CapsuleShape3D.new()
	capsule.radius = RADIUS
	capsule.height = height
	var collision := CollisionShape3D.new()
	collision.shape = capsule
	collision.position.y = 0.5 * height
	return collision


## Height of what can be stood on, at a place.
func _ground_below(at: Vector3) -> float:
	if not is_inside_tree():
		return at.y
	var ray := PhysicsRayQueryParameters3D.create(
		Vector3(at.x, at.y + STEP, at.z), Vector3(at.x, at.y - STEP, at.z), GROUND_LAYER
	)
	var hit := get_world_3d().direct_space_state.intersect_ray(ray)
	return at.y if hit.is_empty() else float(hit["position"].y)
