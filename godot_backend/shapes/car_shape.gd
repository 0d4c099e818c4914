extends RefCounted
## The hull of a passenger car, and the parts that tell a taxi or a police car.

const Solid := preload("solid.gd")
const Paints := preload("paints.gd")
const WheelArch := preload("wheel_arch.gd")

## Lower body from the rear bumper over the deck and the hood to the front bumper: shares of the
## length from the rear, and of the height.
const DECK: Array[Vector2] = [
	Vector2(0.005, 0.3),
	Vector2(0.0, 0.5),
	Vector2(0.02, 0.63),
	Vector2(0.16, 0.66),
	Vector2(0.72, 0.63),
	Vector2(0.93, 0.54),
	Vector2(0.985, 0.46),
	Vector2(1.0, 0.32),
	Vector2(0.99, 0.14),
]
const CABIN: Array[Vector2] = [
	Vector2(0.09, 0.63),
	Vector2(0.21, 0.93),
	Vector2(0.27, 0.98),
	Vector2(0.46, 0.99),
	Vector2(0.55, 0.95),
	Vector2(0.745, 0.62),
]
## Shares of the height: the floor, and how much it rises toward the rear bumper.
const FLOOR := 0.13
const RISE := 0.14


## Driving along +z, centered amid the axles, on wheels of this radius.
static func hull(size: Vector3, wheelbase: float, radius: float, paint: Color) -> Solid:
	var out := Solid.new()
	var body := Paints.body(paint)
	var deck := _scaled(DECK, size)
	var below := WheelArch.underside(size, wheelbase, radius, FLOOR * size.y, RISE * size.y)
	deck.append_array(below)
	out.loft(deck, 0.96 * size.z, size.z * 0.93, body)
	var cabin := _scaled(CABIN, size)
	out.loft(cabin, 0.86 * size.z, 0.66 * size.z, Paints.glass())
	_add_frame(out, cabin, size, body)
	_add_details(out, size)
	return out


## A board on the roof with a light.
static func add_roof_sign(out: Solid, size: Vector3, look: Material) -> void:
	var width := minf(0.45, 0.3 * size.z)
	out.box(Vector3(width, 0.14, 0.16), Vector3(0, size.y + 0.06, -0.14 * size.x), look)


## A bar of lights across the roof.
static func add_light_bar(out: Solid, size: Vector3, at: float) -> void:
	var blue := Paints.lamp(Color(0.08, 0.2, 0.95), 0.8)
	out.box(Vector3(0.5 * size.z, 0.05, 0.24), Vector3(0, size.y + 0.02, at), Paints.trim())
	for side: float in [-0.16, 0.16]:
		out.box(Vector3(0.2 * size.z, 0.11, 0.2), Vector3(side * size.z, size.y + 0.09, at), blue)


static func _scaled(shares: Array[Vector2], size: Vector3) -> PackedVector2Array:
	var out := PackedVector2Array()
	for share in shares:
		out.append(Vector2((share.x - 0.5) * size.x, share.y * size.y))
	return out


## Roof and pillars, a little outside the glass.
static func _add_frame(
	out: Solid, cabin: PackedVector2Array, size: Vector3, body: Material
) -> void:
	var roof := PackedVector2Array([cabin[1], cabin[2], cabin[3], cabin[4]])
	roof = PackedVector2Array(
		[
			roof[0] + Vector2(-0.01, 0.0),
			roof[1] + Vector2(-0.01, 0.025),
			roof[2] + Vector2(0.0, 0.025),
			roof[3] + Vector2(0.02, 0.01),
			roof[3] + Vector2(-0.03, -0.03),
			roof[0] + Vector2(0.05, -0.03),
		]
	)
	out.loft(roof, 0.71 * size.z, 0.66 * size.z, body)
	var middle := lerpf(cabin[0].x, cabin[5].x, 0.47)
	var foot := Vector2(middle, cabin[0].y)
	var head := Vector2(middle - 0.06, cabin[3].y)
	for side: float in [-size.z, size.z]:
		_add_post(out, cabin[0], cabin[1], 0.05, side, body)
		_add_post(out, cabin[5], cabin[4], 0.035, side, body)
		_add_post(out, foot, head, 0.035, side, body)


## A post of the roof, between two corners of the cabin seen from the side.
static func _add_post(
	out: Solid, foot: Vector2, head: Vector2, radius: float, side: float, look: Material
) -> void:
	var below := Vector3(0.425 * side, foot.y, foot.x)
	var above := Vector3(0.345 * side, head.y, head.x)
	out.bar(below, above, radius, look, 5)


static func _add_details(out: Solid, size: Vector3) -> void:
	var trim := Paints.trim()
	var front := 0.5 * size.x
	out.box(
		Vector3(0.5, 0.1, 0.04) * Vector3(size.z, size.y, 1.0),
		Vector3(0, 0.36 * size.y, front - 0.012),
		trim
	)
	for end: float in [-1.0, 1.0]:
		out.box(
			Vector3(0.86 * size.z, 0.1 * size.y, 0.1),
			Vector3(0, (0.19 if end > 0.0 else 0.33) * size.y, end * (front - 0.045)),
			trim
		)
	var plate := Vector3(0.3, 0.08, 0.02)
	out.box(plate, Vector3(0, 0.42 * size.y, -front - 0.002), Paints.white())
	for side: float in [-1.0, 1.0]:
		out.box(
			Vector3(0.14, 0.1, 0.07),
			Vector3(side * 0.5 * size.z, 0.68 * size.y, 0.17 * size.x),
			trim
		)
