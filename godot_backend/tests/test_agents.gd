extends RefCounted
## Paths, conditions and outlines.

const PathLine := preload("res://agents/path_line.gd")
const Condition := preload("res://agents/condition.gd")
const Outline := preload("res://agents/outline.gd")


func _circle(radius: float) -> PathLine:
	var line := PathLine.new()
	line.closed = true
	for i in 361:
		line.add(radius * cos(deg_to_rad(i)), radius * sin(deg_to_rad(i)))
	return line


func test_a_circle_has_its_length_and_curvature() -> String:
	var line := _circle(40.0)
	if absf(line.length - TAU * 40.0) > 0.05:
		return "length %f" % line.length
	for s: float in [0.0, 30.0, 200.0]:
		if absf(line.curvature(s) - 1.0 / 40.0) > 1e-3:
			return "curvature %f at %f" % [line.curvature(s), s]
	return ""


func test_left_of_a_path_is_positive() -> String:
	var line := PathLine.new()
	line.add(0.0, 0.0)
	line.add(10.0, 0.0)
	var segment := line.nearest(4.0, 2.0)
	if absf(line.offset(segment, 4.0, 2.0) - 2.0) > 1e-6:
		return "offset"
	return "" if absf(line.station(segment, 4.0, 2.0) - 4.0) < 1e-6 else "station"


func test_a_point_before_the_start_is_straight_on() -> String:
	var line := PathLine.new()
	line.add(0.0, 0.0)
	line.add(10.0, 0.0)
	return "" if line.point(-3.0, 1.0).distance_to(Vector2(-3.0, 1.0)) < 1e-6 else "elsewhere"


func test_once_remembers_and_forgets() -> String:
	var condition := Condition.new(["once", 0.0, 1.0, ["<", ["x", "a"], 5.0]])
	var seen: Array[float] = [9.0, 4.0, 9.0, 9.0, 9.0]
	var out := PackedInt32Array()
	for i in seen.size():
		var signals := func(_name: String, _names: Array[String]) -> float: return seen[i]
		out.append(int(condition.value(signals, i * 0.6)))
	return "" if out == PackedInt32Array([0, 1, 1, 0, 0]) else str(out)


func test_since_needs_all_that_lies_between() -> String:
	var condition := Condition.new(
		["since", 0.0, 9.0, [">", ["a", "e"], 0.0], [">", ["b", "e"], 0.0]]
	)
	var a: Array[float] = [1.0, 1.0, -1.0, 1.0]
	var b: Array[float] = [1.0, -1.0, -1.0, -1.0]
	var out := PackedInt32Array()
	for i in a.size():
		var signals := func(name: String, _names: Array[String]) -> float:
			return a[i] if name == "a" else b[i]
		out.append(int(condition.value(signals, float(i))))
	return "" if out == PackedInt32Array([1, 1, 0, 0]) else str(out)


func test_a_condition_of_nonsense_is_wrong() -> String:
	for tree: Variant in [null, [], [1], ["and"], ["<", 1.0], ["once", 0.0], {"a": 1}]:
		if not Condition.new(tree).wrong:
			return str(tree)
	return ""


func test_the_gap_between_cars_in_a_row_is_between_their_bumpers() -> String:
	var one := Outline.new(Vector2(0, 0), 0.0, 4.5, 1.8)
	var other := Outline.new(Vector2(10, 0), PI, 4.5, 1.8)
	if absf(one.gap(other) - 5.5) > 1e-5:
		return "gap %f" % one.gap(other)
	var near := Outline.new(Vector2(4, 0), 0.3, 4.5, 1.8)
	return "" if one.gap(near) == 0.0 else "overlap"
