extends RefCounted
## A numbered message on its way: sent again until it is acknowledged.

var type := 0
var seq := 0
var payload := PackedByteArray()
## Microseconds: when it is sent again, and how long it waits then.
var due := 0
var pause := 0


func _init(of_type: int, body: PackedByteArray) -> void:
	type = of_type
	payload = body
