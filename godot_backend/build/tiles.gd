extends "thing.gd"
## Square cells of a pixel road: the four neighbors of a cell choose its shape and its turn.

const Protocol := preload("../net/protocol.gd")
const Looks := preload("looks.gd")
const Cells := preload("cells.gd")
const Instances := preload("instances.gd")

## Neighbors as bits, clockwise from north.
const NORTH := 1
const EAST := 2
const SOUTH := 4
const WEST := 8

## Dot, end, straight, corner, tee and cross, each as the mask that it has before it is turned.
const SHAPES: Array[int] = [0, NORTH, NORTH | SOUTH, NORTH | EAST, NORTH | EAST | SOUTH, 15]

const CELL_BYTES := 5

var _cell := 1.0
var _shift := Vector2.ZERO
var _meshes: Array[MultiMesh] = []


func build(reader: Reader) -> String:
	_cell = reader.f32(1000.0)
	_shift = Vector2(reader.f32(Protocol.MAX_COORDINATE), reader.f32(Protocol.MAX_COORDINATE))
	var count := reader.u16()
	var raw := reader.bytes(count * CELL_BYTES)
	if not reader.at_end() or count < 1 or _cell < 0.1:
		return "bad tiles"
	var places: Dictionary = {}
	var cells: Dictionary = {}
	for i in count:
		var cell := Vector2i(raw.decode_s16(i * CELL_BYTES), raw.decode_s16(i * CELL_BYTES + 2))
		var mask := raw[i * CELL_BYTES + 4]
		if mask > 15 or cells.has(cell):
			return "a tile has a mask of 0 to 15, and a cell has one tile"
		cells[cell] = true
		var turned := shape_of(mask)
		var alike: Array[Transform3D] = places.get_or_add(turned.x, [] as Array[Transform3D])
		alike.append(_place(cell, turned.y))
	for shape in SHAPES.size():
		_add_shape(shape, places.get(shape, [] as Array[Transform3D]))
	add_body(Cells.faces(cells, _cell, _shift))
	return ""


## Cells and masks as the instances in the scene have them, in order.
func content() -> PackedByteArray:
	var found := PackedStringArray()
	for shape in _meshes.size():
		for place in Instances.places_of(_meshes[shape]):
			found.append(_cell_of(place, shape).hex_encode())
	found.sort()
	var out := PackedByteArray()
	for cell in found:
		out.append_array(cell.hex_decode())
	return out


## Shape and clockwise quarter turns of a mask.
static func shape_of(mask: int) -> Vector2i:
	for shape in SHAPES.size():
		for turns in 4:
			if turn(SHAPES[shape], turns) == mask:
				return Vector2i(shape, turns)
	return Vector2i.ZERO


## A mask turned clockwise by quarters.
static func turn(mask: int, turns: int) -> int:
	return ((mask << turns) | (mask >> (4 - turns))) & 15


func _place(cell: Vector2i, turns: int) -> Transform3D:
	var center := (Vector2(cell) + Vector2(0.5, 0.5)) * _cell + _shift
	var turned := Basis(Vector3.UP, -turns * PI / 2).scaled(Vector3(_cell, 1.0, _cell))
	return Transform3D(turned, Vector3(center.x, 0.0, center.y))


func _cell_of(place: Transform3D, shape: int) -> PackedByteArray:
	var x := roundi((place.origin.x - _shift.x) / _cell - 0.5)
	var z := roundi((place.origin.z - _shift.y) / _cell - 0.5)
	var turns := posmod(roundi(atan2(place.basis.x.z, place.basis.x.x) / (PI / 2)), 4)
	var bytes := PackedByteArray()
	bytes.resize(CELL_BYTES)
	bytes.encode_s16(0, x)
	bytes.encode_s16(2, z)
	bytes.encode_u8(4, turn(SHAPES[shape], turns))
	return bytes


func _add_shape(shape: int, places: Array[Transform3D]) -> void:
	var multimesh := Instances.make(Looks.tile(SHAPES[shape]), places)
	_meshes.append(multimesh)
	var instance := MultiMeshInstance3D.new()
	instance.multimesh = multimesh
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(instance)
