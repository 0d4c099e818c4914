extends RefCounted
## Datagrams over UDP, bound to one address.

const Protocol := preload("protocol.gd")

const BUFFER_BYTES := 4194304

var window := Protocol.WINDOW

var _peer := PacketPeerUDP.new()
var _destination := ""


func listen(host: String, port: int) -> Error:
	return _peer.bind(port, host, BUFFER_BYTES)


func port() -> int:
	return _peer.get_local_port()


func poll() -> void:
	pass


func available() -> bool:
	return _peer.get_available_packet_count() > 0


## Waits for a datagram, for as long as it takes.
func wait() -> void:
	_peer.wait()


func take() -> PackedByteArray:
	return _peer.get_packet()


## Where the last datagram taken came from.
func source() -> String:
	return "%s %d" % [_peer.get_packet_ip(), _peer.get_packet_port()]


func send(destination: String, datagram: PackedByteArray) -> void:
	if destination != _destination:
		_destination = destination
		var parts := destination.split(" ")
		_peer.set_dest_address(parts[0], int(parts[1]))
	_peer.put_packet(datagram)
