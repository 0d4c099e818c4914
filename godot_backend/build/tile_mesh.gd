extends RefCounted
## The mesh of a cell of a pixel road, one meter wide: asphalt, curbs where no road goes on, and
## dashes along the middle. North is at -z.

const Looks := preload("looks.gd")

## Shares of the width of a cell.
const CURB := 0.06
const LINE := 0.012
const ROUNDING := 0.3
const DASH := [0.12, 0.38]
const ARC_STEPS := 8
## Meters above the asphalt.
const CURB_HEIGHT := 0.08
const PAINT_HEIGHT := 0.004

const CORNER := Vector2(0.5, -0.5)

var _mask := 0
## Around the asphalt, clockwise from the north-east corner; and across the curb from each.
var _inner := PackedVector2Array()
var _outer := PackedVector2Array()
var _faces: Dictionary = {}


## The mesh for neighbors `mask`: north, east, south, west, then the corners clockwise from the
## north-east, each of which is set only between two sides that are. `surface`: the number of what
## it is made of.
static func make(mask: int, surface: int = 0) -> ArrayMesh:
	var tile := new(mask)
	for quarter in 4:
		tile._add_corner(quarter)
	tile._add_asphalt()
	tile._add_curbs()
	if Looks.is_painted(surface):
		for quarter in 4:
			tile._add_lines(quarter)
	return tile._made(surface)


func _init(mask: int) -> void:
	_mask = mask


func _side(quarter: int) -> bool:
	return _mask & (1 << (quarter & 3)) != 0


func _diagonal(quarter: int) -> bool:
	return _mask & (16 << (quarter & 3)) != 0


func _sides() -> int:
	return [0, 1, 2, 3].filter(_side).size()


## The outline around the corner that a side and the next one share, as if it were north-east.
func _add_corner(quarter: int) -> void:
	if _side(quarter) and _side(quarter + 1):
		if _diagonal(quarter):
			_add_pair(quarter, CORNER, CORNER)
			return
		for step in ARC_STEPS + 1:
			var angle := PI / 2 * step / ARC_STEPS
			_add_pair(quarter, CORNER + CURB * Vector2(-cos(angle), sin(angle)), CORNER)
	elif _side(quarter):
		_add_pair(quarter, CORNER + Vector2(-CURB, 0.0), CORNER)
	elif _side(quarter + 1):
		_add_pair(quarter, CORNER + Vector2(0.0, CURB), CORNER)
	else:
		var radius := ROUNDING
		if _side(quarter + 2) and _side(quarter + 3):
			# A bend turns around the corner across; a wide one has more cells to turn in.
			radius = 0.5 if _diagonal(quarter + 2) else 1.0
		var middle := CORNER + radius * Vector2(-1.0, 1.0)
		for step in ARC_STEPS + 1:
			var angle := PI / 2 * step / ARC_STEPS
			var out := Vector2(sin(angle), -cos(angle))
			_add_pair(quarter, middle + (radius - CURB) * out, middle + radius * out)


func _add_pair(quarter: int, inner: Vector2, outer: Vector2) -> void:
	_inner.append(inner.rotated(quarter * PI / 2))
	_outer.append(outer.rotated(quarter * PI / 2))


func _add_asphalt() -> void:
	for i in _inner.size():
		_add_flat("asphalt", 0.0, Vector2.ZERO, _inner[i], _inner[(i + 1) % _inner.size()])


func _add_curbs() -> void:
	for i in _inner.size():
		var next := (i + 1) % _inner.size()
		var a := _inner[i]
		var b := _inner[next]
		_add_flat("curb", CURB_HEIGHT, a, _outer[i], _outer[next])
		_add_flat("curb", CURB_HEIGHT, a, _outer[next], b)
		var is_open := (
			is_zero_approx((_outer[i] - a).cross(b - a))
			and is_zero_approx((_outer[next] - a).cross(b - a))
		)
		if not is_open:
			_add_upright(a, b)


## Half of a tile's middle line, toward one side; of a road two cells wide, along that side.
func _add_lines(quarter: int) -> void:
	var is_wide_there := _diagonal(quarter) and _diagonal(quarter + 3)
	if not _side(quarter):
		return
	if is_wide_there and not _side(quarter + 2) and _side(quarter + 1) and _side(quarter + 3):
		for side: float in [-1.0, 1.0]:
			var from := Vector2(side * DASH[0], -0.5)
			_add_rectangle(quarter, from, Vector2(side * DASH[1], -0.5 + LINE))
	elif _mask >> 4 == 0 and _sides() < 3:
		if _sides() == 2 and _side(quarter + 1):
			_add_arc(quarter)
		elif not (_sides() == 2 and _side(quarter + 3)):
			_add_rectangle(quarter, Vector2(-LINE, -DASH[1]), Vector2(LINE, -DASH[0]))


func _add_rectangle(quarter: int, from: Vector2, to: Vector2) -> void:
	var turned := quarter * PI / 2
	var a := from.rotated(turned)
	var b := Vector2(to.x, from.y).rotated(turned)
	var c := to.rotated(turned)
	var d := Vector2(from.x, to.y).rotated(turned)
	_add_flat("paint", PAINT_HEIGHT, a, b, c)
	_add_flat("paint", PAINT_HEIGHT, a, c, d)


## Two dashes around the corner of two sides.
func _add_arc(quarter: int) -> void:
	for share: float in [0.25, 0.75]:
		var half := (DASH[1] - DASH[0]) / 2 / 0.5
		var points := PackedVector2Array()
		for step in 5:
			var angle := PI / 2 * share + half * (step / 2.0 - 1.0)
			var out := Vector2(-cos(angle), sin(angle))
			for radius: float in [0.5 - LINE, 0.5 + LINE]:
				points.append((CORNER + radius * out).rotated(quarter * PI / 2))
		for i in range(0, 8, 2):
			_add_flat("paint", PAINT_HEIGHT, points[i], points[i + 1], points[i + 2])
			_add_flat("paint", PAINT_HEIGHT, points[i + 1], points[i + 3], points[i + 2])


func _add_flat(part: String, height: float, a: Vector2, b: Vector2, c: Vector2) -> void:
	var twice := (b - a).cross(c - a)
	if is_zero_approx(twice):
		return
	# x runs east and z south: a positive turn is clockwise seen from above, as Godot wants it.
	for corner: Vector2 in [a, b, c] if twice > 0.0 else [a, c, b]:
		_corners(part).append(Vector3(corner.x, height, corner.y))


## The face of the curb toward the asphalt.
func _add_upright(a: Vector2, b: Vector2) -> void:
	var foot_a := Vector3(a.x, 0.0, a.y)
	var foot_b := Vector3(b.x, 0.0, b.y)
	var up := Vector3(0.0, CURB_HEIGHT, 0.0)
	for corner: Vector3 in [foot_a, foot_b, foot_b + up, foot_a, foot_b + up, foot_a + up]:
		_corners("curb").append(corner)


func _corners(part: String) -> Array:
	return _faces.get_or_add(part, [])


func _made(surface: int) -> ArrayMesh:
	var mesh := ArrayMesh.new()
	var looks := {
		"asphalt": Looks.road(Looks.PLAIN, 0, 0, surface),
		"curb": Looks.curb(),
		"paint": Looks.plain(Color(0.86, 0.86, 0.82), 0.8),
	}
	for part: String in looks:
		var corners := PackedVector3Array(_corners(part))
		if corners.is_empty():
			continue
		var normals := PackedVector3Array()
		normals.resize(corners.size())
		normals.fill(Vector3.UP)
		var uv := PackedVector2Array()
		uv.resize(corners.size())
		var arrays := []
		arrays.resize(Mesh.ARRAY_MAX)
		arrays[Mesh.ARRAY_VERTEX] = corners
		arrays[Mesh.ARRAY_NORMAL] = normals
		arrays[Mesh.ARRAY_TEX_UV] = uv
		arrays[Mesh.ARRAY_TEX_UV2] = uv
		mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
		mesh.surface_set_material(mesh.get_surface_count() - 1, looks[part])
	return mesh
