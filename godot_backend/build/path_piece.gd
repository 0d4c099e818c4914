extends "thing.gd"
## A stretch of a path's center line: x, z and half width of each point.

const Protocol := preload("../net/protocol.gd")

const FIELDS := 3

var pieces := 0
var closed := false
var points := PackedFloat32Array()


func path_id() -> int:
	return id >> 16


func piece() -> int:
	return id & 0xFFFF


func build(reader: Reader) -> String:
	closed = reader.u8() != 0
	pieces = reader.u16()
	var count := reader.u16()
	points = reader.floats(count * FIELDS, Protocol.MAX_COORDINATE)
	if not reader.at_end() or count < 1 or piece() >= pieces:
		return "bad piece of a path"
	return ""


func content() -> PackedByteArray:
	return points.to_byte_array()
