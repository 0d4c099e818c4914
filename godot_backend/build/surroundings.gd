extends RefCounted
## What depends on where a camera is: rain and snow around it, and which lamps shine.

const Protocol := preload("../net/protocol.gd")
const Stage := preload("stage.gd")
const Weather := preload("weather.gd")
const Falling := preload("falling.gd")
const Lamp := preload("../shapes/lamp.gd")

## A renderer takes few lights at once: those nearest to the camera shine. Below
## `rendering/limits/opengl/max_renderable_lights` of the project.
const MOST_LAMPS := 48


## Prepares a world for a camera at a place; `shows_rain`: whether it sees what falls.
static func prepare(stage: Stage, eye: Vector3, shows_rain := true) -> void:
	var is_dark := false
	for weather in stage.all(Protocol.WORLD):
		is_dark = (weather as Weather).is_dark()
	for falling: Falling in stage.get_tree().get_nodes_in_group(Falling.GROUP):
		if stage.is_ancestor_of(falling):
			falling.follow(eye)
			falling.force_update_transform()
			falling.visible = shows_rain
	_light(stage, is_dark, eye)


static func _light(stage: Stage, is_dark: bool, eye: Vector3) -> void:
	var lamps: Array[Lamp] = []
	var away := {}
	for lamp: Lamp in stage.get_tree().get_nodes_in_group(Lamp.GROUP):
		if stage.is_ancestor_of(lamp):
			lamp.be_dark(is_dark)
			lamps.append(lamp)
			away[lamp] = lamp.global_position.distance_squared_to(eye)
	if is_dark and lamps.size() > MOST_LAMPS:
		lamps.sort_custom(func(a: Lamp, b: Lamp) -> bool: return away[a] < away[b])
	for i in lamps.size():
		lamps[i].shine(is_dark and i < MOST_LAMPS)
