extends "controller.gd"
## Keeps a time gap to whoever is next in its lane: the Intelligent Driver Model (Treiber et al.
## 2000).

const HARDEST := 9.0

var _speed := 0.0
var _headway := 0.0
var _gap := 0.0


func read() -> void:
	max_acceleration = number("acceleration", 1.5)
	max_deceleration = number("deceleration", 2.0)
	_speed = number("speed", 50.0 / 3.6)
	_headway = number("headway", 1.5)
	_gap = number("gap", 2.0)


func command(agent: Agent, signals: Callable, _dt: float) -> Vector2:
	var names: Array[String] = [agent.agent_name]
	var gap: float = signals.call("gap_ahead", names)
	var target := bend_speed(agent, _speed)
	var free := 1.0 - pow(maxf(agent.speed, 0.0) / maxf(target, 0.1), 4.0)
	var pull := 0.0
	if is_finite(gap):
		var closing: float = agent.speed - signals.call("speed_ahead", names)
		var braking := agent.speed * closing / (2.0 * sqrt(max_acceleration * max_deceleration))
		var wanted := _gap + maxf(0.0, agent.speed * _headway + braking)
		pull = pow(wanted / maxf(gap, 0.1), 2.0)
	var acceleration := clampf(max_acceleration * (free - pull), -HARDEST, max_acceleration)
	# The model brakes too little where the target falls: before bends.
	if agent.speed > target:
		acceleration = minf(acceleration, toward(agent, target))
	return Vector2(along_line(agent), acceleration)
