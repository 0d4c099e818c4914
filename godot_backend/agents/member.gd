extends RefCounted
## An agent that takes part in a run: where it is built, what drives it, how fast it was.

const Stage := preload("../build/stage.gd")
const Agent := preload("agent.gd")
const Command := preload("command.gd")
const Signals := preload("signals.gd")
const Vehicle := preload("vehicle.gd")
const Walker := preload("walker.gd")

const END_BRAKING := 4.0

var world := 0
var agent: Agent
var stage: Stage
var signals: Signals
var surfaces := PackedVector2Array()
## Steering angle and acceleration that are wanted.
var wanted := Vector2.ZERO
## What a human who drives it wants, for the client to say again in its next step.
var wish := Vector2.ZERO
## Over the ground (x east, y north) before the last physics step.
var velocity_before := Vector2.ZERO

## What a client says; nothing, where it drives itself.
var _told := Command.new()
## Where it was when its place was sent: x, y, heading.
var _from := Vector3.ZERO


func _init(of_world: int, one: Agent, built_on: Stage) -> void:
	world = of_world
	agent = one
	stage = built_on


## Back to the start of a run.
func reset() -> void:
	_told = Command.new()
	wanted = Vector2.ZERO
	agent.follow(stage.path(agent.path_id))
	agent.start_station()
	agent.reset(surfaces)
	_leave(false)
	velocity_before = agent.body.ground_velocity()


## Looks at what a human wants, once for a step that takes `dt`.
func ask_human(time: float, dt: float) -> void:
	if agent.driver.is_by_hand:
		wish = agent.driver.controls(agent, signals.value, time, dt)


## Whether a client says what it is to do.
func is_told() -> bool:
	return _told.form != Command.Form.NOTHING


## Looks where it is, `dt` after it was last looked at.
func observe(dt: float) -> void:
	agent.observe(dt)
	agent.follow(stage.path(agent.path_id))
	if is_told():
		# The client looks for it by itself; a script of the game may ask for it.
		agent.forget_station()
	else:
		agent.find_station()


## From now on a client says what it is to do.
func obey(command: Command) -> void:
	_told = command
	_from = Vector3(agent.x, agent.y, agent.heading)
	var steers := command.form == Command.Form.STEER or command.form == Command.Form.LEAVE
	wanted = Vector2(command.angle, command.pull) if steers else Vector2.ZERO


## Moves on by one tick; `share` of the present step will then be over.
func act(time: float, dt: float, share: float) -> void:
	velocity_before = agent.body.ground_velocity()
	match _told.form:
		Command.Form.NOTHING:
			wanted = agent.driver.controls(agent, signals.value, time, dt)
			# There is no road any more.
			var arrived := agent.at_end() and not agent.path.closed
			if arrived:
				wanted.y = minf(wanted.y, -END_BRAKING)
			_leave(arrived and agent.traveled > Agent.ARRIVED)
			agent.body.command(wanted.x, wanted.y, dt)
		Command.Form.STEER, Command.Form.LEAVE:
			_leave(_told.form == Command.Form.LEAVE)
			agent.body.command(wanted.x, wanted.y, dt)
		Command.Form.FACE:
			if agent.body is Walker:
				(agent.body as Walker).turn(_told.angle)
			agent.body.command(0.0, _told.pull, dt)
		Command.Form.POSE:
			_go_to_place(minf(share, 1.0), dt)


## Who has left is not seen or touched; who comes back is.
func _leave(leaves: bool) -> void:
	if leaves == agent.has_left:
		return
	agent.has_left = leaves
	agent.body.visible = not leaves
	agent.body.be_present(not leaves)


## Who has touched something is moved by physics, and brakes.
func _go_to_place(share: float, dt: float) -> void:
	if agent.contacts > 0:
		agent.body.let_go()
		agent.body.command(0.0, -END_BRAKING, dt)
		return
	var at := Vector2(_from.x, _from.y).lerp(_told.place, share)
	var heading := _from.z + share * angle_difference(_from.z, _told.angle)
	agent.body.carry(Vector3(at.x, 0.0, -at.y), heading, dt)
