extends RefCounted
## The lights of a junction over time.

const Signals := preload("../build/signals.gd")

## Of two heads that have green in turn, 2 s into the first phase: the time, and what they show.
const TABLE: Array[Array] = [
	[0.0, 0, 2],
	[7.9, 0, 2],
	[8.0, 1, 2],
	[11.0, 2, 2],
	[12.5, 2, 0],
	[21.9, 2, 0],
	[22.0, 2, 1],
	[25.0, 2, 2],
	[27.0, 0, 2],
	[37.1, 1, 2]
]


func test_phases_follow_one_another() -> String:
	var seconds := PackedFloat32Array([10.0, 3.0, 1.5, 9.5, 3.0, 2.0])
	for row in TABLE:
		for head in 2:
			var green := PackedByteArray([1 - head, head])
			var shown := Signals.light(seconds, 2.0, green, row[0])
			if shown != row[1 + head]:
				return "head %d at %.1f s: %d" % [head, row[0], shown]
	return ""
