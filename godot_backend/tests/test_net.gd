extends RefCounted
## Frames, payloads and reliable delivery.

const Frame := preload("../net/frame.gd")
const Reader := preload("../net/reader.gd")
const Channel := preload("../net/reliable_channel.gd")
const Protocol := preload("../net/protocol.gd")
const Server := preload("../net/server.gd")


## A network on which one client says hello.
class Hello:
	extends RefCounted
	var window := 32
	var waiting: Array[PackedByteArray] = []

	func _init() -> void:
		var hello := JSON.stringify({"protocol": [Protocol.VERSION, Protocol.VERSION], "nonce": 5})
		waiting.append(Frame.pack(Protocol.HELLO, 0, 0, hello.to_ascii_buffer()))

	func poll() -> void:
		pass

	func available() -> bool:
		return not waiting.is_empty()

	func take() -> PackedByteArray:
		return waiting.pop_front()

	func source() -> String:
		return "127.0.0.1 9"

	func send(_destination: String, _datagram: PackedByteArray) -> void:
		pass


func test_a_silent_client_is_forgotten_where_nothing_else_tells_its_end() -> String:
	for timeout: int in [0, 1]:
		var server := Server.new(Hello.new())
		server.greeter = func(_hello: Dictionary) -> Dictionary: return {}
		server.poll(false)
		if not server.connected():
			return "no session"
		server.session_timeout_usec = timeout
		OS.delay_msec(2)
		server.poll(false)
		if server.connected() == (timeout > 0):
			return "timeout %d" % timeout
	return ""


func test_what_is_packed_is_opened() -> String:
	var frame := Frame.open(Frame.pack(17, 5, 9, PackedByteArray([1, 2, 3])))
	if frame == null or frame.type != 17 or frame.session != 5 or frame.seq != 9:
		return "header"
	return "" if frame.payload == PackedByteArray([1, 2, 3]) else "payload"


func test_any_flipped_bit_is_noticed() -> String:
	var whole := Frame.pack(17, 5, 9, PackedByteArray([1, 2, 3]))
	for i in whole.size() * 8:
		var spoilt := whole.duplicate()
		spoilt[i / 8] ^= 1 << (i % 8)
		if Frame.open(spoilt) != null:
			return "bit %d" % i
	return ""


func test_a_reader_fails_at_the_end_and_stays_failed() -> String:
	var reader := Reader.new(PackedByteArray([1, 0]))
	if reader.u16() != 1 or reader.u8() != 0 or not reader.failed:
		return "did not fail"
	return "" if reader.u8() == 0 and not reader.at_end() else "came back"


func test_numbers_that_are_not_finite_are_refused() -> String:
	for value: float in [NAN, INF, -INF, 2e6]:
		var bytes := PackedFloat32Array([1.0, value]).to_byte_array()
		var reader := Reader.new(bytes)
		reader.floats(2, 1e6)
		if not reader.failed:
			return str(value)
	return ""


func test_json_of_nonsense_is_refused_without_a_word() -> String:
	for text: String in ["", "[1]", "{", '{"a":}', "\u0007"]:
		var reader := Reader.new(text.to_utf8_buffer())
		if not reader.json().is_empty() or not reader.failed:
			return text
	return ""


func test_a_doubled_message_is_handed_on_once() -> String:
	var channel := Channel.new()
	return "" if channel.accept(1) and not channel.accept(1) else "twice"


func test_order_does_not_matter_to_the_acknowledgment() -> String:
	var channel := Channel.new()
	for seq: int in [3, 1, 5]:
		channel.accept(seq)
	var ack := channel.take_ack()
	if ack.decode_u32(0) != 1:
		return "cumulative %d" % ack.decode_u32(0)
	return "" if ack.decode_u64(4) == 0b1010 else "mask %d" % ack.decode_u64(4)


func test_what_is_not_acknowledged_is_sent_again() -> String:
	var channel := Channel.new()
	channel.offer(17, PackedByteArray())
	if channel.due(0).size() != 1 or not channel.due(1000).is_empty():
		return "first sending"
	return "" if channel.due(60000).size() == 1 else "second sending"
