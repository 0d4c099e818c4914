extends "thing.gd"
## Things of one sort: drawn as instances of one mesh, solid where asked. They stand still, but for
## those so light that vehicles push them away.

const Protocol := preload("../net/protocol.gd")
const Props := preload("../shapes/props.gd")
const Lamp := preload("../shapes/lamp.gd")
const Instances := preload("instances.gd")

const FIELDS := 7
const MAX_SIZE := 1000.0
const TRUNK_RADIUS := 0.25
## Kilograms of what is pushed away, by sort.
const LIGHT := {"cone": 3.0}
## Of the light of a lamp: meters, degrees from its axis to its rim, energy.
const LAMP_REACH := 30.0
const LAMP_ANGLE := 72.0
const LAMP_ENERGY := 10.0
const LAMP_COLOR := Color(1.0, 0.92, 0.8)
const GROUND_LAYER := 1
const BODY_LAYER := 2

var sort := ""

## Instances that look alike, and which of the things they are.
var _drawn: Array[MultiMesh] = []
var _numbers: Array[PackedInt32Array] = []
## Light things, and where each stands until it is struck.
var _light: Array[RigidBody3D] = []
var _homes: Array[Transform3D] = []


func build(reader: Reader) -> String:
	var solid := reader.u8()
	var count := reader.u16()
	sort = reader.ascii(reader.u8())
	var color := reader.ascii(reader.u8())
	var records := reader.floats(count * FIELDS, Protocol.MAX_COORDINATE)
	if not reader.at_end() or count < 1 or sort.is_empty():
		return "bad objects"
	var places: Array[Transform3D] = []
	for i in count:
		var at := i * FIELDS
		var size := Vector3(records[at + 4], records[at + 5], records[at + 6])
		if minf(size.x, minf(size.y, size.z)) <= 0.0 or size.length() > MAX_SIZE:
			return "an object's size is more than 0 and less than %d m" % MAX_SIZE
		var origin := Vector3(records[at], records[at + 1], records[at + 2])
		places.append(Transform3D(Basis(Vector3.UP, records[at + 3]).scaled_local(size), origin))
	if solid and LIGHT.has(sort):
		for place in places:
			_add_light(place, color)
		return ""
	_add_instances(places, color)
	if solid:
		_add_bodies(places)
	return ""


## Puts back what was pushed away; from now on it can be.
func reset() -> void:
	for i in _light.size():
		_light[i].freeze = false
		_light[i].global_transform = _homes[i]
		_light[i].linear_velocity = Vector3.ZERO
		_light[i].angular_velocity = Vector3.ZERO


## Nothing moves without a drive: else it would depend on the clock how light things stand.
func rest() -> void:
	for body in _light:
		body.freeze = true


## Which of the things a body is, or one of its shapes.
func number_of(body: Node, shape: int) -> int:
	var found := _light.find(body)
	return shape if found < 0 else found


## Those that are pushed away; the others stand still.
func light_bodies() -> Array[RigidBody3D]:
	return _light


## The positions that the instances have.
func content() -> PackedByteArray:
	var positions := PackedVector3Array()
	for place in places():
		positions.append(place.origin)
	return positions.to_byte_array()


func places() -> Array[Transform3D]:
	if not _light.is_empty():
		return _homes
	var out: Array[Transform3D] = []
	for numbers in _numbers:
		out.resize(out.size() + numbers.size())
	for i in _drawn.size():
		var drawn := Instances.places_of(_drawn[i])
		for j in drawn.size():
			out[_numbers[i][j]] = drawn[j]
	return out


## Things of one size and variant are instances of one mesh.
func _add_instances(places_given: Array[Transform3D], color: String) -> void:
	# By size, and variant as the fourth number.
	var groups: Dictionary = {}
	for i in places_given.size():
		var size := Props.drawn_size(sort, places_given[i].basis.get_scale())
		var variant := _variant(places_given[i].origin) if color.is_empty() else 0
		var look := Vector4(size.x, size.y, size.z, variant)
		groups.get_or_add(look, PackedInt32Array()).append(i)
	for look: Vector4 in groups:
		var numbers: PackedInt32Array = groups[look]
		var size := Vector3(look.x, look.y, look.z)
		var scaled: Array[Transform3D] = []
		for number in numbers:
			scaled.append(places_given[number].scaled_local(Vector3.ONE / size))
		var mesh := Props.mesh(sort, color, size, int(look.w))
		_drawn.append(Instances.make(mesh, scaled, numbers))
		_numbers.append(numbers)
		var instance := MultiMeshInstance3D.new()
		instance.multimesh = _drawn[-1]
		add_child(instance)
	if sort == "lamp":
		for place in places_given:
			_add_lamp(place)


## Of the looks that a sort has: by where a thing stands, so that it looks the same in every run.
func _variant(origin: Vector3) -> int:
	var cell := Vector2i(roundi(origin.x), roundi(origin.z))
	return posmod(cell.x * 7919 + cell.y * 104729 + (cell.x * cell.y) % 97, Props.variants(sort))


func _add_lamp(place: Transform3D) -> void:
	var lamp := Lamp.new()
	lamp.position = place.origin + Vector3.UP * (place.basis.get_scale().y - 0.3)
	lamp.aim(Vector3.DOWN, LAMP_REACH, LAMP_ANGLE, LAMP_ENERGY, LAMP_COLOR)
	add_child(lamp)


func _add_light(place: Transform3D, color: String) -> void:
	var size := place.basis.get_scale()
	var body := RigidBody3D.new()
	body.mass = LIGHT[sort]
	body.collision_layer = BODY_LAYER
	body.collision_mask = GROUND_LAYER | BODY_LAYER
	var collision := CollisionShape3D.new()
	collision.shape = _shape(size)
	collision.position.y = size.y * 0.5
	body.add_child(collision)
	var instance := MeshInstance3D.new()
	var drawn := Props.drawn_size(sort, size)
	instance.mesh = Props.mesh(sort, color, drawn, 0)
	instance.scale = size / drawn
	body.add_child(instance)
	body.transform = Transform3D(place.basis.orthonormalized(), place.origin)
	body.freeze = true
	add_child(body)
	_light.append(body)
	_homes.append(body.transform)


func _add_bodies(places_given: Array[Transform3D]) -> void:
	var body := StaticBody3D.new()
	for place in places_given:
		var collision := CollisionShape3D.new()
		var size := place.basis.get_scale()
		collision.shape = _shape(size)
		collision.transform = Transform3D(
			place.basis.orthonormalized(), place.origin + Vector3.UP * size.y * 0.5
		)
		body.add_child(collision)
	add_child(body)


func _shape(size: Vector3) -> Shape3D:
	if sort == "tree":
		var trunk := CylinderShape3D.new()
		trunk.radius = TRUNK_RADIUS
		trunk.height = size.y
		return trunk
	var box := BoxShape3D.new()
	box.size = size
	return box
