extends RigidBody3D
## A car on four sprung wheels with tire friction. Its origin is on the ground, amid the axles.
##
## What it weighs, and how it steers, accelerates and grips, the client says.

const Vehicle := preload("vehicle.gd")
const Tires := preload("tires.gd")
const Touch := preload("touch.gd")
const Wheels := preload("wheels.gd")
const VehicleLook := preload("../shapes/vehicle_look.gd")

const GRAVITY := 9.81
const CLEARANCE := 0.2
## Deceleration that is wanted from which on the brake lights shine, m/s^2.
const BRAKE_LIGHTS := 0.7
const GROUND_LAYER := 1
const BODY_LAYER := 2
## Share of the height of the center of mass at which sideways forces tip the body.
const ROLL := 0.3
## What is narrower is held upright, as by a rider.
const NARROW := 1.2

var size := Vector3(4.5, 1.45, 1.8)
var wheelbase := 2.7
var max_steering := 0.61

var _mass_height := 0.42
var _drag := 0.0
var _lag := 0.0
var _rate := 1.2
var _wheels: Wheels
var _touched: Array[Touch] = []
var _looks: VehicleLook
var _headless := DisplayServer.get_name() == "headless"


## Length, height and width in meters; `numbers`: SI units, by the names of the client.
func assemble(dimensions: Vector3, numbers: Callable) -> void:
	size = dimensions
	wheelbase = clampf(numbers.call("wheelbase", 0.6 * size.x), 0.3, size.x)
	max_steering = clampf(numbers.call("max_steering", 0.61), 0.05, 1.5)
	_mass_height = clampf(numbers.call("mass_height", 0.28 * size.y), 0.05, size.y)
	_drag = maxf(numbers.call("drag", 0.0), 0.0)
	_lag = maxf(numbers.call("steering_lag", 0.1), 0.0)
	_rate = maxf(numbers.call("steering_rate", 1.2), 0.01)
	_wheels = Wheels.new(wheelbase, size.z, GROUND_LAYER)
	_wheels.weighs = clampf(numbers.call("mass", 1500.0), 20.0, 60000.0)
	mass = _wheels.weighs
	_wheels.rolling = maxf(numbers.call("rolling", 0.0), 0.0)
	_wheels.power = maxf(numbers.call("power", 66.0), 0.0)
	_wheels.stiffness = Vector2(
		maxf(numbers.call("front_stiffness", 12.0), 0.1),
		maxf(numbers.call("rear_stiffness", 14.0), 0.1)
	)
	_wheels.lift = _mass_height * (1.0 - ROLL if size.z > NARROW else 1.0)
	_wheels.join(self)
	_prepare()
	_add_shape()


## What it looks like; `is_marked`: told apart from all others by an arrow on the roof.
func dress(category: String, paint: Color, is_marked: bool) -> void:
	_looks = VehicleLook.new()
	# What nobody sees need not follow the body; exported files get it at its place in the body.
	_looks.top_level = _headless
	add_child(_looks)
	_looks.assemble(category, size, _wheels.mounts, paint, is_marked)
	if not _headless:
		_wheels.looks = _looks


func set_surfaces(table: PackedVector2Array) -> void:
	_wheels.surfaces = table


## Steering angle wanted, left positive, and acceleration wanted along the car. To be called once in
## each tick, before the physics step.
func command(steer: float, acceleration: float, dt: float) -> void:
	if freeze:
		return
	var wanted := tan(clampf(steer, -max_steering, max_steering))
	_wheels.tangent = Tires.turned(_wheels.tangent, wanted, _rate, _lag, dt)
	var pose := global_transform
	var velocity := linear_velocity
	var spin := angular_velocity
	var forward := pose.basis.z
	var pace := velocity.dot(forward)
	var weighs := _wheels.weighs
	_wheels.force = -forward * weighs * _drag * pace * absf(pace)
	_wheels.torque = Vector3.ZERO
	_wheels.roll(pose, pose * center_of_mass, velocity, spin, acceleration, pace, dt)
	var force := _wheels.force
	var torque := _wheels.torque
	if _wheels.down > 0:
		var slowing := _wheels.rolling + _wheels.soft
		force -= forward * weighs * signf(pace) * minf(slowing, absf(pace) / dt)
	if size.z <= NARROW:
		var pull := 4.0 * GRAVITY * _mass_height * weighs
		torque -= forward * pull * (pose.basis.x.y + 0.5 * spin.dot(forward))
	apply_central_force(force)
	apply_torque(torque)
	if not _headless:
		_looks.roll(pace * dt, atan(_wheels.tangent))
		_looks.brake(acceleration < -BRAKE_LIGHTS)


func steer_angle() -> float:
	return atan(_wheels.tangent)


## Forward speed.
func speed() -> float:
	return linear_velocity.dot(global_basis.z)


## Over the ground: x east, y north.
func ground_velocity() -> Vector2:
	return Vector2(linear_velocity.x, -linear_velocity.z)


func heading() -> float:
	return atan2(-global_basis.z.z, global_basis.z.x)


## Wheels on the ground, as bits.
func wheels_down() -> int:
	return _wheels.down


## Puts the car at a place with a speed, wheels straight; from now on physics moves it.
func place(at: Vector3, toward: float, forward_speed: float) -> void:
	freeze = false
	gravity_scale = 1.0
	_wheels.tangent = 0.0
	_touched.clear()
	var turned := Basis(Vector3.UP, toward + PI / 2)
	global_transform = Transform3D(turned, at)
	linear_velocity = turned.z * forward_speed
	angular_velocity = Vector3.ZERO


## What is not present touches nothing.
func be_present(present: bool) -> void:
	collision_layer = BODY_LAYER if present else 0
	collision_mask = GROUND_LAYER | BODY_LAYER if present else 0


## Goes on as another body, which may be that of a walker.
func go_on(other: PhysicsBody3D) -> void:
	place(other.global_position, other.call("heading"), other.call("speed"))
	be_present(other.collision_layer != 0)
	if not other is Vehicle:
		return
	var car := other as Vehicle
	# Between two physics steps, nodes are still where they were before the last one.
	var now := PhysicsServer3D.body_get_direct_state(car.get_rid())
	global_transform = now.transform
	linear_velocity = now.linear_velocity
	angular_velocity = now.angular_velocity
	gravity_scale = car.gravity_scale
	freeze = car.freeze
	_wheels.tangent = car._wheels.tangent


## Moves it so that it is at a place after the next physics step, unless it is hit.
func carry(at: Vector3, toward: float, dt: float) -> void:
	gravity_scale = 0.0
	if not _headless:
		_looks.roll((at - global_position).dot(global_basis.z), 0.0)
	linear_velocity = (at - global_position) / dt
	angular_velocity = Vector3(0.0, angle_difference(heading(), toward) / dt, 0.0)


## Physics alone moves it again.
func let_go() -> void:
	gravity_scale = 1.0


## Stays where it is, until it is placed again.
func rest() -> void:
	freeze = true


## What it has begun to touch since the last call: bodies with the numbers of their shapes.
func take_touched() -> Array[Touch]:
	var out := _touched
	if not _touched.is_empty():
		_touched = []
	return out


func _prepare() -> void:
	linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	linear_damp = 0.0
	angular_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	angular_damp = 0.0
	center_of_mass_mode = RigidBody3D.CENTER_OF_MASS_MODE_CUSTOM
	center_of_mass = Vector3(0.0, _mass_height, 0.0)
	contact_monitor = true
	max_contacts_reported = 8
	can_sleep = false
	collision_layer = BODY_LAYER
	collision_mask = GROUND_LAYER | BODY_LAYER
	body_shape_entered.connect(_on_touched)


func _on_touched(_rid: RID, other: Node, shape: int, _own: int) -> void:
	_touched.append(Touch.new(other, shape))


func _add_shape() -> void:
	var box := BoxShape3D.new()
	box.size = Vector3(size.z, size.y - CLEARANCE, size.x)
	var collision := CollisionShape3D.new()
	collision.shape = box
	collision.position.y = CLEARANCE + 0.5 * box.size.y
	add_child(collision)
