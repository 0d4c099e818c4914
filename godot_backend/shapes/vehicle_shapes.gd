extends RefCounted
## The shapes of all vehicles: which hull, wheels and lamps a category has.
##
## Everything that draws a vehicle, moving or parked, begins here. Sizes are length, height and
## width in meters; vehicles drive along +z, centered, on the ground.

const Solid := preload("solid.gd")
const Paints := preload("paints.gd")
const CarShape := preload("car_shape.gd")
const LongShapes := preload("long_shapes.gd")
const CycleShape := preload("cycle_shape.gd")

const NARROW: Array[String] = ["bicycle", "motorcycle", "scooter"]
const RADII := {
	"van": 0.36,
	"ambulance": 0.38,
	"bus": 0.48,
	"truck": 0.48,
	"fire_truck": 0.5,
	"tractor": 0.5,
	"bicycle": 0.35,
	"motorcycle": 0.31,
	"scooter": 0.1,
}
## Meshes kept for the next vehicles that are alike.
const MOST_KEPT := 512
## Meters above the roof for signs and lights.
const ON_ROOF := {"taxi": 0.12, "police_car": 0.13, "ambulance": 0.13, "fire_truck": 0.1}
const HEADLIGHT := Color(1.0, 0.96, 0.86)
const TAIL := Color(0.7, 0.02, 0.02)

static var _kept: Dictionary = {}


static func wheel_radius(category: String, size: Vector3) -> float:
	return minf(RADII.get(category, clampf(0.215 * size.y, 0.2, 0.42)), 0.4 * size.y)


## The body without wheels and lamps. `is_marked`: with an arrow on the roof.
static func hull(
	category: String, size: Vector3, wheelbase: float, paint: Color, is_marked := false
) -> ArrayMesh:
	var make := func() -> ArrayMesh:
		var solid := solid_of(category, size, wheelbase, paint)
		if is_marked and not category in NARROW:
			_add_mark(solid, category, size)
		return solid.mesh()
	var key := "hull %s %s %s %s %s" % [category, size, wheelbase, paint.to_html(), is_marked]
	return _kept_mesh(key, make)


static func solid_of(
	category: String, size: Vector3, wheelbase: float, paint: Color, ridden := true
) -> Solid:
	var radius := wheel_radius(category, size)
	size.y -= ON_ROOF.get(category, 0.0)
	var out: Solid
	match category:
		"van":
			out = LongShapes.van(size, wheelbase, radius, paint)
		"ambulance":
			out = LongShapes.van(size, wheelbase, radius, paint)
			_add_stripe(out, size, Color(0.8, 0.1, 0.05))
			CarShape.add_light_bar(out, size, 0.15 * size.x)
		"bus":
			out = LongShapes.bus(size, wheelbase, radius, paint)
		"truck":
			out = LongShapes.truck(
				size, wheelbase, radius, paint, paint.lerp(Color(0.8, 0.8, 0.8), 0.75)
			)
		"fire_truck":
			out = LongShapes.truck(size, wheelbase, radius, paint, paint)
			_add_stripe(out, size, Color(0.85, 0.85, 0.83))
			CarShape.add_light_bar(out, size * Vector3(1, 0.86, 1), 0.5 * size.x - 1.0)
			out.box(
				Vector3(0.5, 0.15, 0.7 * size.x),
				Vector3(0, size.y + 0.08, -0.12 * size.x),
				Paints.metal()
			)
		"tractor":
			out = _tractor(size, paint)
		"bicycle":
			out = CycleShape.bicycle(size, wheelbase, radius, paint, ridden)
		"motorcycle":
			out = CycleShape.motorcycle(size, wheelbase, radius, paint, ridden)
		"scooter":
			out = CycleShape.scooter(size, wheelbase, radius, paint, ridden)
		_:
			out = CarShape.hull(size, wheelbase, radius, paint)
	if category == "taxi":
		CarShape.add_roof_sign(out, size, Paints.lamp(Color(0.95, 0.8, 0.3), 0.6))
	elif category == "police_car":
		CarShape.add_light_bar(out, size, -0.14 * size.x)
		_add_stripe(out, size, Color(0.08, 0.2, 0.6))
	return out


## Where the lamps are: at the right side, front or rear; the others mirror them.
static func lamp_place(category: String, size: Vector3, front: bool) -> Vector3:
	var end := 0.5 * size.x
	var height := 0.46 if front else 0.55
	var aside := 0.36
	match category:
		"van", "ambulance":
			height = 0.36 if front else 0.4
			aside = 0.4
		"tractor":
			height = 0.42
			aside = 0.14 if front else 0.36
			end *= 0.95 if front else 0.88
		"bus", "truck", "fire_truck":
			height = 0.21 if front else 0.24
			aside = 0.38
		"bicycle", "motorcycle", "scooter":
			height = 0.64 if front else 0.5
			aside = 0.0
			end *= 0.62 if front else 0.48
			if category == "motorcycle":
				end = 0.35 * size.x if front else 0.43 * size.x
	var place := Vector3(-aside * size.z, height * size.y, end if front else -end)
	if size.y < 2.0 and aside > 0.3:
		place.z -= 0.02 * size.x * (1.0 if front else -0.12)
	return place


## Both lamps of an end, as one mesh without a material.
static func lamps(category: String, size: Vector3, front: bool) -> ArrayMesh:
	var make := func() -> ArrayMesh: return _lamps(category, size, front)
	return _kept_mesh("lamps %s %s %s" % [category, size, front], make)


## A tire on its rim, its axle along x.
static func wheel(category: String, radius: float) -> ArrayMesh:
	var make := func() -> ArrayMesh: return _wheel(category in NARROW, category, radius)
	return _kept_mesh("wheel %s %s" % [category, radius], make)


static func _kept_mesh(key: String, make: Callable) -> ArrayMesh:
	if not _kept.has(key):
		if _kept.size() >= MOST_KEPT:
			_kept.clear()
		_kept[key] = make.call()
	return _kept[key]


static func _lamps(category: String, size: Vector3, front: bool) -> ArrayMesh:
	var solid := Solid.new()
	var place := lamp_place(category, size, front)
	var is_narrow := category in NARROW
	var box := Vector3(0.19 * size.z, 0.075 * size.y, 0.07)
	if is_narrow:
		box = Vector3(0.12, 0.1, 0.06)
	elif size.y > 2.0:
		box = Vector3(0.15 * size.z, 0.055 * size.y, 0.07) if front else Vector3(0.13, 0.34, 0.06)
	for side: float in [1.0] if is_narrow else [-1.0, 1.0]:
		solid.box(box, place * Vector3(side, 1, 1), null)
	return solid.mesh()


static func _wheel(is_narrow: bool, category: String, radius: float) -> ArrayMesh:
	var solid := Solid.new()
	var axle := Basis(Vector3.BACK, PI / 2)
	if is_narrow:
		var thick := 0.13 if category == "motorcycle" else 0.05
		solid.ring(radius, thick, Vector3.ZERO, Paints.rubber())
		for spoke in 4:
			var turned := Basis(Vector3.RIGHT, PI / 4 * spoke)
			solid.box(
				Vector3(0.02, 2.0 * radius - thick, 0.025), Vector3.ZERO, Paints.metal(), turned
			)
		return solid.mesh()
	var width := 0.22 if radius < 0.42 else 0.3
	solid.cylinder(Vector2(radius, radius), width, Vector3.ZERO, Paints.rubber(), axle, 22)
	var rim := 0.64 * radius
	solid.cylinder(Vector2(rim, rim), width + 0.012, Vector3.ZERO, Paints.trim(), axle, 16)
	for spoke in 5:
		var turned := Basis(Vector3.RIGHT, TAU / 5 * spoke)
		var at := turned * Vector3(0, 0.5 * rim, 0)
		solid.box(Vector3(width + 0.03, rim, 0.3 * rim), at, Paints.metal(), turned)
	return solid.mesh()


## A parked vehicle, with wheels and lamps and without a rider, as one mesh; it faces +x.
static func parked(category: String, size: Vector3, wheelbase: float, paint: Color) -> ArrayMesh:
	var solid := solid_of(category, size, wheelbase, paint, false)
	var radius := wheel_radius(category, size)
	var narrow := category in NARROW
	var tread := 0.0 if narrow else 0.5 * size.z - 0.125
	for axle: float in [-0.5, 0.5]:
		for side: float in [0.0] if narrow else [-1.0, 1.0]:
			solid.merge(wheel(category, radius), Vector3(side * tread, radius, axle * wheelbase))
	solid.merge(lamps(category, size, true), Vector3.ZERO, Paints.lamp(HEADLIGHT, 0.0))
	solid.merge(lamps(category, size, false), Vector3.ZERO, Paints.lamp(TAIL, 0.0))
	return solid.mesh(Basis(Vector3.UP, PI / 2))


## An arrow that points forward, on a dark disk.
static func _add_mark(out: Solid, category: String, size: Vector3) -> void:
	var height := size.y + 0.02
	var at := -0.13 * size.x if category in ["car", "taxi", "police_car"] else 0.1 * size.x
	var look := Paints.lamp(Color(1.0, 0.95, 0.85), 0.5)
	for side: float in [-1.0, 1.0]:
		var turned := Basis(Vector3.UP, side * 0.7)
		out.box(Vector3(0.16, 0.03, 0.62), Vector3(side * 0.19, height, at), look, turned.inverse())


static func _add_stripe(out: Solid, size: Vector3, color: Color) -> void:
	var height := 0.52 if size.y < 2.0 else 0.45
	var stripe := Vector3(size.z * 1.004, 0.07 * size.y, 0.72 * size.x)
	out.box(stripe, Vector3(0, height * size.y, -0.06 * size.x), Paints.body(color))


static func _tractor(size: Vector3, paint: Color) -> Solid:
	var out := Solid.new()
	var look := Paints.body(paint)
	out.box(
		Vector3(0.4, 0.3, 0.5) * Vector3(size.z, size.y, size.x),
		Vector3(0, 0.38 * size.y, 0.22 * size.x),
		look
	)
	out.box(
		Vector3(0.62, 0.42, 0.36) * Vector3(size.z, size.y, size.x),
		Vector3(0, 0.7 * size.y, -0.2 * size.x),
		Paints.glass()
	)
	out.box(
		Vector3(0.7, 0.06, 0.4) * Vector3(size.z, size.y, size.x),
		Vector3(0, 0.95 * size.y, -0.2 * size.x),
		look
	)
	out.box(
		Vector3(0.9, 0.08, 0.4) * Vector3(size.z, size.y, size.x),
		Vector3(0, 0.46 * size.y, -0.24 * size.x),
		look
	)
	return out
