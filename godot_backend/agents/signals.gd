extends RefCounted
## The drive signals of one world, by name: what conditions and car following speak of.

const Agent := preload("agent.gd")
const Outline := preload("outline.gd")

## Meters: cars are beside each other rather than behind one another, from here on.
const SAME_LANE := 2.0
## Meters to each side between two that pass each other, and seconds of the speed that are more.
const MARGIN := 0.15
const CLEARANCE := 0.03


## Free road ahead, and how fast goes whoever is next.
class Ahead:
	var gap := INF
	var speed := 0.0


var _agents: Array[Agent] = []
## Where the search for an agent on the path of another begins.
var _segments: Dictionary = {}


func _init(agents: Array[Agent]) -> void:
	_agents = agents


## The value of a signal; of a group, that of its first or nearest member. Unknown: infinity.
func value(signal_name: String, names: Array[String]) -> float:
	var some := _named(names[0]) if not names.is_empty() else [] as Array[Agent]
	if some.is_empty():
		return INF
	var first := some[0]
	match signal_name:
		"distance", "gap":
			return _between(signal_name, some, names)
		"gap_ahead":
			return _ahead(first).gap
		"speed_ahead":
			return _ahead(first).speed
		"progress":
			return first.progress()
		"steering":
			return first.body.steer_angle()
		"contacts":
			return first.contacts
		"lateral_acceleration":
			return first.speed * first.yaw_rate
		"speed", "acceleration", "cross_track_error", "station", "heading", "yaw_rate", "jerk":
			return first.get(signal_name)
	return INF


func _named(agent_name: String) -> Array[Agent]:
	var out: Array[Agent] = []
	for agent in _agents:
		if agent.agent_name == agent_name or agent.agent_name.begins_with(agent_name + "["):
			out.append(agent)
	return out


## Least distance of middles or outlines to another group, or to an object that stands still:
## its x, y, heading, length and width.
func _between(what: String, some: Array[Agent], names: Array[String]) -> float:
	var others: Array[Outline] = []
	if names.size() == 6:
		others.append(
			Outline.new(
				Vector2(names[1].to_float(), names[2].to_float()),
				names[3].to_float(),
				names[4].to_float(),
				names[5].to_float()
			)
		)
	elif names.size() == 2:
		for agent in _named(names[1]):
			if not agent.has_left:
				others.append(_outline(agent))
	var least := INF
	for agent in some:
		if agent.has_left:
			continue
		var outline := _outline(agent)
		for other in others:
			var away := outline.gap(other) if what == "gap" else outline.distance(other)
			least = minf(least, away)
	return least


## Free road to whoever is next in the same lane, and how fast they go.
func _ahead(agent: Agent) -> Ahead:
	var out := Ahead.new()
	if agent.path == null:
		return out
	for other in _agents:
		if other == agent or other.has_left:
			continue
		var place := _on_path_of(agent, other)
		var between := agent.direction * (place.x - agent.station)
		if agent.path.closed:
			between = fposmod(between, agent.path.length)
		var beside := place.y - agent.line_offset(place.x)
		var gap := between - 0.5 * (agent.size().x + other.size().x)
		if between > 0.0 and absf(beside) < _in_the_way(agent, other) and gap < out.gap:
			out.gap = gap
			out.speed = other.speed * cos(other.heading - agent.heading)
	return out


## How far beside the line of an agent another is in its way: who crawls passes closer.
func _in_the_way(agent: Agent, other: Agent) -> float:
	var between := 0.5 * (agent.size().z + other.size().z) + MARGIN
	return maxf(minf(between + CLEARANCE * agent.speed, SAME_LANE), between)


## Station and offset of another agent on the path of this one.
func _on_path_of(agent: Agent, other: Agent) -> Vector2:
	if other.path == agent.path:
		var offset := other.line_offset(other.station)
		return Vector2(other.station, other.direction * other.cross_track_error + offset)
	var pair := Vector2i(agent.id, other.id)
	var segment := agent.path.nearest(other.x, other.y, _segments.get(pair, -1))
	_segments[pair] = segment
	return Vector2(
		agent.path.station(segment, other.x, other.y), agent.path.offset(segment, other.x, other.y)
	)


func _outline(agent: Agent) -> Outline:
	var size := agent.size()
	return Outline.new(Vector2(agent.x, agent.y), agent.heading, size.x, size.z)
