extends "thing.gd"
## Places that a human can drag: those of a road or network, or that of one agent or object.

enum Sort { WAYPOINT, PLACE, OBJECT, AGENT, JUNCTION, STREET }

const Protocol := preload("../net/protocol.gd")

const FIELDS := 2

var sort := Sort.WAYPOINT
## What the scene file calls the road or the thing.
var title := ""

var _numbers := PackedFloat32Array()


func build(reader: Reader) -> String:
	sort = reader.u8() as Sort
	title = reader.ascii(reader.u8())
	var count := reader.u16()
	_numbers = reader.floats(count * FIELDS, Protocol.MAX_COORDINATE)
	if not reader.at_end() or count < 1 or sort > Sort.STREET:
		return "bad handles"
	return ""


func content() -> PackedByteArray:
	return _numbers.to_byte_array()


func is_of_road() -> bool:
	return sort == Sort.WAYPOINT or sort == Sort.PLACE


func count() -> int:
	return _numbers.size() / FIELDS


## x east, y north.
func place(index: int) -> Vector2:
	return Vector2(_numbers[FIELDS * index], _numbers[FIELDS * index + 1])
