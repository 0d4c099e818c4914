extends RefCounted
## The hulls of vans, buses and trucks: long vehicles with an upright front.

const Solid := preload("solid.gd")
const Paints := preload("paints.gd")
const WheelArch := preload("wheel_arch.gd")


## A van: a short sloping hood, glass at the front only.
static func van(size: Vector3, wheelbase: float, radius: float, paint: Color) -> Solid:
	var out := Solid.new()
	var z := 0.5 * size.x
	var front := _outline(
		size, [Vector2(0.0, 0.97), Vector2(0.68, 1.0), Vector2(0.8, 0.93), Vector2(0.89, 0.56)]
	)
	front.append_array([Vector2(0.97 * z, 0.44 * size.y), Vector2(z, 0.12 * size.y)])
	front.append_array(WheelArch.underside(size, wheelbase, radius, 0.11 * size.y))
	out.loft(front, size.z, 0.88 * size.z, Paints.body(paint))
	var shield := PackedVector2Array(
		[
			Vector2(0.63 * z, 0.9 * size.y),
			Vector2(0.79 * z, 0.57 * size.y),
			Vector2(0.77 * z, 0.56 * size.y),
			Vector2(0.59 * z, 0.9 * size.y),
		]
	)
	var slope := Basis(Vector3.RIGHT, atan2(0.18 * z, 0.36 * size.y))
	out.box(
		Vector3(0.8 * size.z, 0.36 * size.y, 0.03),
		Vector3(0, 0.745 * size.y, 0.695 * z),
		Paints.glass(),
		slope.inverse()
	)
	for side: float in [-1.0, 1.0]:
		_add_pane(out, shield, side * 0.46 * size.z, 0.32 * z, size)
	_add_rear_doors(out, size)
	_add_bumpers(out, size)
	return out


## A bus: a box of windows.
static func bus(size: Vector3, wheelbase: float, radius: float, paint: Color) -> Solid:
	var out := Solid.new()
	var z := 0.5 * size.x
	var side_view := _outline(size, [Vector2(0.0, 0.97), Vector2(0.01, 1.0), Vector2(0.975, 1.0)])
	side_view.append_array([Vector2(0.99 * z, 0.93 * size.y), Vector2(z, 0.4 * size.y)])
	side_view.append(Vector2(0.995 * z, 0.11 * size.y))
	side_view.append_array(WheelArch.underside(size, wheelbase, radius, 0.1 * size.y))
	out.loft(side_view, size.z, 0.96 * size.z, Paints.body(paint))
	var glass := Paints.glass()
	var panes := maxi(3, roundi(size.x / 1.7))
	var pitch := 0.9 * size.x / panes
	for i in panes:
		var at := (i + 0.5) * pitch - 0.46 * size.x
		out.box(
			Vector3(1.002 * size.z, 0.34 * size.y, pitch - 0.1),
			Vector3(0, 0.66 * size.y, at),
			glass
		)
	out.box(Vector3(0.88 * size.z, 0.46 * size.y, 0.06), Vector3(0, 0.61 * size.y, z - 0.02), glass)
	out.box(Vector3(0.8 * size.z, 0.26 * size.y, 0.06), Vector3(0, 0.7 * size.y, -z), glass)
	var display := Paints.lamp(Color(0.95, 0.5, 0.05), 0.7)
	out.box(Vector3(0.55 * size.z, 0.05 * size.y, 0.03), Vector3(0, 0.91 * size.y, z), display)
	for at: float in [0.4, 0.02]:
		out.box(
			Vector3(0.03, 0.72 * size.y, 1.2),
			Vector3(-0.487 * size.z, 0.47 * size.y, at * size.x),
			Paints.trim()
		)
	out.box(
		Vector3(0.7 * size.z, 0.05 * size.y, 0.25 * size.x),
		Vector3(0, 1.01 * size.y, -0.1 * size.x),
		Paints.white()
	)
	_add_bumpers(out, size)
	return out


## A truck: a cab before a box.
static func truck(
	size: Vector3, wheelbase: float, radius: float, paint: Color, load: Color
) -> Solid:
	var out := Solid.new()
	var z := 0.5 * size.x
	var cab := minf(2.1, 0.3 * size.x)
	var rear := z - cab
	var high := 0.86 * size.y
	var sill := 0.16 * size.y
	var side_view := PackedVector2Array(
		[
			Vector2(rear, sill),
			Vector2(rear, high),
			Vector2(z - 0.32, high),
			Vector2(z - 0.12, 0.8 * high),
			Vector2(z, 0.5 * high),
			Vector2(z, sill),
		]
	)
	out.loft(side_view, 0.97 * size.z, 0.9 * size.z, Paints.body(paint))
	out.box(
		Vector3(0.82 * size.z, 0.3 * high, 0.05),
		Vector3(0, 0.66 * high, z - 0.055),
		Paints.glass(),
		Basis(Vector3.RIGHT, -0.17)
	)
	for side: float in [-1.0, 1.0]:
		out.box(
			Vector3(0.04, 0.26 * high, 0.42 * cab),
			Vector3(side * 0.463 * size.z, 0.66 * high, z - 0.45 * cab),
			Paints.glass()
		)
		out.box(
			Vector3(0.1, 0.5, 0.16),
			Vector3(side * 0.52 * size.z, 0.66 * high, z - 0.1),
			Paints.trim()
		)
	var back := z - cab - 0.25
	var base := 2.0 * radius + 0.12
	var length := size.x - cab - 0.25
	var middle := back - 0.5 * length
	out.box(
		Vector3(size.z, size.y - base, length),
		Vector3(0, 0.5 * (size.y + base), middle),
		Paints.body(load)
	)
	out.box(Vector3(0.45 * size.z, 0.3, size.x - 0.4), Vector3(0, base - 0.2, 0), Paints.trim())
	for side: float in [-1.0, 1.0]:
		var guard := wheelbase - 2.0 * radius - 0.9
		out.box(
			Vector3(0.06, 0.28, maxf(guard, 0.3)),
			Vector3(side * 0.46 * size.z, base - 0.42, -0.2),
			Paints.metal()
		)
	# What carries the lamps and the plate, from the bumper up to the box.
	var low := 0.14 * size.y
	out.box(
		Vector3(0.94 * size.z, base - low, 0.06),
		Vector3(0, 0.5 * (base + low), -z + 0.06),
		Paints.trim()
	)
	_add_rear_doors(out, size)
	_add_bumpers(out, size)
	return out


static func _outline(size: Vector3, shares: Array) -> PackedVector2Array:
	var z := 0.5 * size.x
	var out := PackedVector2Array([Vector2(-z, 0.12 * size.y)])
	for share: Vector2 in shares:
		out.append(Vector2((2.0 * share.x - 1.0) * z, share.y * size.y))
	return out


static func _add_pane(
	out: Solid, shield: PackedVector2Array, across: float, rear: float, size: Vector3
) -> void:
	var length := shield[1].x - rear - 0.2 * size.y
	out.box(
		Vector3(0.05, 0.27 * size.y, length),
		Vector3(across, 0.72 * size.y, rear + 0.5 * length),
		Paints.glass()
	)


static func _add_rear_doors(out: Solid, size: Vector3) -> void:
	out.box(
		Vector3(0.03, 0.62 * size.y, 0.02), Vector3(0, 0.6 * size.y, -0.5 * size.x), Paints.trim()
	)
	out.box(
		Vector3(0.34, 0.1, 0.03),
		Vector3(0.25 * size.z, 0.24 * size.y, -0.5 * size.x),
		Paints.white()
	)


static func _add_bumpers(out: Solid, size: Vector3) -> void:
	for end: float in [-1.0, 1.0]:
		out.box(
			Vector3(0.96 * size.z, 0.09 * size.y, 0.12),
			Vector3(0, 0.14 * size.y, end * (0.5 * size.x - 0.055)),
			Paints.trim()
		)
