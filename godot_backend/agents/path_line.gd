class_name RoadlangPath
extends RefCounted
## A center line by arc length, in the plane: x east, y north.

const PathLine := preload("path_line.gd")

## Segments looked at on each side of the last foot point.
const REACH := 6

var closed := false
var length := 0.0
var half_width := 0.0

## The greatest speeds at the points, by the limits that they are planned for.
var _plans: Dictionary = {}
var _x := PackedFloat64Array()
var _y := PackedFloat64Array()
var _s := PackedFloat64Array()


## The line of all pieces, or null while one is missing.
static func joined(pieces: Array) -> PathLine:
	if pieces.is_empty() or pieces.size() != int(pieces[0].pieces):
		return null
	var line := PathLine.new()
	line.closed = pieces[0].closed
	for piece: Node in pieces:
		var points: PackedFloat32Array = piece.points
		for i in points.size() / 3:
			line.add(points[3 * i], -points[3 * i + 1])
			line.half_width = points[3 * i + 2]
	if line.closed and line._x.size() > 2:
		line.add(line._x[0], line._y[0])
	return line if line._x.size() >= 2 else null


func add(x: float, y: float) -> void:
	var last := _x.size() - 1
	if last >= 0:
		var step := sqrt((x - _x[last]) * (x - _x[last]) + (y - _y[last]) * (y - _y[last]))
		if step < 1e-4:
			return
		length += step
	_x.append(x)
	_y.append(y)
	_s.append(length)


## The segment nearest to a point; with a hint, only of those near the hint.
func nearest(x: float, y: float, hint: int = -1) -> int:
	if hint < 0:
		return _nearest_of(x, y, 0, _x.size() - 2)
	return _nearest_of(x, y, hint - REACH, hint + REACH)


## The segment nearest to a point, of those within `reach` meters of an arc length.
func nearest_to(x: float, y: float, s: float, reach: float) -> int:
	if 2.0 * reach >= length:
		return nearest(x, y)
	var first := segment_at(s - reach)
	var last := segment_at(s + reach)
	return _nearest_of(x, y, first, last if last >= first else last + _x.size() - 1)


## Arc length of the foot point on a segment.
func station(segment: int, x: float, y: float) -> float:
	return lerpf(_s[segment], _s[segment + 1], _along(segment, x, y))


## How far a point is to the left of a segment; past an open end, of its straight continuation.
func offset(segment: int, x: float, y: float) -> float:
	var dx := _x[segment + 1] - _x[segment]
	var dy := _y[segment + 1] - _y[segment]
	var t := _along(segment, x, y)
	var last := segment == _x.size() - 2 and t >= 1.0
	if not closed and (last or (segment == 0 and t <= 0.0)):
		return (dx * (y - _y[segment]) - dy * (x - _x[segment])) / sqrt(dx * dx + dy * dy)
	var to_x := x - _x[segment] - t * dx
	var to_y := y - _y[segment] - t * dy
	var side := 1.0 if dx * to_y - dy * to_x >= 0.0 else -1.0
	return side * sqrt(to_x * to_x + to_y * to_y)


func heading(s: float) -> float:
	var i := segment_at(s)
	var here := _heading_of(i)
	var middle := 0.5 * (_s[i] + _s[i + 1])
	var other := i + 1 if wrapped(s) >= middle else i - 1
	if other < 0 or other > _x.size() - 2:
		if not closed:
			return here
		other = posmod(other, _x.size() - 1)
	var span := 0.5 * (_s[i + 1] - _s[i] + _s[other + 1] - _s[other])
	var part := clampf(absf(wrapped(s) - middle) / span, 0.0, 1.0)
	return here + part * angle_difference(here, _heading_of(other))


func curvature(s: float) -> float:
	const STEP := 2.0
	return angle_difference(heading(s - STEP), heading(s + STEP)) / (2.0 * STEP)


## The greatest speed at an arc length from which the bends beyond it can be driven with a lateral
## acceleration, braking before them; `direction` is that of travel.
func bend_speed(s: float, direction: float, lateral: float, braking: float) -> float:
	var key := Vector3(direction, lateral, braking)
	if not _plans.has(key):
		_plans[key] = _planned(direction, lateral, braking)
	var plan: PackedFloat64Array = _plans[key]
	var i := segment_at(s)
	return minf(plan[i], plan[i + 1])


## The point at an arc length, moved to the left; before the start and past the end, straight on.
func point(s: float, left: float = 0.0) -> Vector2:
	var i := segment_at(s)
	var at := wrapped(s)
	var t := (at - _s[i]) / (_s[i + 1] - _s[i])
	var direction := heading(s)
	return Vector2(
		_x[i] + t * (_x[i + 1] - _x[i]) - sin(direction) * left,
		_y[i] + t * (_y[i + 1] - _y[i]) + cos(direction) * left
	)


func segment_at(s: float) -> int:
	var i := _s.bsearch(wrapped(s)) - 1
	return clampi(i, 0, _s.size() - 2)


func wrapped(s: float) -> float:
	return fposmod(s, length) if closed else s


func _nearest_of(x: float, y: float, first: int, last: int) -> int:
	var count := _x.size() - 1
	var best := 0
	var least := INF
	for raw in range(first, last + 1):
		var i := posmod(raw, count) if closed else clampi(raw, 0, count - 1)
		var t := _along(i, x, y)
		var dx := x - _x[i] - t * (_x[i + 1] - _x[i])
		var dy := y - _y[i] - t * (_y[i + 1] - _y[i])
		if dx * dx + dy * dy < least:
			least = dx * dx + dy * dy
			best = i
	return best


func _planned(direction: float, lateral: float, braking: float) -> PackedFloat64Array:
	var count := _x.size()
	var square := PackedFloat64Array()
	for s in _s:
		square.append(lateral / maxf(absf(curvature(s)), 1e-6))
	# Beyond the end of a closed line is its beginning: twice around.
	for k in range(1, 2 * count if closed else count):
		var i := posmod(count - 1 - k if direction > 0.0 else k, count)
		var next := posmod(i + 1 if direction > 0.0 else i - 1, count)
		var step := absf(_s[next] - _s[i])
		square[i] = minf(square[i], square[next] + 2.0 * braking * (0.0 if step > 5.0 else step))
	for i in count:
		square[i] = sqrt(square[i])
	return square


func _heading_of(segment: int) -> float:
	return atan2(_y[segment + 1] - _y[segment], _x[segment + 1] - _x[segment])


func _along(i: int, x: float, y: float) -> float:
	var dx := _x[i + 1] - _x[i]
	var dy := _y[i + 1] - _y[i]
	return clampf(((x - _x[i]) * dx + (y - _y[i]) * dy) / (dx * dx + dy * dy), 0.0, 1.0)
