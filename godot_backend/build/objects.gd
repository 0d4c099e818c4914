extends "res://build/thing.gd"
## Things of one sort that stand still: drawn as instances of one mesh, solid where asked.

const Protocol := preload("res://net/protocol.gd")
const Props := preload("res://build/props.gd")
const Instances := preload("res://build/instances.gd")

const FIELDS := 7
const MAX_SIZE := 1000.0
const TRUNK_RADIUS := 0.25

var sort := ""

var _multimesh: MultiMesh


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
	_add_instances(places, color)
	if solid:
		_add_bodies(places)
	return ""


## The positions that the instances have.
func content() -> PackedByteArray:
	var positions := PackedVector3Array()
	for place in places():
		positions.append(place.origin)
	return positions.to_byte_array()


func places() -> Array[Transform3D]:
	return Instances.places_of(_multimesh)


func _add_instances(places_given: Array[Transform3D], color: String) -> void:
	_multimesh = Instances.make(Props.mesh(sort, color), places_given)
	var instance := MultiMeshInstance3D.new()
	instance.multimesh = _multimesh
	add_child(instance)


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
