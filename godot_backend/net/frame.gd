extends RefCounted
## One datagram: a 20-byte header with a check, and a payload.

const Protocol := preload("protocol.gd")
const Frame := preload("frame.gd")

const MAGIC := 0x4C52

var type := 0
var session := 0
var seq := 0
var payload := PackedByteArray()


## The bytes of a datagram.
static func pack(
	frame_type: int, frame_session: int, frame_seq: int, body: PackedByteArray
) -> PackedByteArray:
	var head := PackedByteArray()
	head.resize(Protocol.HEADER_BYTES)
	head.encode_u16(0, MAGIC)
	head.encode_u8(2, Protocol.VERSION)
	head.encode_u8(3, frame_type)
	head.encode_u32(4, frame_session)
	head.encode_u32(8, frame_seq)
	head.encode_u32(12, body.size())
	var check := checksum(head, body)
	for i in 4:
		head[16 + i] = check[i]
	head.append_array(body)
	return head


## The frame in a datagram, or null where anything about it is wrong.
static func open(datagram: PackedByteArray) -> Frame:
	var size := datagram.size()
	if size < Protocol.HEADER_BYTES or size > Protocol.MAX_DATAGRAM:
		return null
	if datagram.decode_u16(0) != MAGIC or datagram.decode_u8(2) != Protocol.VERSION:
		return null
	if datagram.decode_u32(12) != size - Protocol.HEADER_BYTES:
		return null
	var frame := Frame.new()
	frame.payload = datagram.slice(Protocol.HEADER_BYTES)
	var check := checksum(datagram, frame.payload)
	for i in 4:
		if datagram[16 + i] != check[i]:
			return null
	frame.type = datagram.decode_u8(3)
	frame.session = datagram.decode_u32(4)
	frame.seq = datagram.decode_u32(8)
	return frame


static func checksum(head: PackedByteArray, body: PackedByteArray) -> PackedByteArray:
	var context := HashingContext.new()
	context.start(HashingContext.HASH_MD5)
	context.update(head.slice(0, 16))
	if not body.is_empty():
		context.update(body)
	return context.finish()
