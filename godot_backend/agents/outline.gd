extends RefCounted
## The rectangle that something covers on the ground.

const Outline := preload("outline.gd")

var middle := Vector2.ZERO

var _along := Vector2.RIGHT
var _half := Vector2.ZERO


func _init(place: Vector2, heading: float, length: float, width: float) -> void:
	middle = place
	_along = Vector2.from_angle(heading)
	_half = Vector2(length, width) * 0.5


func distance(other: Outline) -> float:
	return middle.distance_to(other.middle)


## Free space to another rectangle, 0 where they overlap.
func gap(other: Outline) -> float:
	if _overlaps(other) and other._overlaps(self):
		return 0.0
	var least := INF
	for corner in other.corners():
		least = minf(least, _away(corner))
	for corner in corners():
		least = minf(least, other._away(corner))
	return least


func corners() -> Array[Vector2]:
	var across := _along.orthogonal()
	var out: Array[Vector2] = []
	for i: float in [-1.0, 1.0]:
		for j: float in [-1.0, 1.0]:
			out.append(middle + _along * _half.x * i + across * _half.y * j)
	return out


func _local(point: Vector2) -> Vector2:
	var to := point - middle
	return Vector2(to.dot(_along), to.dot(_along.orthogonal()))


func _away(point: Vector2) -> float:
	var outside := (_local(point).abs() - _half).max(Vector2.ZERO)
	return outside.length()


## Whether the shadows on both own axes overlap (half of the separating axis test).
func _overlaps(other: Outline) -> bool:
	var low := Vector2(INF, INF)
	var high := Vector2(-INF, -INF)
	for corner in other.corners():
		low = low.min(_local(corner))
		high = high.max(_local(corner))
	return low.x <= _half.x and high.x >= -_half.x and low.y <= _half.y and high.y >= -_half.y
