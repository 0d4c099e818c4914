extends RefCounted
## A `when:` of the language, evaluated step by step: drive signals and operators on the past.
##
## Written as nested lists: ["and", f, g], ["any", low, high, f], ["<", t, u], ["speed", "ego"].
## ["all", low, high, f]: f at all samples of the window [now - high, now - low]; "any": at one.

const Condition := preload("condition.gd")

const MAX_DEPTH := 40
const LOGIC: Array[String] = ["and", "or", "not"]
const WINDOWS: Array[String] = ["all", "any", "since"]
const COMPARISONS: Array[String] = ["<", "<=", ">", ">=", "==", "!="]
const ARITHMETIC: Array[String] = ["+", "-", "*", "/", "abs", "min", "max", "negate"]

var wrong := false
var tree: Variant

var _head := ""
var _value := 0.0
var _names: Array[String] = []
var _parts: Array[Condition] = []
var _low := 0.0
var _high := INF
var _latched := false
var _history: Array[Moment] = []


## What the first and the last part of a window were at a time.
class Moment:
	extends RefCounted
	var time: float
	var first: bool
	var last: bool

	func _init(at: float, first_part: bool, last_part: bool) -> void:
		time = at
		first = first_part
		last = last_part


func _init(of: Variant, depth: int = 0) -> void:
	tree = of
	if tree is bool:
		_head = "number"
		_value = 1.0 if tree else 0.0
	elif tree is float and is_finite(tree):
		_head = "number"
		_value = tree
	elif tree is Array and not (tree as Array).is_empty() and tree[0] is String:
		_read(tree, depth)
	else:
		wrong = true


func reset() -> void:
	_latched = false
	_history.clear()
	for part in _parts:
		part.reset()


## Whether this has come true by now.
func step(signals: Callable, time: float) -> bool:
	_latched = value(signals, time) > 0.5 or _latched
	return _latched


## The value now: a number, or 1 and 0 for true and false.
func value(signals: Callable, time: float) -> float:
	if _head == "number":
		return _value
	if LOGIC.has(_head):
		return _logic(signals, time)
	if WINDOWS.has(_head):
		return _window(signals, time)
	if _head == "time":
		return time
	if _parts.is_empty():
		return signals.call(_head, _names)
	return _compute(signals, time)


func _read(tree: Array, depth: int) -> void:
	_head = tree[0]
	wrong = depth > MAX_DEPTH
	var rest := tree.slice(1)
	if WINDOWS.has(_head):
		if rest.size() < 3 or not rest[0] is float:
			wrong = true
			return
		_low = rest[0]
		_high = rest[1] if rest[1] is float else INF
		rest = rest.slice(2)
	var is_operator := (
		LOGIC.has(_head) or WINDOWS.has(_head) or COMPARISONS.has(_head) or ARITHMETIC.has(_head)
	)
	for part: Variant in rest:
		if wrong:
			return
		if is_operator:
			var inner := Condition.new(part, depth + 1)
			_parts.append(inner)
			wrong = wrong or inner.wrong
		else:
			_names.append(str(part))
	wrong = wrong or (is_operator and _parts.size() < _least_parts())


func _least_parts() -> int:
	return 1 if _head in ["and", "or", "not", "abs", "negate", "all", "any"] else 2


func _logic(signals: Callable, time: float) -> float:
	# Every part is evaluated at every step: what lies in the past is remembered there.
	var truths: Array[bool] = []
	for part in _parts:
		truths.append(part.value(signals, time) > 0.5)
	match _head:
		"and":
			return float(not truths.has(false))
		"or":
			return float(truths.has(true))
		_:
			return float(not truths[0])


func _window(signals: Callable, time: float) -> float:
	var last := _parts[_parts.size() - 1].value(signals, time) > 0.5
	var first := _parts[0].value(signals, time) > 0.5 if _parts.size() > 1 else true
	_history.append(Moment.new(time, first, last))
	while not _history.is_empty() and _history[0].time < time - _high - 1e-9:
		_history.pop_front()
	if _head == "since":
		return float(_since(time))
	for moment in _history:
		if moment.time <= time - _low + 1e-9 and moment.last == (_head == "any"):
			return float(_head == "any")
	return float(_head == "all")


func _since(time: float) -> bool:
	for i in range(_history.size() - 1, -1, -1):
		var moment := _history[i]
		if moment.last and moment.time <= time - _low + 1e-9:
			return true
		if not moment.first:
			return false
	return false


func _compute(signals: Callable, time: float) -> float:
	var a := _parts[0].value(signals, time)
	var b := _parts[1].value(signals, time) if _parts.size() > 1 else 0.0
	match _head:
		"<":
			return float(a < b)
		"<=":
			return float(a <= b)
		">":
			return float(a > b)
		">=":
			return float(a >= b)
		"==":
			return float(a == b)
		"!=":
			return float(a != b)
		"+":
			return _number(a + b)
		"-":
			return _number(a - b)
		"*":
			return _number(a * b)
		"/":
			return _quotient(a, b)
		"abs":
			return absf(a)
		"min", "max":
			return _extreme(signals, time, a)
		_:
			return -a


## Of a zero divisor infinity with the sign of `a`; 0 / 0 is 0.
func _quotient(a: float, b: float) -> float:
	return _number(a / b if b != 0.0 else a * INF)


## Equal infinities are 0 apart, and 0 times one is 0.
func _number(result: float) -> float:
	return 0.0 if is_nan(result) else result


func _extreme(signals: Callable, time: float, first: float) -> float:
	for i in range(1, _parts.size()):
		var next := _parts[i].value(signals, time)
		first = minf(first, next) if _head == "min" else maxf(first, next)
	return first
