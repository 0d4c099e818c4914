extends Node
## The worlds of this engine: the first is shown; each has a physics space of its own.

const Protocol := preload("../net/protocol.gd")
const Stage := preload("stage.gd")

## World number to `Stage`.
var stages: Dictionary = {}
## Whether the first world also gets a physics space without a past. A game keeps its own.
var fresh_spaces := true

var _holders: Dictionary = {}
var _before: World3D


## An empty world in place of what was there, with a physics space that has no past.
func begin(world: int, title: String, extent: float) -> void:
	drop(world)
	var stage := Stage.new()
	if world == 0:
		if fresh_spaces:
			_refresh_space()
		add_child(stage)
	else:
		var holder := SubViewport.new()
		holder.own_world_3d = true
		holder.size = Vector2i(2, 2)
		holder.render_target_update_mode = SubViewport.UPDATE_DISABLED
		holder.add_child(stage)
		add_child(holder)
		_holders[world] = holder
	stages[world] = stage
	stage.begin(title, extent)


func _refresh_space() -> void:
	# The old world must outlive the change: the viewport still says goodbye to it.
	var root := get_tree().root
	_before = root.find_world_3d()
	root.world_3d = World3D.new()


func drop(world: int) -> void:
	if not stages.has(world):
		return
	var stage: Stage = stages[world]
	stages.erase(world)
	if _holders.has(world):
		(_holders[world] as SubViewport).free()
		_holders.erase(world)
	else:
		stage.free()


func stage(world: int) -> Stage:
	return stages.get(world)
