extends Node
## Reduces detail during a drag if frames are slow, as without a graphics card, so that the dragged
## handle keeps up with the pointer.

const Protocol := preload("../net/protocol.gd")
const Worlds := preload("../build/worlds.gd")
const Weather := preload("../build/weather.gd")
const Hands := preload("hands.gd")

## Duration in seconds from which a frame counts as slow.
const SLOW := 0.04
## Scale of width and height with reduced detail.
const SCALE := 0.5

var _worlds: Worlds
var _hands: Hands
var _viewport: Viewport
var _is_low := false
var _usual_samples := Viewport.MSAA_DISABLED


func _init(worlds: Worlds, hands: Hands, viewport: Viewport) -> void:
	_worlds = worlds
	_hands = hands
	_viewport = viewport


func _process(dt: float) -> void:
	look(dt)


## Chooses the detail of the next frame from the duration `dt` of the last one, in seconds.
func look(dt: float) -> void:
	var is_low := _hands.is_dragging() and (_is_low or dt > SLOW)
	if is_low != _is_low:
		_is_low = is_low
		_draw_less(is_low)
	if is_low:
		_cast_shadows(false)


func _draw_less(less: bool) -> void:
	if less:
		_usual_samples = _viewport.msaa_3d
	_viewport.msaa_3d = Viewport.MSAA_DISABLED if less else _usual_samples
	_viewport.scaling_3d_scale = SCALE if less else 1.0
	_cast_shadows(not less)


func _cast_shadows(casts: bool) -> void:
	for stage: Worlds.Stage in _worlds.stages.values():
		for weather in stage.all(Protocol.WORLD):
			(weather as Weather).cast_shadows(casts)
