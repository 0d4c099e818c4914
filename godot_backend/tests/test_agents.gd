extends RefCounted
## Paths, conditions and outlines.

const PathLine := preload("../agents/path_line.gd")
const Condition := preload("../agents/condition.gd")
const Outline := preload("../agents/outline.gd")
const Agent := preload("../agents/agent.gd")


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


func test_counts_are_exact_and_bounded() -> String:
	# Numbers of JSON are floats.
	var cases := {3600000.0: 3600000, 4294967295.0: 4294967295, 4294967296.0: 7, -1.0: 7, NAN: 7}
	for given: float in cases:
		var found := Agent.count({"ticks": given}, "ticks", 7)
		if found != cases[given]:
			return "%f is taken as %d" % [given, found]
	return "" if Agent.count({"ticks": "many"}, "ticks", 7) == 7 else "text is a count"


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


func test_conditions_come_true_as_the_shared_table_says() -> String:
	var folder: String = (get_script() as Script).resource_path.get_base_dir()
	var file := FileAccess.get_file_as_string(folder.path_join("when_cases.json"))
	var table: Array = JSON.parse_string(file)
	for case: Dictionary in table:
		var condition := Condition.new(case["tree"])
		if condition.wrong:
			return "cannot read %s" % case["formula"]
		var found := _truth_of(condition, case)
		if found != case["truth"]:
			return "%s: %s" % [case["formula"], found]
	return "" if table.size() > 20 else "only %d cases" % table.size()


## Whether a condition holds at each moment of a case.
func _truth_of(condition: Condition, case: Dictionary) -> Array:
	var out := []
	for i in (case["time"] as Array).size():
		var signals := func(name: String, _names: Array[String]) -> float:
			return case["signals"][name][i]
		out.append(condition.value(signals, case["time"][i]) > 0.5)
	return out


func test_a_condition_of_nonsense_is_wrong() -> String:
	for tree: Variant in [null, [], [1], ["and"], ["<", 1.0], ["any", 0.0], {"a": 1}]:
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


func test_a_place_is_found_after_laps_in_which_nobody_asked() -> String:
	var agent := Agent.new()
	agent.x = 40.0
	agent.follow(_circle(40.0))
	var wrong := ""
	var driven := 0.0
	for angle: float in [0.0, 10.0, 300.0, 1000.0, 990.0]:
		agent._way += deg_to_rad(angle) * 40.0 - driven
		driven = deg_to_rad(angle) * 40.0
		agent.x = 40.0 * cos(driven / 40.0)
		agent.y = 40.0 * sin(driven / 40.0)
		agent.forget_station()
		var apart := absf(angle_difference(agent.station / 40.0, driven / 40.0))
		if apart > 1e-3 or absf(agent.traveled - driven) > 0.1:
			wrong = "%f traveled, %f apart at %f" % [agent.traveled, apart, angle]
	agent.free()
	return wrong


func test_a_place_near_a_crossing_of_its_own_line_is_on_the_way_that_was_driven() -> String:
	var line := PathLine.new()
	for corner: Vector2 in [Vector2(0, 0), Vector2(80, 0), Vector2(80, 40), Vector2(40, 40)]:
		line.add(corner.x, corner.y)
	line.add(40.0, -60.0)
	var agent := Agent.new()
	agent.follow(line)
	agent.x = 39.9
	agent.y = 1.0
	agent._way = 40.0
	agent.forget_station()
	var found := agent.station
	agent.free()
	return "" if absf(found - 39.9) < 1e-3 else "at %f" % found
