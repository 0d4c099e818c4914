extends RefCounted
## Who touched whom or what first, when, and how fast one went relative to the other before.

const Agent := preload("agent.gd")
const Member := preload("member.gd")
const Touch := preload("touch.gd")
const Objects := preload("../build/objects.gd")


class Contact:
	var tick := 0
	var world := 0
	var agent := 0
	## The number of the other agent, or of the thing that holds the objects.
	var other := 0
	## Of the object in its thing, -1 for an agent.
	var index := -1
	var speed := 0.0


## Since the run began.
var count := 0

var _untold: Array[Contact] = []
var _known: Dictionary = {}


func clear() -> void:
	count = 0
	_untold.clear()
	_known.clear()


## What was not yet sent to the client.
func untold() -> Array[Contact]:
	return _untold


## The first ones were sent, at most so many.
func told(most: int) -> void:
	if not _untold.is_empty():
		_untold = _untold.slice(most)


## Takes what bodies have touched in the last physics step. Physics says it in any order: what one
## agent touched in the same step is put in the order of the numbers.
func gather(members: Array[Member], tick: int) -> void:
	for member in members:
		var before := _untold.size()
		for touch: Touch in member.agent.body.take_touched():
			if is_instance_valid(touch.body):
				_take(member, touch.body, touch.shape, members, tick)
		if _untold.size() > before + 1:
			var fresh := _untold.slice(before)
			fresh.sort_custom(_comes_before)
			_untold = _untold.slice(0, before) + fresh


func _take(member: Member, body: Node, index: int, members: Array[Member], tick: int) -> void:
	var holder := body.get_parent()
	var made := Contact.new()
	made.tick = tick
	made.world = member.world
	made.agent = member.agent.id
	if holder is Objects:
		made.other = (holder as Objects).id
		made.index = (holder as Objects).number_of(body, index)
		made.speed = member.velocity_before.length()
		if _is_new([made.world, made.agent, made.other, made.index]):
			_add(made, [member])
		return
	for other in members:
		if other.agent != holder:
			continue
		made.other = other.agent.id
		made.speed = member.velocity_before.distance_to(other.velocity_before)
		var low := mini(made.agent, made.other)
		if _is_new([made.world, low, maxi(made.agent, made.other), -1]):
			_add(made, [member, other])
		return


static func _comes_before(a: Contact, b: Contact) -> bool:
	return a.index < b.index if a.other == b.other else a.other < b.other


func _is_new(key: Array) -> bool:
	if _known.has(key):
		return false
	_known[key] = true
	return true


func _add(made: Contact, touching: Array) -> void:
	for member: Member in touching:
		member.agent.contacts += 1
	count += 1
	_untold.append(made)
