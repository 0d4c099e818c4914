extends "../build/thing.gd"
## What things are: for each a class, and the number of its first instance. The client chooses both.

const RECORD_BYTES := 8
## Stands for scenery, which no client sends: `id` is that of the node's "scenery" meta.
const SCENERY := 0

## By kind << 32 | id of a thing: class, first instance, and whether its parts are counted on.
var labels: Dictionary = {}

var _message := PackedByteArray()


func build(reader: Reader) -> String:
	var thing_kind := reader.u8()
	var count := reader.u16()
	_message = reader.bytes(count * RECORD_BYTES)
	if not reader.at_end() or count < 1:
		return "bad labels"
	for i in count:
		var at := i * RECORD_BYTES
		var first := _message.decode_u16(at + 6)
		var label := Vector3i(_message[at + 4], first, mini(_message[at + 5], 1))
		labels[thing_kind << 32 | _message.decode_u32(at)] = label
	return ""


func content() -> PackedByteArray:
	return _message
