extends RefCounted
## Takes datagrams from one client at a time, and hands whole messages on, each exactly once.

const Protocol := preload("protocol.gd")
const Frame := preload("frame.gd")
const Channel := preload("reliable_channel.gd")
const Reader := preload("reader.gd")
const UdpLink := preload("udp_link.gd")

## A pass over the socket takes at most this long, so that the simulation goes on under any load.
const BUDGET_USEC := 8000
## How long a pass waits for more once datagrams have come: bulk then does not wait for a frame.
const LINGER_USEC := 1500
## A client this long unheard gives way to another.
const YIELD_USEC := 6000000
const ACK_EVERY := 8
const PART_BYTES := 7000
const MAX_COMPLAINTS := 20
## Messages on their way to a client, beyond which nothing more is taken from it.
const MOST_BACKLOG := 8192

## Called with (type, payload); returns "" or what is wrong with the message.
var handler: Callable
## Called with the client's HELLO when a session begins.
var greeter: Callable
## How long a client may be unheard before it counts as gone; 0: for ever.
var session_timeout_usec := 60000000
var dropped := 0
var refused := 0

var _link: RefCounted
var _channel := Channel.new()
var _session := 0
var _ended := 0
var _client := ""
var _nonce := -1
var _last_heard := 0
var _complaints := 0
var _welcome := PackedByteArray()


func _init(link: RefCounted) -> void:
	_link = link


func connected() -> bool:
	return _session != 0


## Where it listens.
func port() -> int:
	return _link.call("port")


## Whether the client has yet to take much of what it asked for.
func is_behind() -> bool:
	return _channel.backlog() > MOST_BACKLOG


## Sends a message that will arrive exactly once.
func send(type: int, payload: PackedByteArray) -> void:
	if _session != 0:
		_channel.offer(type, payload)


func send_json(type: int, value: Dictionary) -> void:
	send(type, JSON.stringify(value).to_ascii_buffer())


## Sends bytes of any length in parts: u32 id, u16 part, u16 parts before the bytes of each.
func send_parts(type: int, id: int, bytes: PackedByteArray) -> void:
	var parts := ceili(float(bytes.size()) / PART_BYTES)
	for part in parts:
		var out := PackedByteArray()
		out.resize(8)
		out.encode_u32(0, id)
		out.encode_u16(4, part)
		out.encode_u16(6, parts)
		out.append_array(bytes.slice(part * PART_BYTES, (part + 1) * PART_BYTES))
		send(type, out)


## Sends a message that may be lost.
func send_once(type: int, payload: PackedByteArray) -> void:
	if _session != 0:
		_link.send(_client, Frame.pack(type, _session, 0, payload))


## Takes what has come, and sends what is due. Returns whether anything came.
## With `linger` it waits a moment for more of a burst.
func poll(linger: bool) -> bool:
	var now := Time.get_ticks_usec()
	var deadline := now + BUDGET_USEC
	var quiet_since := now
	var taken := 0
	_link.poll()
	while now < deadline:
		if _link.available():
			_receive(_link.take(), _link.source(), now)
			taken += 1
			quiet_since = Time.get_ticks_usec()
			if taken % ACK_EVERY == 0:
				_send_ack()
		elif taken == 0 or not linger or now - quiet_since > LINGER_USEC:
			break
		else:
			_flush(now)
			OS.delay_usec(100)
			_link.poll()
		now = Time.get_ticks_usec()
	_flush(now)
	var is_forgotten := session_timeout_usec > 0 and now - _last_heard > session_timeout_usec
	if _session != 0 and is_forgotten:
		end_session()
	return taken > 0


## Whether a pause until the next datagram is safe, and taken. A client that waits says its step
## again and again, so that a state that was lost is sent again; one that is gone ends this program.
func wait() -> bool:
	var is_safe := session_timeout_usec == 0 and _link is UdpLink and _channel.backlog() == 0
	if is_safe:
		(_link as UdpLink).wait()
	return is_safe


func end_session() -> void:
	_session = 0
	_client = ""
	_nonce = -1
	_channel = Channel.new()
	_channel.window = _link.window


func _flush(now: int) -> void:
	if _session == 0:
		return
	_send_ack()
	for message in _channel.due(now):
		_link.send(_client, Frame.pack(message.type, _session, message.seq, message.payload))


func _send_ack() -> void:
	var ack := _channel.take_ack()
	if not ack.is_empty() and _session != 0:
		_link.send(_client, Frame.pack(Protocol.ACK, _session, 0, ack))


func _receive(datagram: PackedByteArray, source: String, now: int) -> void:
	var frame := Frame.open(datagram)
	if frame == null:
		dropped += 1
		return
	if frame.type == Protocol.HELLO:
		_greet(frame, source, now)
		return
	if _session == 0 or frame.session != _session or source != _client:
		refused += 1
		# Its first answer to a goodbye may have been lost.
		if frame.type == Protocol.BYE and frame.session == _ended:
			_link.send(source, Frame.pack(Protocol.BYE, _ended, 0, PackedByteArray()))
		return
	_last_heard = now
	match frame.type:
		Protocol.ACK:
			_channel.acknowledged(frame.payload)
		Protocol.PING:
			send_once(Protocol.PING, PackedByteArray())
		Protocol.BYE:
			_send_goodbye()
		_:
			# What is not taken is not acknowledged either, and comes again.
			if not is_behind() and (frame.seq == 0 or _channel.accept(frame.seq)):
				_hand_on(frame)


func _hand_on(frame: Frame) -> void:
	var wrong: String = handler.call(frame.type, frame.payload)
	if wrong.is_empty():
		return
	refused += 1
	_complaints += 1
	if _complaints <= MAX_COMPLAINTS:
		send_json(Protocol.ERROR, {"type": frame.type, "seq": frame.seq, "text": wrong})


func _send_goodbye() -> void:
	_link.send(_client, Frame.pack(Protocol.BYE, _session, 0, PackedByteArray()))
	_ended = _session
	end_session()


func _greet(frame: Frame, source: String, now: int) -> void:
	var reader := Reader.new(frame.payload)
	var hello := reader.json()
	var range_given: Variant = hello.get("protocol")
	var nonce: Variant = hello.get("nonce")
	if reader.failed or not range_given is Array or not nonce is float:
		dropped += 1
		return
	if _session != 0 and source == _client and int(nonce) == _nonce:
		_link.send(source, _welcome)
		return
	if _session != 0 and now - _last_heard < YIELD_USEC and source != _client:
		_refuse(source, "busy", "another client is using this engine")
		return
	if not _speaks(range_given):
		_refuse(source, "protocol", "this engine uses protocol version %d" % Protocol.VERSION)
		return
	_open_session(hello, source, now)


func _speaks(range_given: Array) -> bool:
	if range_given.size() != 2 or not range_given[0] is float or not range_given[1] is float:
		return false
	return range_given[0] <= Protocol.VERSION and range_given[1] >= Protocol.VERSION


func _open_session(hello: Dictionary, source: String, now: int) -> void:
	end_session()
	_session = (randi() & 0x7FFFFFFF) | 1
	_client = source
	_nonce = int(float(hello["nonce"]))
	_last_heard = now
	_complaints = 0
	var reply: Dictionary = greeter.call(hello)
	reply["protocol"] = Protocol.VERSION
	reply["session"] = _session
	reply["max_datagram"] = Protocol.MAX_DATAGRAM
	reply["window"] = _link.window
	var text := JSON.stringify(reply).to_ascii_buffer()
	_welcome = Frame.pack(Protocol.WELCOME, _session, 0, text)
	_link.send(source, _welcome)


func _refuse(source: String, code: String, text: String) -> void:
	var body := JSON.stringify({"code": code, "text": text}).to_ascii_buffer()
	_link.send(source, Frame.pack(Protocol.ERROR, 0, 0, body))
