extends "thing.gd"
## Square cells of a pixel road: the neighbors of a cell choose its shape and its turn.

const Protocol := preload("../net/protocol.gd")
const Cells := preload("cells.gd")
const Instances := preload("instances.gd")
const TileMesh := preload("tile_mesh.gd")

const CELL_BYTES := 5

static var _made: Dictionary = {}

var _cell := 1.0
var _shift := Vector2.ZERO
## Its number in the table of the world.
var _surface := 0
## By the mask of a shape before it is turned.
var _meshes: Dictionary = {}


func build(reader: Reader) -> String:
	_cell = reader.f32(1000.0)
	_shift = Vector2(reader.f32(Protocol.MAX_COORDINATE), reader.f32(Protocol.MAX_COORDINATE))
	var count := reader.u16()
	var raw := reader.bytes(count * CELL_BYTES)
	if not reader.at_end():
		_surface = reader.u8()
	if not reader.at_end() or count < 1 or _cell < 0.1:
		return "bad tiles"
	var places: Dictionary = {}
	var cells: Dictionary = {}
	for i in count:
		var cell := Vector2i(raw.decode_s16(i * CELL_BYTES), raw.decode_s16(i * CELL_BYTES + 2))
		var mask := raw[i * CELL_BYTES + 4]
		if not is_mask(mask) or cells.has(cell):
			return "a corner counts between two sides that do, and a cell has one tile"
		cells[cell] = true
		var turned := shape_of(mask)
		var alike: Array[Transform3D] = places.get_or_add(turned.x, [] as Array[Transform3D])
		alike.append(_place(cell, turned.y))
	for shape: int in places:
		_add_shape(shape, places[shape])
	add_body(Cells.faces(cells, _cell, _shift), _surface)
	return ""


## Cells and masks as the instances in the scene have them, in order.
func content() -> PackedByteArray:
	var found := PackedStringArray()
	for shape: int in _meshes:
		for place in Instances.places_of(_meshes[shape]):
			found.append(_cell_of(place, shape).hex_encode())
	found.sort()
	var out := PackedByteArray()
	for cell in found:
		out.append_array(cell.hex_decode())
	return out


## Whether a byte says of sides and corners what can be: a corner joins two sides.
static func is_mask(mask: int) -> bool:
	var sides := mask & 15
	return (mask >> 4) & ~(sides & ((sides >> 1) | (sides << 3))) == 0


## The least mask that can be turned into this one, and by how many clockwise quarters.
static func shape_of(mask: int) -> Vector2i:
	var best := Vector2i(256, 0)
	for turns in 4:
		var shape := turn(mask, 4 - turns)
		if shape < best.x:
			best = Vector2i(shape, turns)
	return best


## A mask turned clockwise by quarters.
static func turn(mask: int, turns: int) -> int:
	var sides := mask & 15
	var corners := mask >> 4
	turns &= 3
	sides = ((sides << turns) | (sides >> (4 - turns))) & 15
	corners = ((corners << turns) | (corners >> (4 - turns))) & 15
	return sides | corners << 4


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
	bytes.encode_u8(4, turn(shape, turns))
	return bytes


func _add_shape(shape: int, places: Array[Transform3D]) -> void:
	var key := shape | _surface << 8
	if not _made.has(key):
		_made[key] = TileMesh.make(shape, _surface)
	var multimesh := Instances.make(_made[key], places)
	_meshes[shape] = multimesh
	var instance := MultiMeshInstance3D.new()
	instance.multimesh = multimesh
	instance.cast_shadow = GeometryInstance3D.SHADOW_CASTING_SETTING_OFF
	add_child(instance)
