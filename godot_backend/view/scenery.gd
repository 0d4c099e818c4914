extends Node3D
## Wooded hills around the built area: decoration without collision.

const Worlds := preload("../build/worlds.gd")
const Looks := preload("../build/looks.gd")
const Instances := preload("../build/instances.gd")
const TreeShape := preload("../shapes/tree_shape.gd")

const SPOKES := 128
const RINGS := 24
const REACH := 2600.0
## Classes of the scenery in the labels of cameras.
const GROUND := 1
const PLANTS := 2
const HEIGHT := 110.0
const TREES := 2600
## Trees are grouped by direction and distance; a camera draws only the groups that it sees.
const WEDGES := 16
## Where each group except the first begins, in meters from the built area.
const BANDS: Array[float] = [0.0, 150.0, 500.0]
## Rings of hills with trees, and how many meters into the flat ground the trees begin.
const WOODED := 15
const INSIDE := 100.0
const MEADOW := Color(0.92, 0.97, 0.9)
const FOREST := Color(0.5, 0.62, 0.5)

var _worlds: Worlds
var _extent := 0.0
var _noise := FastNoiseLite.new()
var _corners := PackedVector3Array()


func _init(worlds: Worlds) -> void:
	_worlds = worlds
	_noise.seed = 7
	_noise.frequency = 0.0016
	_noise.fractal_octaves = 3


## Rebuilds the hills if the size of the built area has changed.
func rebuild() -> void:
	var stage := _worlds.stage(0)
	var extent := 0.0 if stage == null else stage.extent
	if is_equal_approx(extent, _extent):
		return
	_extent = extent
	for child in get_children():
		# At once, so that a picture of this frame does not show it.
		child.free()
	if extent > 0.0:
		_add_hills()
		_add_trees()


## Height of the hills: flat in the built area, rising outside.
func _height(place: Vector2) -> float:
	var beyond := maxf(absf(place.x), absf(place.y)) - _extent
	var rise := smoothstep(10.0, 900.0, beyond)
	var swell := 0.5 + 0.9 * _noise.get_noise_2dv(place)
	return rise * HEIGHT * maxf(swell, 0.05) - 0.06


## Density of trees at a place, from 0 to 1.
func _wood(place: Vector2) -> float:
	return smoothstep(-0.15, 0.3, _noise.get_noise_2dv(place * 2.7 + Vector2(900, 400)))


func _add_hills() -> void:
	_corners.clear()
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for ring in RINGS + 1:
		var out := _extent - 5.0 + REACH * pow(float(ring) / RINGS, 1.8)
		for spoke in SPOKES:
			var place := _on_square(TAU * spoke / SPOKES) * out
			_corners.append(Vector3(place.x, _height(place), place.y))
			var far := smoothstep(0.0, 200.0, out - _extent)
			tool.set_color(Color.WHITE.lerp(MEADOW.lerp(FOREST, _wood(place)), far))
			tool.add_vertex(_corners[-1])
	for ring in RINGS:
		for spoke in SPOKES:
			for corner in _cell(ring, spoke):
				tool.add_index(corner)
	tool.generate_normals()
	tool.set_material(Looks.grass())
	var instance := MeshInstance3D.new()
	instance.mesh = tool.commit()
	instance.set_meta("scenery", GROUND)
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(instance)


## The corners of the two triangles between two rings and two spokes.
func _cell(ring: int, spoke: int) -> Array[int]:
	var a := ring * SPOKES + spoke
	var b := ring * SPOKES + (spoke + 1) % SPOKES
	return [a, a + SPOKES, b, b, a + SPOKES, b + SPOKES]


func _add_trees() -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 11
	var groups := {}
	for i in TREES:
		var place := _place_on_hill(random)
		var is_kept := random.randf() < 0.12 + 0.88 * _wood(Vector2(place.x, place.z))
		var tall := random.randf_range(7.0, 14.0)
		var turned := Basis(Vector3.UP, random.randf() * TAU)
		var is_round := random.randf() < 0.4
		if is_kept:
			var size := Vector3(0.5 * tall, tall, 0.5 * tall)
			var key := _group_of(place, is_round)
			if not groups.has(key):
				var none: Array[Transform3D] = []
				groups[key] = none
			groups[key].append(Transform3D(turned.scaled_local(size), place))
	var meshes: Array[ArrayMesh] = [TreeShape.distant(false), TreeShape.distant(true)]
	for key: Vector3i in groups:
		var instance := MultiMeshInstance3D.new()
		instance.multimesh = Instances.make(meshes[key.z], groups[key])
		instance.set_meta("scenery", PLANTS)
		instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
		add_child(instance)


## Direction group, distance group and kind of a tree.
func _group_of(place: Vector3, is_round: bool) -> Vector3i:
	var wedge := floori(WEDGES * (0.5 + atan2(place.z, place.x) / TAU)) % WEDGES
	var beyond := maxf(absf(place.x), absf(place.z)) - _extent
	var band := 0
	for begin in BANDS:
		band += int(beyond >= begin)
	return Vector3i(wedge, band, int(is_round))


## A place on a triangle of the hills, or on the flat ground in front of them.
func _place_on_hill(random: RandomNumberGenerator) -> Vector3:
	var ring := int(pow(random.randf(), 1.3) * (WOODED + 2)) - 2
	var spoke := random.randi() % SPOKES
	var u := random.randf()
	var v := random.randf()
	if ring < 0:
		var out := _on_square(TAU * (spoke + u) / SPOKES) * (_extent - INSIDE * (1.0 - v * v))
		return Vector3(out.x, -0.06, out.y)
	if u + v > 1.0:
		u = 1.0 - u
		v = 1.0 - v
	var cell := (
		_cell(ring, spoke).slice(0, 3) if random.randf() < 0.5 else _cell(ring, spoke).slice(3)
	)
	var foot := _corners[cell[0]]
	return foot + (_corners[cell[1]] - foot) * u + (_corners[cell[2]] - foot) * v


## The point on the edge of the unit square in a direction: the flat ground is a square.
func _on_square(angle: float) -> Vector2:
	var direction := Vector2.from_angle(angle)
	return direction / maxf(absf(direction.x), absf(direction.y))
