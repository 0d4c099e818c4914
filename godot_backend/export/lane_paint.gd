extends RefCounted
## The lines that the shader of roads paints, as strips on top of a road.
##
## Kinds of line and their sizes are those of the shader, read from its code.

const Looks := preload("../build/looks.gd")

## Above the road, in meters: nearer, the two would flicker in a viewer.
const ABOVE := 0.01
const CURB_COLOR := Color(0.62, 0.61, 0.58)
const PAINT_COLOR := Color(0.86, 0.86, 0.82)

## Of each station: left and right edge, and meters along the road.
var _left := PackedVector3Array()
var _right := PackedVector3Array()
var _along := PackedFloat32Array()
var _lanes := 1
var _corners := PackedVector3Array()


static func is_painted(material: ShaderMaterial) -> bool:
	return material.get_shader_parameter("left_line") != null


## Adds the strips of one piece of road below it.
static func add(road: MeshInstance3D, material: ShaderMaterial) -> void:
	var painter := new(road.mesh)
	if painter._along.is_empty():
		return
	painter._add_lines(material)
	_add_mesh(road, "Paint", painter.collected(), PAINT_COLOR)
	painter._add_curbs(material)
	_add_mesh(road, "Curb", painter.collected(), CURB_COLOR)


func _init(mesh: Mesh) -> void:
	var arrays := mesh.surface_get_arrays(0)
	var corners: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX]
	var uv: PackedVector2Array = arrays[Mesh.ARRAY_TEX_UV]
	var uv2: PackedVector2Array = arrays[Mesh.ARRAY_TEX_UV2]
	# Only a strip has pairs of corners, across from each other.
	for i in range(0, corners.size() - 1, 2):
		if not is_equal_approx(uv[i].y, uv[i + 1].y) or uv[i].x <= uv[i + 1].x:
			_along.clear()
			return
		_left.append(corners[i])
		_right.append(corners[i + 1])
		_along.append(uv[i].y)
		_lanes = roundi(uv2[i].y)


## The triangles that were added since the last time.
func collected() -> PackedVector3Array:
	var out := _corners
	_corners = PackedVector3Array()
	return out


func _add_lines(material: ShaderMaterial) -> void:
	var size := func(name: String) -> float: return _constant(material.shader, name)
	var width: float = size.call("LINE")
	var dash := Vector2(size.call("DASH"), size.call("DASH_PERIOD"))
	for side: int in [0, 1]:
		var line := _border_line(material, side)
		if line == 0 or line == int(size.call("CURB_LINE")):
			continue
		var is_inside := line >= int(size.call("INSIDE_SOLID"))
		var inset: float = size.call("EDGE_INSET") if is_inside else 0.0
		var is_broken := line == int(size.call("BROKEN")) or line == int(size.call("INSIDE_BROKEN"))
		var is_double := line == int(size.call("DOUBLE")) or line == int(size.call("INSIDE_DOUBLE"))
		var apart: float = size.call("DOUBLE_APART") if is_double else 0.0
		_add_line(side, inset + apart, width, dash if is_broken else Vector2.ZERO)
		if is_double and is_inside:
			_add_line(side, inset - apart, width, Vector2.ZERO)
	if material.get_shader_parameter("marked") == true:
		for lane in range(1, _lanes):
			_add_line(float(lane) / _lanes, 0.0, width, dash)
	var joint: Variant = material.get_shader_parameter("joint")
	if joint is float and joint > 0.0 and material.get_shader_parameter("joint_painted") == true:
		for i in range(ceili(_along[0] / joint), floori(_along[-1] / joint) + 1):
			_add_quads(0.0, 1.0, 0.0, 0.0, i * joint - 0.4 * width, i * joint + 0.4 * width)


func _add_curbs(material: ShaderMaterial) -> void:
	var width := _constant(material.shader, "CURB")
	for side: int in [0, 1]:
		if _border_line(material, side) == int(_constant(material.shader, "CURB_LINE")):
			_add_line(side, 0.5 * width, width, Vector2.ZERO)


static func _border_line(material: ShaderMaterial, side: int) -> int:
	return int(material.get_shader_parameter("left_line" if side == 0 else "right_line"))


## A line at a share of the width from the left (0) to the right edge (1), `away` meters further
## in; broken where `dash` has a length and a period.
func _add_line(share: float, away: float, width: float, dash: Vector2) -> void:
	var middle := away if share < 0.5 else -away
	var left := middle - 0.5 * width
	var right := middle + 0.5 * width
	if dash.x <= 0.0:
		_add_quads(share, share, left, right, _along[0], _along[-1])
		return
	# The shader has the middle of a dash in the middle of a period.
	for i in range(floori(_along[0] / dash.y), floori(_along[-1] / dash.y) + 1):
		var middle_of_dash := (i + 0.5) * dash.y
		_add_quads(
			share, share, left, right, middle_of_dash - 0.5 * dash.x, middle_of_dash + 0.5 * dash.x
		)


## A strip between two lines, each at a share of the width and meters right of that, from one
## place along the road to another.
func _add_quads(
	left_share: float, right_share: float, left: float, right: float, from: float, to: float
) -> void:
	var start := maxf(from, _along[0])
	var end := minf(to, _along[-1])
	for i in _along.size() - 1:
		var near := maxf(start, _along[i])
		var far := minf(end, _along[i + 1])
		if far - near < 1e-4:
			continue
		var a := _place(i, near, left_share, left)
		var b := _place(i, near, right_share, right)
		var c := _place(i, far, left_share, left)
		var d := _place(i, far, right_share, right)
		_corners.append_array([a, c, b, b, c, d])


func _place(station: int, along: float, share: float, aside: float) -> Vector3:
	var t := (along - _along[station]) / (_along[station + 1] - _along[station])
	var left := _left[station].lerp(_left[station + 1], t)
	var right := _right[station].lerp(_right[station + 1], t)
	var across := left.direction_to(right)
	return left.lerp(right, share) + across * aside + Vector3.UP * ABOVE


static func _add_mesh(
	road: MeshInstance3D, title: String, corners: PackedVector3Array, color: Color
) -> void:
	if corners.is_empty():
		return
	var normals := PackedVector3Array()
	normals.resize(corners.size())
	normals.fill(Vector3.UP)
	var arrays := []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = corners
	arrays[Mesh.ARRAY_NORMAL] = normals
	var mesh := ArrayMesh.new()
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)
	mesh.surface_set_material(0, Looks.plain(color, 0.8))
	var strips := MeshInstance3D.new()
	strips.name = title
	strips.mesh = mesh
	road.add_child(strips)


## A number that the shader declares.
static func _constant(shader: Shader, name: String) -> float:
	var declared := RegEx.create_from_string("const (?:float|int) %s = ([0-9.]+);" % name)
	var found := declared.search(shader.code)
	return 0.0 if found == null else float(found.get_string(1))
