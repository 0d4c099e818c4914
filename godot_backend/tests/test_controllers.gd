extends RefCounted
## The controllers decide as the table says that Python's decide as well.

const Agent := preload("../agents/agent.gd")
const Driver := preload("../agents/driver.gd")
const PathLine := preload("../agents/path_line.gd")
const Vehicle := preload("../agents/vehicle.gd")
## The engine has curvature from chords, Python from headings: bends begin a little apart.
const CLOSE := 0.02
const CLOSE_ACCELERATION := 0.4


func test_controllers_decide_as_the_shared_table_says() -> String:
	var folder: String = (get_script() as Script).resource_path.get_base_dir()
	var file := FileAccess.get_file_as_string(folder.path_join("controller_cases.json"))
	var table: Dictionary = JSON.parse_string(file)
	var line := PathLine.new()
	line.half_width = 4.0
	for point: Array in table["path"]:
		line.add(point[0], point[1])
	for case: Dictionary in table["cases"]:
		var wrong := _wrong(case, line)
		if not wrong.is_empty():
			return "%s %s in %s: %s" % [case["kind"], case["options"], case["state"], wrong]
	return "" if table["cases"].size() > 30 else "only %d cases" % table["cases"].size()


func _wrong(case: Dictionary, line: PathLine) -> String:
	var state: Array = case["state"]
	var agent := Agent.new()
	agent.body = Vehicle.new()
	(agent.body as Vehicle).wheelbase = 2.7
	agent.path = line
	agent.x = case["pose"][0]
	agent.y = case["pose"][1]
	agent.heading = case["pose"][2]
	agent.speed = state[3]
	agent.station = line.station(line.nearest(agent.x, agent.y), agent.x, agent.y)
	agent.cross_track_error = state[1]
	var signals := func(name: String, _names: Array[String]) -> float:
		var known: Variant = state[4] if name == "gap_ahead" else state[5]
		return INF if known == null else known
	var controller: Variant = Driver.KINDS[case["kind"]].new()
	controller.take(case["options"])
	var found: Vector2 = controller.command(agent, signals, 0.1)
	agent.body.free()
	agent.free()
	var expected: Array = case["control"]
	var steers: bool = expected[0] != null
	if steers == is_nan(found.x) or (steers and absf(found.x - expected[0]) > CLOSE):
		return "steering %f, not %s" % [found.x, expected[0]]
	if absf(found.y - expected[1]) > CLOSE_ACCELERATION:
		return "acceleration %f, not %s" % [found.y, expected[1]]
	return ""
