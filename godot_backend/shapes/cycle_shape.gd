extends RefCounted
## Bicycles, motorcycles and scooters, each with its rider.

const Solid := preload("solid.gd")
const Paints := preload("paints.gd")

## Radius of the tubes of a frame, meters.
const TUBE := 0.026
const CLOTHES := Color(0.16, 0.2, 0.3)


## The frame without its wheels, and the rider in clothes of another color.
static func bicycle(
	size: Vector3, wheelbase: float, radius: float, paint: Color, ridden: bool
) -> Solid:
	var out := Solid.new()
	var look := Paints.body(paint)
	var rear := Vector3(0, radius, -0.5 * wheelbase)
	var front := Vector3(0, radius, 0.5 * wheelbase)
	var pedals := Vector3(0, radius - 0.04, -0.1)
	var saddle := Vector3(0, 0.92, -0.27)
	var head := Vector3(0, 0.86, 0.37 * wheelbase)
	var below_saddle := saddle - Vector3(0, 0.14, -0.03)
	out.bar(rear, pedals, TUBE, look)
	out.bar(rear, saddle - Vector3(0, 0.16, 0), TUBE, look)
	out.bar(pedals, saddle, TUBE, look)
	out.bar(pedals, head, TUBE, look)
	out.bar(below_saddle, head, TUBE, look)
	out.bar(head, front, TUBE, look)
	var grip := Vector3(0, 1.02, head.z - 0.05)
	out.bar(head, grip, 0.02, Paints.metal())
	out.bar(grip - Vector3(0.27, 0, 0), grip + Vector3(0.27, 0, 0), 0.02, Paints.trim())
	out.box(Vector3(0.16, 0.06, 0.26), saddle, Paints.trim())
	if ridden:
		_add_rider(out, saddle, grip, pedals, size.y, paint.lightened(0.25))
	return out


static func motorcycle(
	size: Vector3, wheelbase: float, radius: float, paint: Color, ridden: bool
) -> Solid:
	var out := Solid.new()
	var look := Paints.body(paint)
	var front := Vector3(0, radius, 0.5 * wheelbase)
	out.ball(Vector3(0.17, 0.17, 0.32), Vector3(0, 0.78, 0.14), look, 12)
	out.box(Vector3(0.3, 0.36, 0.46), Vector3(0, 0.46, 0.02), Paints.metal())
	out.box(Vector3(0.26, 0.12, 0.62), Vector3(0, 0.76, -0.42), Paints.trim())
	out.box(Vector3(0.2, 0.12, 0.3), Vector3(0, 0.74, -0.78), look)
	out.bar(Vector3(0, 0.45, -0.1), Vector3(0, radius, -0.5 * wheelbase), 0.06, Paints.trim())
	out.bar(Vector3(0.13, 0.3, 0.1), Vector3(0.15, 0.38, -0.85), 0.05, Paints.metal(), 8)
	for side: float in [-0.09, 0.09]:
		out.bar(
			Vector3(side, 0.0, 0.0) + front,
			Vector3(side, 0.98, 0.33 * wheelbase),
			0.03,
			Paints.metal()
		)
	out.ball(Vector3(0.15, 0.17, 0.16), Vector3(0, 0.92, 0.42 * wheelbase), look, 12)
	out.box(Vector3(0.2, 0.03, 0.42), Vector3(0, 2.0 * radius + 0.05, 0.5 * wheelbase), look)
	var grip := Vector3(0, 1.06, 0.26 * wheelbase)
	out.bar(grip - Vector3(0.34, 0, 0), grip + Vector3(0.34, 0, 0), 0.025, Paints.trim())
	if ridden:
		var foot := Vector3(0, 0.36, -0.08)
		_add_rider(out, Vector3(0, 0.84, -0.3), grip, foot, size.y, CLOTHES)
		out.ball(Vector3(0.145, 0.155, 0.155), _head(Vector3(0, 0.84, -0.3), size.y), look, 12)
	return out


## A kick scooter.
static func scooter(
	size: Vector3, wheelbase: float, radius: float, paint: Color, ridden: bool
) -> Solid:
	var out := Solid.new()
	var look := Paints.body(paint)
	var deck := Vector3(0, radius + 0.03, 0)
	var grip := Vector3(0, 1.05, 0.42 * wheelbase)
	out.box(Vector3(0.16, 0.05, wheelbase), deck, look)
	out.bar(Vector3(0, radius, 0.5 * wheelbase), grip, 0.025, look)
	out.bar(grip - Vector3(0.24, 0, 0), grip + Vector3(0.24, 0, 0), 0.02, Paints.trim())
	if ridden:
		_add_rider(out, Vector3(0, 0.9, -0.15), grip, deck + Vector3(0, 0, -0.1), size.y, CLOTHES)
	return out


static func _head(seat: Vector3, height: float) -> Vector3:
	return Vector3(0, maxf(height - 0.16, seat.y + 0.42), seat.z + 0.22)


static func _add_rider(
	out: Solid, seat: Vector3, grip: Vector3, foot: Vector3, height: float, clothes: Color
) -> void:
	var top := _head(seat, height)
	var shoulder := Vector3(0, top.y - 0.24, top.z - 0.07)
	var shirt := Paints.body(clothes)
	shirt.roughness = 0.9
	var jeans := Paints.body(CLOTHES.darkened(0.3))
	out.bar(seat, shoulder, 0.15, shirt, 10)
	out.ball(Vector3(0.19, 0.1, 0.13), shoulder, shirt)
	out.ball(Vector3(0.1, 0.125, 0.115), top, Paints.skin(), 12)
	out.ball(
		Vector3(0.12, 0.09, 0.15),
		top + Vector3(0, 0.06, -0.01),
		Paints.body(clothes.darkened(0.4)),
		12
	)
	for side: float in [-1.0, 1.0]:
		var away := Vector3(side * 0.19, 0, 0)
		var elbow := shoulder.lerp(grip, 0.5) + Vector3(side * 0.25, -0.06, 0)
		out.bar(shoulder + away, elbow, 0.05, shirt)
		out.bar(elbow, grip + Vector3(side * 0.25, 0.02, 0), 0.04, Paints.skin())
		var step := 0.1 * side
		var sole := foot + Vector3(side * 0.13, step, step)
		var knee := seat.lerp(sole, 0.45) + Vector3(side * 0.03, 0.06, 0.24)
		out.bar(seat + Vector3(side * 0.1, 0, 0), knee, 0.075, jeans)
		out.bar(knee, sole, 0.055, jeans)
		out.box(Vector3(0.1, 0.07, 0.26), sole + Vector3(0, 0, 0.05), Paints.trim())
