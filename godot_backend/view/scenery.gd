extends Node3D
## Wooded hills around the built area: for the eye alone, nothing touches them.

const Worlds := preload("../build/worlds.gd")
const Looks := preload("../build/looks.gd")
const Props := preload("../build/props.gd")
const Instances := preload("../build/instances.gd")

const SPOKES := 128
const RINGS := 14
const REACH := 2600.0
const HEIGHT := 95.0
const TREES := 700
## What scenery is, for the labels of cameras.
const GROUND := 1
const PLANTS := 2

var _worlds: Worlds
var _extent := 0.0
var _noise := FastNoiseLite.new()


func _init(worlds: Worlds) -> void:
	_worlds = worlds
	_noise.seed = 7
	_noise.frequency = 0.0016
	_noise.fractal_octaves = 3


## Makes the hills anew where the built area has another size.
func rebuild() -> void:
	var stage := _worlds.stage(0)
	var extent := 0.0 if stage == null else stage.extent
	if is_equal_approx(extent, _extent):
		return
	_extent = extent
	for child in get_children():
		child.queue_free()
	if extent > 0.0:
		_add_hills()
		_add_trees()


## Height of the hills: flat where anything is built, rising beyond.
func _height(place: Vector2) -> float:
	var beyond := maxf(absf(place.x), absf(place.y)) - _extent
	var rise := smoothstep(20.0, 900.0, beyond)
	var swell := 0.5 + 0.9 * _noise.get_noise_2dv(place)
	return rise * HEIGHT * maxf(swell, 0.02) - 0.06


func _add_hills() -> void:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for ring in RINGS + 1:
		var out := _extent - 5.0 + REACH * pow(float(ring) / RINGS, 1.6)
		for spoke in SPOKES:
			var place := _on_square(TAU * spoke / SPOKES) * out
			tool.add_vertex(Vector3(place.x, _height(place), place.y))
	for ring in RINGS:
		for spoke in SPOKES:
			var a := ring * SPOKES + spoke
			var b := ring * SPOKES + (spoke + 1) % SPOKES
			for corner: int in [a, a + SPOKES, b, b, a + SPOKES, b + SPOKES]:
				tool.add_index(corner)
	tool.generate_normals()
	tool.set_material(Looks.grass())
	var instance := MeshInstance3D.new()
	instance.mesh = tool.commit()
	instance.set_meta("scenery", GROUND)
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(instance)


func _add_trees() -> void:
	var random := RandomNumberGenerator.new()
	random.seed = 11
	var places: Array[Transform3D] = []
	for i in TREES:
		var out := _extent + 30.0 + 900.0 * pow(random.randf(), 1.5)
		var place := _on_square(random.randf() * TAU) * out
		var tall := random.randf_range(7.0, 13.0)
		var turned := Basis(Vector3.UP, random.randf() * TAU)
		var size := Vector3(0.5 * tall, tall, 0.5 * tall)
		places.append(
			Transform3D(turned.scaled_local(size), Vector3(place.x, _height(place), place.y))
		)
	var instance := MultiMeshInstance3D.new()
	instance.multimesh = Instances.make(Props.mesh("tree", ""), places)
	instance.set_meta("scenery", PLANTS)
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(instance)


## The point of the unit square's rim in a direction: the flat ground is a square.
func _on_square(angle: float) -> Vector2:
	var direction := Vector2.from_angle(angle)
	return direction / maxf(absf(direction.x), absf(direction.y))
