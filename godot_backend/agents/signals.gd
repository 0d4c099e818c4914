extends RefCounted
## The drive signals of one world, by name: what conditions and car following speak of.

const Agent := preload("res://agents/agent.gd")

## Beside each other rather than behind one another, from here on.
const SAME_LANE := 2.0

var _agents: Array[Agent] = []


func _init(agents: Array[Agent]) -> void:
	_agents = agents


## The value of a signal; of a group, that of its first or nearest member. Unknown: infinity.
func value(signal_name: String, names: Array[String]) -> float:
	if names.is_empty():
		return INF
	var first := _named(names[0])
	if first.is_empty():
		return INF
	match signal_name:
		"distance":
			return _distance(first, _named(names[1])) if names.size() > 1 else INF
		"distance_to":
			return _distance_to(first, names)
		"gap":
			return _gap(first[0], names[1] if names.size() > 1 else "")
		"progress":
			return first[0].progress()
		"steering":
			return first[0].body.steer_angle()
		"contacts":
			return first[0].body.touching
		"speed", "acceleration", "cross_track", "station", "heading", "x", "y":
			return first[0].get(signal_name)
	return INF


func _named(agent_name: String) -> Array[Agent]:
	var out: Array[Agent] = []
	for agent in _agents:
		if agent.agent_name == agent_name or agent.agent_name.begins_with(agent_name + "["):
			out.append(agent)
	return out


func _distance(some: Array[Agent], others: Array[Agent]) -> float:
	var least := INF
	for a in some:
		for b in others:
			if a != b:
				least = minf(least, Vector2(a.x, a.y).distance_to(Vector2(b.x, b.y)))
	return least


func _distance_to(some: Array[Agent], names: Array[String]) -> float:
	if names.size() < 3:
		return INF
	var place := Vector2(names[1].to_float(), names[2].to_float())
	var least := INF
	for a in some:
		least = minf(least, Vector2(a.x, a.y).distance_to(place))
	return least


## Free road to the leader, or without a name to whoever is next in the same lane.
func _gap(agent: Agent, leader: String) -> float:
	if agent.path == null:
		return INF
	var least := INF
	for other in _agents if leader.is_empty() else _named(leader):
		if other == agent:
			continue
		var segment := agent.path.nearest(other.x, other.y)
		var along := agent.path.station(segment, other.x, other.y) - agent.station
		var between := agent.direction * along
		if agent.path.closed:
			between = fposmod(between, agent.path.length)
		var beside := agent.path.offset(segment, other.x, other.y) - agent.line_offset
		if between > 0.0 and absf(beside) < SAME_LANE:
			least = minf(least, between - 0.5 * (_length(agent) + _length(other)))
	return least


func _length(agent: Agent) -> float:
	var size: Variant = agent.body.get("size")
	return (size as Vector3).x if size is Vector3 else 0.5
