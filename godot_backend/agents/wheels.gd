extends RefCounted
## The four sprung wheels of a vehicle, and what the ground does to them in a tick: it carries,
## drives, brakes and steers.

const Tires := preload("tires.gd")
const VehicleLook := preload("../shapes/vehicle_look.gd")

const GRAVITY := 9.81
## Of the four springs and dampers together, per kilogram: 1.4 Hz, half of the critical damping.
const STIFFNESS := 80.0
const DAMPING := 9.0
## How far the springs give way under the weight at rest.
const SAG := GRAVITY / STIFFNESS
## Rays to the ground begin this far above the origin of the vehicle.
const RAY_TOP := 0.5
## Below this speed for each second of a tick, slips are those at it: stiffer springs would swing.
const SLOW_SHARE := 1.2

## Where rays begin, in the vehicle: front left, front right, rear left, rear right.
var mounts := PackedVector3Array()
## Kilograms that they carry.
var weighs := 1500.0
var rolling := 0.0
## W/kg.
var power := 60.0
## Of front and rear tires.
var stiffness := Vector2(12.0, 14.0)
## How far above the ground forces across the body act.
var lift := 0.0
## Of the angle of the front wheels.
var tangent := 0.0
## Friction and rolling resistance of surfaces by their numbers, as the world has them.
var surfaces := PackedVector2Array([Vector2(0.9, 0.0)])
## What is to follow the springs; null where nobody looks.
var looks: VehicleLook

## Those on the ground, as bits.
var down := 0
## On the center of mass: what else acts there, to which `roll` adds what acts on the wheels.
var force := Vector3.ZERO
var torque := Vector3.ZERO
## What soft ground adds to the rolling resistance, m/s^2.
var soft := 0.0

var _rays: Array[RayCast3D] = []
## The plane that a wheel is on, and directions in it: along and across the body, along and across
## the turned wheels.
var _normal := Vector3.ZERO
var _along := Vector3.ZERO
var _across := Vector3.ZERO
var _steered := Vector3.ZERO
var _aside := Vector3.ZERO
## Of the surface that a wheel is on: friction, rolling resistance that it adds, the share of the
## grip that drive or brakes use there, and the speed below which slips are those at it.
var _friction := 0.9
var _resistance := 0.0
var _used := 0.0
var _slow := 0.0


func _init(length: float, width: float, ground: int) -> void:
	for along: float in [0.5, -0.5]:
		for side: float in [0.5, -0.5]:
			mounts.append(Vector3(side * maxf(width - 0.25, 0.1), RAY_TOP, along * length))
	for mount in mounts:
		var ray := RayCast3D.new()
		ray.enabled = false
		ray.exclude_parent = false
		ray.position = mount
		ray.target_position = Vector3.DOWN * (RAY_TOP + SAG)
		ray.collision_mask = ground
		_rays.append(ray)


## Goes with a body, in which rays to the ground begin.
func join(body: Node3D) -> void:
	for ray in _rays:
		body.add_child(ray)


## Looks where the ground is below a body, and adds to `force` and `torque` what it does to the
## wheels. `center`: of mass; `velocity` and `spin`: of the body; `wanted`: the acceleration along
## it; `pace`: its speed.
func roll(
	pose: Transform3D,
	center: Vector3,
	velocity: Vector3,
	spin: Vector3,
	wanted: float,
	pace: float,
	dt: float
) -> void:
	down = 0
	soft = 0.0
	var collider: Object = null
	_normal = Vector3.ZERO
	for wheel in 4:
		var ray := _rays[wheel]
		ray.force_raycast_update()
		if not ray.is_colliding():
			continue
		var point := ray.get_collision_point()
		var normal := ray.get_collision_normal()
		var height := (pose * mounts[wheel]).distance_to(point) - RAY_TOP
		if looks != null:
			looks.drop(wheel, height)
		var arm := point - center
		var slip := velocity + spin.cross(arm)
		var spring := STIFFNESS * (SAG - height) - DAMPING * slip.dot(normal)
		if spring <= 0.0:
			continue
		down |= 1 << wheel
		# Mostly all wheels are on the same plane of the same surface.
		if normal != _normal:
			_lie_on(normal, pose.basis.z)
		if ray.get_collider() != collider:
			collider = ray.get_collider()
			_stand_on(collider, wanted, pace, dt)
		soft += 0.25 * _resistance
		var along := _steered if wheel < 2 else _along
		var aside := _aside if wheel < 2 else _across
		var load := 0.25 * weighs * spring
		var push := Tires.force(
			slip.dot(along),
			slip.dot(aside),
			_used,
			load,
			_friction,
			(stiffness.x if wheel < 2 else stiffness.y) / (3.0 * _friction),
			_slow
		)
		var acting := normal * load + along * push.x + aside * push.y
		force += acting
		# Only what acts across the body tips it less: wheels that are turned make it dive.
		torque += arm.cross(acting) + (normal * lift).cross(_across * acting.dot(_across))


## Takes the plane that wheels are on. Forces lie in the ground, however the body leans.
func _lie_on(normal: Vector3, forward: Vector3) -> void:
	_normal = normal
	_along = forward.slide(normal).normalized()
	_across = normal.cross(_along)
	_steered = (_along + _across * tangent).normalized()
	_aside = normal.cross(_steered)


## Takes the surface that wheels are on, and which share of its grip drive or brakes use there.
func _stand_on(ground: Object, wanted: float, pace: float, dt: float) -> void:
	var number: int = ground.get_meta(&"surface", 0)
	var surface := surfaces[number if number < surfaces.size() else 0]
	_friction = surface.x
	_resistance = surface.y * GRAVITY
	_used = Tires.demand(wanted, pace, power, _friction * GRAVITY, rolling + _resistance, dt)
	_slow = SLOW_SHARE * stiffness.y * GRAVITY * dt
