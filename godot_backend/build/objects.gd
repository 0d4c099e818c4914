extends "thing.gd"
## Things of one sort: drawn as instances of one mesh, solid where asked. They stand still, but for
## those so light that vehicles push them away.

const Protocol := preload("../net/protocol.gd")
const Props := preload("props.gd")
const Instances := preload("instances.gd")

const FIELDS := 7
const MAX_SIZE := 1000.0
const TRUNK_RADIUS := 0.25
## Kilograms of what is pushed away, by sort.
const LIGHT := {"cone": 3.0}
const GROUND_LAYER := 1
const BODY_LAYER := 2

var sort := ""

var _multimesh: MultiMesh
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
	return Instances.places_of(_multimesh) if _light.is_empty() else _homes


func _add_instances(places_given: Array[Transform3D], color: String) -> void:
	_multimesh = Instances.make(Props.mesh(sort, color), places_given)
	var instance := MultiMeshInstance3D.new()
	instance.multimesh = _multimesh
	add_child(instance)


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
	instance.mesh = Props.mesh(sort, color)
	instance.scale = size
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
