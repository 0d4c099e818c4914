extends RefCounted
## Chooses who drives: the last controller whose `when` has come true and whose `while` holds.

const Driver := preload("driver.gd")
const Condition := preload("condition.gd")
const Controller := preload("controllers/controller.gd")

const KINDS: Dictionary = {
	"pure_pursuit": preload("controllers/pure_pursuit.gd"),
	"stanley": preload("controllers/stanley.gd"),
	"lane_follow": preload("controllers/lane_follow.gd"),
	"car_follow": preload("controllers/car_follow.gd"),
	"brake": preload("controllers/brake.gd"),
	"manual": preload("controllers/manual.gd"),
}
const MAX_CONTROLLERS := 32

## Index of the controller in charge, -1 for none.
var in_charge := -1

## Whether a human drives, at times at least.
var is_by_hand := false

var _controllers: Array[Controller] = []
## Of `when`, which stays true once it is, and of `while`; null for none.
var _conditions: Array[Condition] = []
var _limits: Array[Condition] = []


## Takes a list of {kind, when, while, ...options}; returns "" or what is wrong with it.
func take(drives: Array) -> String:
	if drives.size() > MAX_CONTROLLERS:
		return "too many controllers"
	for drive: Variant in drives:
		if not drive is Dictionary or not KINDS.has((drive as Dictionary).get("kind")):
			return "a controller that this engine does not have"
		var options: Dictionary = drive
		var controller: Controller = KINDS[options["kind"]].new()
		controller.take(options)
		_controllers.append(controller)
		is_by_hand = is_by_hand or options["kind"] == "manual"
		_conditions.append(_condition(options.get("when")))
		_limits.append(_condition(options.get("while")))
		for condition: Condition in [_conditions[-1], _limits[-1]]:
			if condition != null and condition.wrong:
				return "a condition that this engine cannot read"
	return ""


func reset() -> void:
	in_charge = -1
	for i in _controllers.size():
		_controllers[i].reset()
		for condition: Condition in [_conditions[i], _limits[i]]:
			if condition != null:
				condition.reset()


## Controllers and conditions that an edit left in their places remember what they did.
func go_on(earlier: RefCounted) -> void:
	var other := earlier as Driver
	in_charge = other.in_charge
	for i in mini(_controllers.size(), other._controllers.size()):
		if _controllers[i].get_script() == other._controllers[i].get_script():
			_controllers[i].go_on(other._controllers[i])
			_conditions[i] = _kept(_conditions[i], other._conditions[i])
			_limits[i] = _kept(_limits[i], other._limits[i])


## Steering angle and acceleration of this step; `signals` looks up what conditions speak of.
func controls(agent: Node3D, signals: Callable, time: float, dt: float) -> Vector2:
	in_charge = -1
	for i in _controllers.size():
		# Both are evaluated at every step: what lies in the past is remembered there.
		var begun := _conditions[i] == null or _conditions[i].step(signals, time)
		var goes_on := _limits[i] == null or _limits[i].value(signals, time) > 0.5
		if begun and goes_on:
			in_charge = i
	if in_charge < 0:
		return Vector2(0.0, -4.0)
	var wanted := _controllers[in_charge].command(agent, signals, dt)
	if is_nan(wanted.x):
		wanted.x = _kept_steering(agent, signals, dt)
	return wanted


## A condition that has not changed, with what it has seen, else the new one.
static func _kept(now: Condition, before: Condition) -> Condition:
	var same: bool = now != null and before != null and now.tree == before.tree
	return before if same else now


static func _condition(tree: Variant) -> Condition:
	return null if tree == null else Condition.new(tree)


## A controller that does not steer leaves that to the last one before it that does.
func _kept_steering(agent: Node3D, signals: Callable, dt: float) -> float:
	for i in range(in_charge - 1, -1, -1):
		var steer := _controllers[i].command(agent, signals, dt).x
		if not is_nan(steer):
			return steer
	return 0.0
