extends RefCounted
## What a body has begun to touch: another body, by one of its shapes.

var body: Node
## The number of the shape.
var shape := 0


func _init(touched: Node, by_shape: int) -> void:
	body = touched
	shape = by_shape
