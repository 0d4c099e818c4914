extends RefCounted
## What stands along streets, at its usual size: lamps, signs, shelters, fences, cones.

const Looks := preload("../build/looks.gd")
const Solid := preload("solid.gd")
const Paints := preload("paints.gd")

## Length along the road, height and width of what is drawn at this size; others are one meter.
const SIZES := {
	"lamp": Vector3(0.3, 6.0, 0.3),
	"pole": Vector3(0.3, 7.0, 0.3),
	"sign": Vector3(0.1, 2.5, 0.7),
	"traffic_light": Vector3(0.3, 3.2, 0.4),
	"bus_stop": Vector3(4.0, 2.5, 1.5),
	"bench": Vector3(0.6, 0.9, 1.8),
	"guardrail": Vector3(20.0, 0.8, 0.4),
	"fence": Vector3(10.0, 1.2, 0.1),
	"barrier": Vector3(2.0, 1.0, 0.4),
	"cone": Vector3(0.35, 0.75, 0.35),
	"bollard": Vector3(0.2, 1.0, 0.2),
	"hydrant": Vector3(0.4, 0.8, 0.4),
	"bin": Vector3(0.5, 1.0, 0.5),
	"dumpster": Vector3(3.5, 1.6, 1.8),
	"tire": Vector3(0.6, 0.25, 0.6),
}
const GLASS := Color(1.0, 0.82, 0.55)


## Null for a sort that has no shape of its own.
static func solid_of(sort: String, paint: Color) -> Solid:
	var out := Solid.new()
	var look := Looks.plain(paint, 0.6)
	var metal := Paints.metal()
	match sort:
		"lamp":
			_add_lamp(out, look)
		"pole":
			out.cylinder(
				Vector2(0.13, 0.09), 7.0, Vector3(0, 3.5, 0), Looks.plain(Color(0.3, 0.22, 0.15))
			)
			out.box(Vector3(0.1, 0.1, 0.3), Vector3(0, 6.6, 0), Looks.plain(Color(0.3, 0.22, 0.15)))
		"sign":
			_add_sign(out, look)
		"traffic_light":
			_add_traffic_light(out, look)
		"bus_stop":
			_add_shelter(out, look)
		"bench":
			for z: float in [-0.7, 0.7]:
				out.box(Vector3(0.45, 0.42, 0.07), Vector3(0, 0.21, z), metal)
			out.box(Vector3(0.5, 0.06, 1.8), Vector3(0.02, 0.45, 0), look)
			out.box(Vector3(0.06, 0.4, 1.8), Vector3(-0.25, 0.7, 0), look)
		"guardrail":
			for i in 6:
				out.box(Vector3(0.1, 0.75, 0.08), Vector3(-9.5 + 3.8 * i, 0.37, 0), metal)
			out.box(Vector3(20.0, 0.3, 0.06), Vector3(0, 0.6, 0.06), look)
			out.box(Vector3(20.0, 0.06, 0.03), Vector3(0, 0.6, 0.1), metal)
		"fence":
			for i in 6:
				out.box(Vector3(0.1, 1.2, 0.1), Vector3(-4.95 + 1.98 * i, 0.6, 0), look)
			for height: float in [0.35, 0.7, 1.05]:
				out.box(Vector3(10.0, 0.09, 0.04), Vector3(0, height, 0), look)
		"barrier":
			_add_barrier(out, look)
		"cone":
			out.box(Vector3(0.35, 0.04, 0.35), Vector3(0, 0.02, 0), Paints.trim())
			out.cylinder(Vector2(0.14, 0.03), 0.7, Vector3(0, 0.39, 0), look, Basis.IDENTITY, 12)
			out.cylinder(
				Vector2(0.107, 0.083), 0.15, Vector3(0, 0.37, 0), Paints.white(), Basis.IDENTITY, 12
			)
		"bollard":
			out.cylinder(Vector2(0.09, 0.09), 1.0, Vector3(0, 0.5, 0), look, Basis.IDENTITY, 12)
			out.cylinder(
				Vector2(0.094, 0.094), 0.12, Vector3(0, 0.8, 0), Paints.white(), Basis.IDENTITY, 12
			)
		"hydrant":
			out.cylinder(Vector2(0.13, 0.13), 0.62, Vector3(0, 0.31, 0), look, Basis.IDENTITY, 12)
			out.ball(Vector3(0.14, 0.16, 0.14), Vector3(0, 0.63, 0), look)
			out.bar(Vector3(0, 0.42, -0.19), Vector3(0, 0.42, 0.19), 0.07, look, 8)
		"bin":
			out.cylinder(Vector2(0.2, 0.25), 0.9, Vector3(0, 0.45, 0), look, Basis.IDENTITY, 12)
			out.cylinder(
				Vector2(0.26, 0.2), 0.1, Vector3(0, 0.95, 0), Paints.trim(), Basis.IDENTITY, 12
			)
		"dumpster":
			out.box(Vector3(3.5, 1.3, 1.7), Vector3(0, 0.75, 0), look)
			out.box(Vector3(3.6, 0.12, 1.8), Vector3(0, 1.46, 0), Paints.trim())
		"tire":
			out.cylinder(
				Vector2(0.3, 0.3), 0.25, Vector3(0, 0.125, 0), Paints.rubber(), Basis.IDENTITY, 16
			)
			out.cylinder(
				Vector2(0.16, 0.16), 0.255, Vector3(0, 0.125, 0), Paints.trim(), Basis.IDENTITY, 12
			)
		_:
			return null
	return out


static func _add_lamp(out: Solid, look: Material) -> void:
	out.cylinder(Vector2(0.08, 0.05), 5.4, Vector3(0, 2.7, 0), look)
	out.cylinder(Vector2(0.14, 0.09), 0.7, Vector3(0, 0.35, 0), look)
	out.cylinder(Vector2(0.09, 0.14), 0.4, Vector3(0, 5.6, 0), Looks.lantern(), Basis.IDENTITY, 8)
	out.cylinder(Vector2(0.15, 0.03), 0.18, Vector3(0, 5.9, 0), look, Basis.IDENTITY, 8)


## Its face looks at those who come along the road.
static func _add_sign(out: Solid, look: Material) -> void:
	out.cylinder(Vector2(0.035, 0.035), 2.4, Vector3(0, 1.2, 0), Paints.metal())
	var facing := Basis(Vector3.BACK, PI / 2)
	out.cylinder(Vector2(0.35, 0.35), 0.03, Vector3(-0.02, 2.12, 0), Paints.white(), facing, 24)
	out.cylinder(Vector2(0.31, 0.31), 0.034, Vector3(-0.026, 2.12, 0), look, facing, 24)
	out.box(Vector3(0.04, 0.09, 0.36), Vector3(-0.028, 2.12, 0), Paints.white())


static func _add_traffic_light(out: Solid, look: Material) -> void:
	out.cylinder(Vector2(0.07, 0.06), 2.4, Vector3(0, 1.2, 0), look)
	out.box(Vector3(0.22, 0.9, 0.34), Vector3(0, 2.75, 0), look)
	var colors := [Color(0.03, 0.3, 0.12), Color(0.35, 0.24, 0.02), Color(0.9, 0.08, 0.05)]
	for i in 3:
		out.ball(
			Vector3(0.06, 0.11, 0.11),
			Vector3(-0.11, 2.48 + 0.27 * i, 0),
			Looks.plain(colors[i], 0.4)
		)


static func _add_shelter(out: Solid, look: Material) -> void:
	var glass := Looks.clear_glass()
	out.box(Vector3(4.0, 0.1, 1.5), Vector3(0, 2.45, 0), look)
	for x: float in [-1.95, 1.95]:
		out.box(Vector3(0.08, 2.4, 0.08), Vector3(x, 1.2, -0.7), Paints.metal())
		out.box(Vector3(0.04, 1.9, 1.2), Vector3(x, 1.3, -0.1), glass)
	out.box(Vector3(3.8, 1.9, 0.04), Vector3(0, 1.3, -0.7), glass)
	out.box(Vector3(2.4, 0.06, 0.4), Vector3(-0.3, 0.5, -0.45), Looks.plain(Color(0.4, 0.27, 0.16)))


static func _add_barrier(out: Solid, look: Material) -> void:
	for x: float in [-0.8, 0.8]:
		out.box(Vector3(0.07, 0.9, 0.07), Vector3(x, 0.45, 0), Paints.metal())
		out.box(Vector3(0.1, 0.05, 0.4), Vector3(x, 0.03, 0), Paints.trim())
	for i in 8:
		var stripe := look if i % 2 == 0 else Paints.white() as Material
		out.box(Vector3(0.25, 0.3, 0.05), Vector3(-0.875 + 0.25 * i, 0.8, 0), stripe)
