extends RefCounted
## Drives all agents of all worlds, tick by tick: freely, or one step at a client's word.

enum Mode { IDLE, FREE, LOCKSTEP }

const Protocol := preload("res://net/protocol.gd")
const Reader := preload("res://net/reader.gd")
const Server := preload("res://net/server.gd")
const Stage := preload("res://build/stage.gd")
const Agent := preload("res://agents/agent.gd")
const Vehicle := preload("res://agents/vehicle.gd")
const Signals := preload("res://agents/signals.gd")
const Telemetry := preload("res://agents/telemetry.gd")
const Weather := preload("res://build/weather.gd")
const TrafficSignals := preload("res://build/signals.gd")

const DEFAULT_FRICTION := 0.9
const END_BRAKING := 4.0
const FLUSH_BYTES := 7000
const FLUSH_USEC := 50000
## A state is told again this often while no step comes: either may have been lost.
const STATE_EVERY_USEC := 20000
## A step that comes this soon is not slept through.
const SPIN_USEC := 400

## Called again and again while a step is waited for.
var while_waiting: Callable
var mode := Mode.IDLE
var tick := 0

var _server: Server
var _stages: Dictionary
var _cast: Array[Array] = []
var _traffic_signals: Array[TrafficSignals] = []
var _last_tick := 0
var _every := 1
var _stop_at_end := false
var _hold_until := 0
var _trace := PackedByteArray()
var _flushed := 0
var _recorded := 0


func _init(server: Server, stages: Dictionary) -> void:
	_server = server
	_stages = stages


func running() -> bool:
	return mode != Mode.IDLE


## Begins a run as a RUN message asks; returns "" or what is wrong.
func start(settings: Dictionary) -> String:
	var wanted: Variant = settings.get("mode", "free")
	if not wanted in ["free", "lockstep"]:
		return "a run is free or lockstep"
	_last_tick = int(Agent.number(settings, "ticks", 0.0))
	_every = maxi(1, int(Agent.number(settings, "every", 1.0)))
	_stop_at_end = settings.get("stop_at_end", false) == true
	tick = 0
	_hold_until = 0
	_trace.clear()
	_recorded = 0
	mode = Mode.FREE if wanted == "free" else Mode.LOCKSTEP
	_gather()
	for part in _cast:
		var agent: Agent = part[1]
		agent.follow(part[3].path(agent.path_id))
		agent.start_station()
		agent.reset(part[4])
	return ""


## Takes agents that came or changed while the run goes on.
func refresh() -> void:
	if mode == Mode.IDLE:
		return
	var known: Dictionary = {}
	for part in _cast:
		known[part[1]] = true
	_gather()
	for part in _cast:
		var agent: Agent = part[1]
		if not known.has(agent):
			agent.follow(part[3].path(agent.path_id))
			agent.start_station()
			agent.reset(part[4])
		else:
			agent.body.set_friction(part[4])


func stop(reason: String, more: Dictionary = {}) -> void:
	if mode == Mode.IDLE:
		return
	mode = Mode.IDLE
	_flush()
	for part in _cast:
		var agent: Agent = part[1]
		if is_instance_valid(agent) and agent.body is Vehicle:
			(agent.body as Vehicle).freeze = true
	var done := {"tick": tick, "reason": reason, "records": _recorded}
	done.merge(more)
	_server.send_json(Protocol.DONE, done)


## One physics step: look, tell, decide, act.
func step(dt: float) -> void:
	if mode == Mode.IDLE:
		return
	for lights in _traffic_signals:
		if is_instance_valid(lights):
			lights.show_at(tick * dt)
	for part in _cast:
		var agent: Agent = part[1]
		agent.follow(part[3].path(agent.path_id))
		agent.observe(dt)
	if mode == Mode.LOCKSTEP and tick >= _hold_until:
		_await_step()
	elif mode == Mode.FREE and tick % _every == 0:
		_trace.append_array(_records())
		_recorded += _cast.size()
		if _trace.size() > FLUSH_BYTES or Time.get_ticks_usec() - _flushed > FLUSH_USEC:
			_flush()
	if mode == Mode.IDLE:
		return
	# Only where a record was made, so that the trace holds the arrival.
	var arrived := _stop_at_end and tick % _every == 0 and _all_at_end()
	if arrived or (_last_tick > 0 and tick >= _last_tick):
		stop("end" if arrived else "time")
		return
	_act(dt)
	if mode != Mode.IDLE:
		tick += 1


## Takes a STEP: for how many ticks to hold which controls. Old ones are answered again.
func take_step(payload: PackedByteArray) -> String:
	var reader := Reader.new(payload)
	var at := reader.u32()
	var ticks := reader.u16()
	var count := reader.u16()
	if mode != Mode.LOCKSTEP:
		return "" if at < tick else "no run in lock-step"
	if at != tick or _hold_until > tick:
		return ""
	for i in count:
		var world := reader.u16()
		var id := reader.u16()
		var steer := reader.f32(10.0)
		var acceleration := reader.f32(1000.0)
		for part in _cast:
			if part[0] == world and part[1].id == id and not reader.failed:
				part[1].driver.drive_from_outside(steer, acceleration)
	if not reader.at_end() or ticks < 1:
		return "bad step"
	_hold_until = tick + ticks
	return ""


func agent(world: int, id: int) -> Agent:
	for part in _cast:
		if part[0] == world and part[1].id == id:
			return part[1]
	return null


func _gather() -> void:
	_cast.clear()
	_traffic_signals.clear()
	var worlds: Array = _stages.keys()
	worlds.sort()
	for world: int in worlds:
		var stage: Stage = _stages[world]
		var agents := stage.agents()
		var signals := Signals.new(agents)
		var friction := DEFAULT_FRICTION
		for lights in stage.all(Protocol.SIGNALS):
			_traffic_signals.append(lights as TrafficSignals)
		for weather in stage.all(Protocol.WORLD):
			friction = (weather as Weather).friction
		for one in agents:
			_cast.append([world, one, signals, stage, friction])


func _await_step() -> void:
	var sent := 0
	var began := Time.get_ticks_usec()
	while mode == Mode.LOCKSTEP and tick >= _hold_until:
		var now := Time.get_ticks_usec()
		if now - sent > STATE_EVERY_USEC:
			_server.send_once(Protocol.STATE, _header() + _records())
			sent = now
		if not _server.poll(false) and now - began > SPIN_USEC:
			OS.delay_usec(50)
		while_waiting.call()
		if not _server.connected():
			stop("client gone")


func _act(dt: float) -> void:
	var time := tick * dt
	for part in _cast:
		var one: Agent = part[1]
		var signals: Signals = part[2]
		var wanted := one.driver.controls(one, signals.value, time, dt)
		# There is no road any more.
		if one.at_end() and not one.path.closed:
			wanted.y = minf(wanted.y, -END_BRAKING)
		one.body.command(wanted.x, wanted.y, dt)
		part.resize(6)
		part[5] = wanted


func _records() -> PackedByteArray:
	var out := PackedByteArray()
	for part in _cast:
		var wanted: Vector2 = part[5] if part.size() > 5 else Vector2.ZERO
		out.append_array(Telemetry.record(part[1], tick, part[0], wanted))
	return out


func _header() -> PackedByteArray:
	var head := PackedByteArray()
	head.resize(Telemetry.HEADER_BYTES)
	head.encode_u32(0, tick)
	head.encode_u32(4, int(_all_at_end()))
	return head


func _flush() -> void:
	_flushed = Time.get_ticks_usec()
	var most := FLUSH_BYTES / Telemetry.RECORD_BYTES * Telemetry.RECORD_BYTES
	for from in range(0, _trace.size(), most):
		_server.send(Protocol.TRACE, _trace.slice(from, from + most))
	_trace.clear()


func _all_at_end() -> bool:
	for part in _cast:
		if part[1].path != null and not part[1].at_end():
			return false
	return not _cast.is_empty()
