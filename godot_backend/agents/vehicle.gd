extends VehicleBody3D
## A car on four sprung wheels with tire friction. Its origin is on the ground, amid the axles.

const Looks := preload("res://build/looks.gd")

const GRAVITY := 9.81
## Suspension, per kilogram of body: natural frequency 1.4 Hz, well damped.
const STIFFNESS := 80.0
const DAMPING_IN := 5.5
const DAMPING_OUT := 7.0
const REST_LENGTH := 0.16
const TRAVEL := 0.14
const STEER_RATE := 1.2

var size := Vector3(4.5, 1.45, 1.8)
var wheelbase := 2.7
var max_steering := 0.61
var wheel_radius := 0.32
var touching := 0

var _wheels: Array[VehicleWheel3D] = []
var _steer_now := 0.0


## Length, height and width in meters, mass in kilograms; `friction` is that of the tires.
func assemble(dimensions: Vector3, kilograms: float, friction: float, paint: Color) -> void:
	size = dimensions
	mass = kilograms
	wheel_radius = clampf(0.22 * size.y, 0.2, 0.5)
	linear_damp_mode = RigidBody3D.DAMP_MODE_REPLACE
	linear_damp = 0.0
	center_of_mass_mode = RigidBody3D.CENTER_OF_MASS_MODE_CUSTOM
	center_of_mass = Vector3(0.0, 0.28 * size.y, 0.0)
	contact_monitor = true
	max_contacts_reported = 8
	can_sleep = false
	_add_shape()
	_add_look(paint)
	for along: float in [0.5, -0.5]:
		for side: float in [0.5, -0.5]:
			_add_wheel(along * wheelbase, side * (size.z - 0.25), friction)


func set_friction(friction: float) -> void:
	for wheel in _wheels:
		wheel.wheel_friction_slip = friction


## Steering angle wanted, left positive, and acceleration wanted along the car.
func command(steer: float, acceleration: float, dt: float) -> void:
	var wanted := clampf(steer, -max_steering, max_steering)
	_steer_now = move_toward(_steer_now, wanted, STEER_RATE * dt)
	steering = _steer_now
	if acceleration >= 0.0:
		engine_force = acceleration * mass / 2.0
		brake = 0.0
	else:
		# The engine takes a brake as the largest impulse of a step, for each of the four wheels.
		engine_force = 0.0
		brake = -acceleration * mass * dt / 4.0


func steer_angle() -> float:
	return _steer_now


## Forward speed.
func speed() -> float:
	return linear_velocity.dot(global_basis.z)


func heading() -> float:
	return atan2(-global_basis.z.z, global_basis.z.x)


## Wheels on the ground, as bits.
func wheels_down() -> int:
	var bits := 0
	for i in _wheels.size():
		if _wheels[i].is_in_contact():
			bits |= 1 << i
	return bits


## Puts the car at a place with a speed, at rest otherwise.
func place(at: Vector3, toward: float, forward_speed: float) -> void:
	var turned := Basis(Vector3.UP, toward + PI / 2)
	global_transform = Transform3D(turned, at)
	linear_velocity = turned.z * forward_speed
	angular_velocity = Vector3.ZERO


func _add_shape() -> void:
	var box := BoxShape3D.new()
	var clearance := 0.2
	box.size = Vector3(size.z, size.y - clearance, size.x)
	var collision := CollisionShape3D.new()
	collision.shape = box
	collision.position.y = clearance + 0.5 * box.size.y
	add_child(collision)


func _add_wheel(along: float, side: float, friction: float) -> void:
	var wheel := VehicleWheel3D.new()
	var sag := 1.7 * GRAVITY / (4.0 * STIFFNESS)
	wheel.position = Vector3(side, wheel_radius + REST_LENGTH - sag, along)
	wheel.use_as_steering = along > 0.0
	wheel.use_as_traction = along < 0.0
	wheel.wheel_radius = wheel_radius
	wheel.wheel_rest_length = REST_LENGTH
	wheel.wheel_friction_slip = friction
	# What is too narrow to stand on four wheels does not lean at all.
	wheel.wheel_roll_influence = 0.15 if size.z > 1.2 else 0.0
	wheel.suspension_travel = TRAVEL
	wheel.suspension_stiffness = STIFFNESS
	wheel.suspension_max_force = 4.0 * mass * GRAVITY
	wheel.damping_compression = DAMPING_IN
	wheel.damping_relaxation = DAMPING_OUT
	_add_tire(wheel)
	_wheels.append(wheel)
	add_child(wheel)


func _add_tire(wheel: VehicleWheel3D) -> void:
	var tire := CylinderMesh.new()
	tire.top_radius = wheel_radius
	tire.bottom_radius = wheel_radius
	tire.height = 0.22
	tire.radial_segments = 20
	tire.material = Looks.plain(Color(0.03, 0.03, 0.035), 0.8)
	var rim := CylinderMesh.new()
	rim.top_radius = wheel_radius * 0.62
	rim.bottom_radius = wheel_radius * 0.62
	rim.height = 0.24
	rim.radial_segments = 10
	rim.material = Looks.plain(Color(0.6, 0.61, 0.63), 0.3)
	for part: CylinderMesh in [tire, rim]:
		var instance := MeshInstance3D.new()
		instance.mesh = part
		instance.rotation.z = PI / 2
		wheel.add_child(instance)


func _add_look(paint: Color) -> void:
	var body := preload("res://agents/car_body.gd").mesh(size, paint)
	var instance := MeshInstance3D.new()
	instance.mesh = body
	add_child(instance)


func _physics_process(_dt: float) -> void:
	touching = 0
	for other in get_colliding_bodies():
		if (
			other is RigidBody3D
			or other is AnimatableBody3D
			or other.get_parent().has_method("places")
		):
			touching += 1
