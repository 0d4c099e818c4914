extends RefCounted
## Reliable delivery over datagrams that may be lost, doubled or out of order.
##
## Each side numbers what it sends from 1. The other acknowledges with the last number up to which
## it has everything, and a mask of the 64 that follow; what is not acknowledged is sent again.
## Messages are handed on as they come, each exactly once: none depends on its place.

const Message := preload("message.gd")
const Protocol := preload("protocol.gd")

const FIRST_RESEND_USEC := 50000
const LAST_RESEND_USEC := 200000
const MASK_BITS := 64

var window := Protocol.WINDOW
var resent := 0

var _next_seq := 1
var _waiting: Array[Message] = []
## By sequence number.
var _flying: Dictionary = {}
var _received := 0
var _beyond: Dictionary = {}
var _ack_due := false


## Takes a message for sending.
func offer(type: int, payload: PackedByteArray) -> void:
	_waiting.append(Message.new(type, payload))


## What is to be sent now.
func due(now_usec: int) -> Array[Message]:
	var out: Array[Message] = []
	for seq: int in _flying:
		var message: Message = _flying[seq]
		if now_usec >= message.due:
			message.pause = mini(message.pause * 2, LAST_RESEND_USEC)
			message.due = now_usec + message.pause
			resent += 1
			out.append(message)
	while not _waiting.is_empty() and _flying.size() < window:
		var message: Message = _waiting.pop_front()
		message.seq = _next_seq
		message.pause = FIRST_RESEND_USEC
		message.due = now_usec + FIRST_RESEND_USEC
		_flying[_next_seq] = message
		out.append(message)
		_next_seq += 1
	return out


## Whether this number is new; records it. Numbers far ahead are refused, so memory is bounded.
func accept(seq: int) -> bool:
	_ack_due = true
	if seq <= _received or _beyond.has(seq) or seq > _received + 2 * Protocol.WEBSOCKET_WINDOW:
		return false
	_beyond[seq] = true
	while _beyond.erase(_received + 1):
		_received += 1
	return true


func acknowledged(payload: PackedByteArray) -> void:
	if payload.size() != 12:
		return
	var upto := payload.decode_u32(0)
	var mask := payload.decode_u64(4)
	for seq: int in _flying.keys():
		var ahead := seq - upto - 1
		if seq <= upto or (ahead < MASK_BITS and (mask >> ahead) & 1):
			_flying.erase(seq)


## The acknowledgment to send, empty where none is due.
func take_ack() -> PackedByteArray:
	if not _ack_due:
		return PackedByteArray()
	_ack_due = false
	var mask := 0
	for seq: int in _beyond:
		if seq - _received - 1 < MASK_BITS:
			mask |= 1 << (seq - _received - 1)
	var payload := PackedByteArray()
	payload.resize(12)
	payload.encode_u32(0, _received)
	payload.encode_s64(4, mask)
	return payload


## How many messages wait or fly.
func backlog() -> int:
	return _waiting.size() + _flying.size()
