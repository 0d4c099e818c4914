extends RefCounted
## Drives all agents of all worlds, tick by tick: freely, or one step at a client's word.

signal begun
signal ended(reason: String)

enum Mode { IDLE, FREE, LOCKSTEP }

const Protocol := preload("../net/protocol.gd")
const Reader := preload("../net/reader.gd")
const Server := preload("../net/server.gd")
const Stage := preload("../build/stage.gd")
const Objects := preload("../build/objects.gd")
const Agent := preload("agent.gd")
const Contacts := preload("contacts.gd")
const Command := preload("command.gd")
const Member := preload("member.gd")
const Signals := preload("signals.gd")
const Telemetry := preload("telemetry.gd")
const Weather := preload("../build/weather.gd")
const TrafficSignals := preload("../build/signals.gd")

const DEFAULT_FRICTION := 0.9
const FLUSH_BYTES := 7000
const FLUSH_USEC := 50000
## A state is sent again this often while no step comes: either may have been lost.
const STATE_EVERY_USEC := 20000
## A step is looked for this often at first, and less often the longer it does not come.
const POLL_USEC := 30
const LONGEST_POLL_USEC := 2000

## Called again and again while a step is waited for.
var while_waiting: Callable
var mode := Mode.IDLE
var tick := 0

var _server: Server
var _stages: Dictionary
var _members: Array[Member] = []
## By world << 16 | agent.
var _by_key: Dictionary = {}
var _contacts := Contacts.new()
var _traffic_signals: Array[TrafficSignals] = []
var _weathers: Array[Weather] = []
var _last_tick := 0
var _every := 1
var _stop_at_end := false
## When agents were last looked at.
var _looked := 0
var _hold_from := 0
var _hold_until := 0
var _trace := PackedByteArray()
var _flushed := 0
var _recorded := 0
## Nothing is drawn while a step is waited for.
var _is_unseen := DisplayServer.get_name() == "headless"


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
	_last_tick = Agent.count(settings, "ticks", 0)
	_every = maxi(1, Agent.count(settings, "every", 1))
	_stop_at_end = Agent.flag(settings, "stop_at_end")
	tick = 0
	_looked = 0
	_hold_from = 0
	_hold_until = 0
	_trace.clear()
	_recorded = 0
	_members.clear()
	_gather()
	if wanted == "lockstep" and _members.size() > Telemetry.MOST_IN_A_STATE:
		return "lock-step takes at most %d agents" % Telemetry.MOST_IN_A_STATE
	mode = Mode.FREE if wanted == "free" else Mode.LOCKSTEP
	_contacts.clear()
	for stage: Stage in _stages.values():
		for objects in stage.all(Protocol.OBJECTS):
			(objects as Objects).reset()
	for member in _members:
		member.reset()
	begun.emit()
	return ""


## Takes agents that came or changed while the run goes on. Those that were not placed anew go on.
func refresh() -> void:
	if mode == Mode.IDLE:
		return
	var known := _members.duplicate()
	_gather()
	for member in _members:
		if known.has(member):
			member.agent.body.set_surfaces(member.surfaces)
		else:
			member.reset()


## Takes objects that came or changed while the run goes on.
func take_objects(stage: Stage, id: int) -> void:
	if mode == Mode.IDLE:
		return
	for objects in stage.all(Protocol.OBJECTS):
		if objects.id == id:
			(objects as Objects).reset()


## Ends the run of a client that is gone. Nothing is sent: who listens now asked for none of it.
func abandon() -> void:
	if mode == Mode.IDLE:
		return
	mode = Mode.IDLE
	_trace.clear()
	_rest()


func stop(reason: String, more: Dictionary = {}) -> void:
	if mode == Mode.IDLE:
		return
	mode = Mode.IDLE
	_flush()
	_rest()
	var done := {"tick": tick, "reason": reason, "records": _recorded, "contacts": _contacts.count}
	done.merge(more)
	_server.send_json(Protocol.DONE, done)
	ended.emit(reason)


func _rest() -> void:
	for stage: Stage in _stages.values():
		if is_instance_valid(stage):
			for objects in stage.all(Protocol.OBJECTS):
				(objects as Objects).rest()
	for member in _members:
		if is_instance_valid(member.agent):
			member.agent.body.rest()


## One physics step: look, tell, decide, act.
func step(dt: float) -> void:
	if mode == Mode.IDLE:
		return
	for weather in _weathers:
		if is_instance_valid(weather):
			weather.show_at(tick * dt)
	for lights in _traffic_signals:
		if is_instance_valid(lights):
			lights.show_at(tick * dt)
	# While commands are sent to all, nothing asks where they are before the next step.
	if tick >= _hold_until or not _are_all_told():
		var passed := maxi(1, tick - _looked) * dt
		_looked = tick
		for member in _members:
			member.observe(passed)
	_contacts.gather(_members, tick)
	if mode == Mode.LOCKSTEP and tick >= _hold_until:
		for member in _members:
			member.ask_human(tick * dt, maxi(1, _hold_until - _hold_from) * dt)
		_await_step()
	elif mode == Mode.FREE and tick % _every == 0:
		for member in _members:
			_trace.append_array(Telemetry.record(member, tick))
		_recorded += _members.size()
		if _trace.size() > FLUSH_BYTES or Time.get_ticks_usec() - _flushed > FLUSH_USEC:
			_flush()
	if mode == Mode.IDLE:
		return
	# Only where a record was made, so that the trace holds the arrival.
	var arrived := _stop_at_end and tick % _every == 0 and _all_at_end()
	if arrived or (_last_tick > 0 and tick >= _last_tick):
		stop("end" if arrived else "time")
		return
	var share := float(tick + 1 - _hold_from) / maxi(1, _hold_until - _hold_from)
	for member in _members:
		member.act(tick * dt, dt, share)
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
		# It is on its way: the client is not to take this engine for dead.
		_server.send_once(Protocol.PING, PackedByteArray())
		return ""
	for i in count:
		var key := reader.u16() << 16 | reader.u16()
		var command := Command.new()
		if not command.read(reader):
			return "bad step"
		var member: Member = _by_key.get(key)
		if member != null:
			member.obey(command)
	if not reader.at_end() or ticks < 1:
		return "bad step"
	_contacts.told(Telemetry.MOST_IN_A_STATE)
	_hold_from = tick
	_hold_until = tick + ticks
	return ""


func agent(world: int, id: int) -> Agent:
	var member: Member = _by_key.get(world << 16 | id)
	return null if member == null else member.agent


func _gather() -> void:
	var known := _by_key
	_members.clear()
	_by_key = {}
	_traffic_signals.clear()
	_weathers.clear()
	var worlds: Array = _stages.keys()
	worlds.sort()
	for world: int in worlds:
		var stage: Stage = _stages[world]
		var agents := stage.agents()
		var signals := Signals.new(agents)
		var surfaces := PackedVector2Array([Vector2(DEFAULT_FRICTION, 0.0)])
		for lights in stage.all(Protocol.SIGNALS):
			_traffic_signals.append(lights as TrafficSignals)
		for weather in stage.all(Protocol.WORLD):
			surfaces = (weather as Weather).surfaces
			_weathers.append(weather as Weather)
		for one in agents:
			var key := world << 16 | one.id
			var member: Member = known.get(key)
			if member != null and mode != Mode.IDLE and one.goes_on:
				member.agent = one
			elif member == null or member.agent != one or mode == Mode.IDLE:
				member = Member.new(world, one, stage)
			member.signals = signals
			member.surfaces = surfaces
			_members.append(member)
			_by_key[key] = member


func _await_step() -> void:
	var sent := 0
	var pause := POLL_USEC
	while mode == Mode.LOCKSTEP and tick >= _hold_until:
		if Time.get_ticks_usec() - sent > STATE_EVERY_USEC:
			_server.send_once(Protocol.STATE, Telemetry.state(_members, tick, _contacts.untold()))
			sent = Time.get_ticks_usec()
		var waited := _is_unseen and _server.wait()
		if not _server.poll(false) and not waited:
			OS.delay_usec(pause)
			pause = mini(pause + POLL_USEC, LONGEST_POLL_USEC)
		while_waiting.call()
		if not _server.connected():
			stop("client gone")


func _flush() -> void:
	_flushed = Time.get_ticks_usec()
	var most := FLUSH_BYTES / Telemetry.RECORD_BYTES * Telemetry.RECORD_BYTES
	for from in range(0, _trace.size(), most):
		_server.send(Protocol.TRACE, _trace.slice(from, from + most))
	_trace.clear()
	if mode == Mode.LOCKSTEP:
		return
	var told := Telemetry.contacts(_contacts.untold())
	most = FLUSH_BYTES / Telemetry.CONTACT_BYTES * Telemetry.CONTACT_BYTES
	for from in range(0, told.size(), most):
		_server.send(Protocol.CONTACTS, told.slice(from, from + most))
	_contacts.told(_contacts.count)


func _are_all_told() -> bool:
	for member in _members:
		if not member.is_told():
			return false
	return true


func _all_at_end() -> bool:
	var any_on_road := false
	for member in _members:
		if member.agent.path != null:
			any_on_road = true
			if not member.agent.at_end():
				return false
	return any_on_road
