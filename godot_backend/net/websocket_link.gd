extends RefCounted
## The same datagrams as binary messages of WebSocket connections: for bulk, and across proxies.

const Protocol := preload("protocol.gd")

const BUFFER_BYTES := 4194304
const MAX_PEERS := 8

var window := Protocol.WEBSOCKET_WINDOW

var _server := TCPServer.new()
var _peers: Dictionary = {}
var _next_name := 1
var _source := ""


func listen(host: String, port: int) -> Error:
	return _server.listen(port, host)


func port() -> int:
	return _server.get_local_port()


func poll() -> void:
	while _server.is_connection_available():
		var stream := _server.take_connection()
		if _peers.size() >= MAX_PEERS:
			stream.disconnect_from_host()
			continue
		var peer := WebSocketPeer.new()
		peer.inbound_buffer_size = BUFFER_BYTES
		peer.outbound_buffer_size = BUFFER_BYTES
		peer.max_queued_packets = 4096
		if peer.accept_stream(stream) == OK:
			_peers["ws %d" % _next_name] = peer
			_next_name += 1
	for name: String in _peers.keys():
		var peer: WebSocketPeer = _peers[name]
		peer.poll()
		if peer.get_ready_state() == WebSocketPeer.STATE_CLOSED:
			_peers.erase(name)


func available() -> bool:
	return not _ready_peer().is_empty()


func take() -> PackedByteArray:
	_source = _ready_peer()
	var peer: WebSocketPeer = _peers[_source]
	return peer.get_packet()


func source() -> String:
	return _source


func send(destination: String, datagram: PackedByteArray) -> void:
	var peer: WebSocketPeer = _peers.get(destination)
	if peer != null and peer.get_ready_state() == WebSocketPeer.STATE_OPEN:
		peer.put_packet(datagram)


func _ready_peer() -> String:
	for name: String in _peers:
		var peer: WebSocketPeer = _peers[name]
		if (
			peer.get_ready_state() == WebSocketPeer.STATE_OPEN
			and peer.get_available_packet_count() > 0
		):
			return name
	return ""
