extends "res://agents/controllers/controller.gd"
## Keeps a time gap to another agent: the Intelligent Driver Model (Treiber et al. 2000).

var _speed := 0.0
var _leader := ""
var _time_gap := 0.0
var _least_gap := 0.0
var _comfort := 0.0


func read() -> void:
	_speed = number("speed", 10.0)
	_leader = str(_options.get("leader", ""))
	_time_gap = number("time_gap", 1.5)
	_least_gap = number("min_gap", 2.0)
	_comfort = number("comfortable_deceleration", 2.0)


func command(agent: Agent, signals: Callable, _dt: float) -> Vector2:
	var reach := clampf(0.6 * agent.speed, 4.0, 20.0)
	var names: Array[String] = [agent.agent_name, _leader]
	var lead_names: Array[String] = [_leader]
	var gap: float = signals.call("gap", names)
	var free := 1.0 - pow(maxf(agent.speed, 0.0) / maxf(_speed, 0.1), 4.0)
	var pull := 0.0
	if is_finite(gap):
		var closing: float = agent.speed - signals.call("speed", lead_names)
		var braking := agent.speed * closing / (2.0 * sqrt(max_acceleration * _comfort))
		var wanted := _least_gap + maxf(0.0, agent.speed * _time_gap + braking)
		pull = pow(wanted / maxf(gap, 0.1), 2.0)
	var acceleration := clampf(
		max_acceleration * (free - pull), -max_deceleration, max_acceleration
	)
	return Vector2(pursuit(agent, reach), acceleration)
