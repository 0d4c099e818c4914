class_name RoadlangFollowedLine
extends RefCounted
## How far left of a path's center line the line lies that an agent follows: the same everywhere, or
## by arc length, in a lane that changes its width.

const PathLine := preload("path_line.gd")

## Meters to each side over which slope and curvature are measured.
const AROUND := 1.0

## Where it is the same everywhere.
var _offset := 0.0
var _stations := PackedFloat64Array()
var _offsets := PackedFloat64Array()


## `pairs`: an array of an arc length and the offset there each, in ascending order; anything else
## leaves the line at `offset`.
func _init(offset: float = 0.0, pairs: Variant = null) -> void:
	_offset = offset
	if not pairs is Array or pairs.size() < 2:
		return
	for pair: Variant in pairs:
		if not _follows(pair):
			_stations.clear()
			_offsets.clear()
			return
		_stations.append(pair[0])
		_offsets.append(pair[1])


## Of a path at an arc length, meters.
func offset(path: PathLine, s: float) -> float:
	if _offsets.is_empty():
		return _offset
	var at := path.wrapped(s)
	var i := clampi(_stations.bsearch(at) - 1, 0, _offsets.size() - 2)
	var share := (at - _stations[i]) / (_stations[i + 1] - _stations[i])
	return lerpf(_offsets[i], _offsets[i + 1], clampf(share, 0.0, 1.0))


## Radians by which the line is turned to the left of its path there.
func turned(path: PathLine, s: float) -> float:
	if _offsets.is_empty():
		return 0.0
	return atan((offset(path, s + AROUND) - offset(path, s - AROUND)) / (2.0 * AROUND))


## 1/m by which the line bends more to the left than its path there.
func bend(path: PathLine, s: float) -> float:
	if _offsets.is_empty():
		return 0.0
	return (turned(path, s + AROUND) - turned(path, s - AROUND)) / (2.0 * AROUND)


func _follows(pair: Variant) -> bool:
	if not pair is Array or pair.size() != 2 or not pair[0] is float or not pair[1] is float:
		return false
	var last := _stations.size() - 1
	return is_finite(pair[1]) and is_finite(pair[0]) and (last < 0 or pair[0] > _stations[last])
