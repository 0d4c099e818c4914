extends "../build/thing.gd"
## A camera of an agent, or of the world: what it sees in color, by label, and by depth.

enum Output { RGB = 1, LABELS = 2, DEPTH = 4 }

const Agent := preload("../agents/agent.gd")
const Stage := preload("../build/stage.gd")
const Twins := preload("twins.gd")

const NAMES := {"rgb": Output.RGB, "labels": Output.LABELS, "depth": Output.DEPTH}
const DEPTH_LAYER := 1 << 21
const LEAST_PIXELS := 16
const MOST_PIXELS := 4096
const NEAR := 0.1
const FAR := 6000.0
## Pixels of all outputs of all cameras of all worlds together: what they saw fits into 65535 parts.
const MOST_TOGETHER := 1 << 27
## What a smaller camera counts for.
const LEAST_COUNTED := 1 << 16

static var _together := 0

var width := 320
var height := 180
var outputs := 0
## Number of the agent that carries it; 0: none.
var agent := 0

var _place := Vector3.ZERO
var _yaw := 0.0
var _pitch := 0.0
var _roll := 0.0
var _field := 90.0
var _samples := Viewport.MSAA_DISABLED
var _spec := PackedByteArray()
var _counted := 0
## By output.
var _viewports: Dictionary = {}


func build(reader: Reader) -> String:
	_spec = reader.rest()
	var spec := Reader.new(_spec).json()
	var wanted: Variant = spec.get("outputs")
	if spec.is_empty() or not wanted is Array:
		return "bad camera"
	for name: Variant in wanted:
		if not NAMES.has(name):
			return "a camera has the outputs rgb, labels, depth"
		outputs |= int(NAMES[name])
	width = clampi(int(Agent.number(spec, "width", 320.0)), LEAST_PIXELS, MOST_PIXELS)
	height = clampi(int(Agent.number(spec, "height", 180.0)), LEAST_PIXELS, MOST_PIXELS)
	agent = int(Agent.number(spec, "agent", 0.0))
	# Ahead, left, up to left, up, ahead: the axes of a body.
	_place = Vector3(
		Agent.number(spec, "y", 0.0), Agent.number(spec, "z", 0.0), Agent.number(spec, "x", 0.0)
	)
	_yaw = Agent.number(spec, "yaw", 0.0)
	_pitch = Agent.number(spec, "pitch", 0.0)
	_roll = Agent.number(spec, "roll", 0.0)
	_field = clampf(rad_to_deg(Agent.number(spec, "fov", PI / 2)), 1.0, 175.0)
	if Agent.number(spec, "samples", 1.0) >= 2.0:
		_samples = Viewport.MSAA_2X
	var count := maxi(width * height * _outputs_count(), LEAST_COUNTED)
	if _together + count > MOST_TOGETHER:
		return "all cameras together have at most %d pixels in all outputs" % MOST_TOGETHER
	_counted = count
	_together += count
	return ""


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		_together -= _counted


func content() -> PackedByteArray:
	return _spec


## Where it is now, looking along -z.
func pose(stage: Stage) -> Transform3D:
	var mount := Transform3D(
		Basis(Vector3.UP, PI + _yaw) * Basis(Vector3.RIGHT, _pitch) * Basis(Vector3.FORWARD, _roll),
		_place
	)
	for carrier in stage.agents():
		if carrier.id == agent:
			return carrier.body.global_transform * mount
	return Transform3D(Basis(Vector3.UP, PI / 2), Vector3.ZERO) * mount


## Prepares what it is to see in the next frame that is drawn.
func aim(at: Transform3D) -> void:
	for output: int in [Output.RGB, Output.LABELS, Output.DEPTH]:
		if not outputs & output:
			continue
		if not _viewports.has(output):
			_viewports[output] = _viewport(output)
		var viewport: SubViewport = _viewports[output]
		viewport.render_target_update_mode = SubViewport.UPDATE_ONCE
		var eye: Camera3D = viewport.get_child(0)
		eye.global_transform = at
		eye.force_update_transform()


## What it saw: three bytes a pixel for each output, in their order.
func seen() -> PackedByteArray:
	var out := PackedByteArray()
	for output: int in [Output.RGB, Output.LABELS, Output.DEPTH]:
		if outputs & output:
			var viewport: SubViewport = _viewports[output]
			var image := viewport.get_texture().get_image()
			image.convert(Image.FORMAT_RGB8)
			out.append_array(image.get_data())
	return out


func _outputs_count() -> int:
	return (outputs & 1) + (outputs >> 1 & 1) + (outputs >> 2 & 1)


func _viewport(output: int) -> SubViewport:
	var viewport := SubViewport.new()
	viewport.size = Vector2i(width, height)
	viewport.render_target_update_mode = SubViewport.UPDATE_DISABLED
	viewport.positional_shadow_atlas_size = 512
	var eye := Camera3D.new()
	eye.keep_aspect = Camera3D.KEEP_WIDTH
	eye.fov = _field
	eye.near = NEAR
	eye.far = FAR
	if output == Output.RGB:
		viewport.msaa_3d = _samples
	else:
		eye.cull_mask = Twins.LAYER | (DEPTH_LAYER if output == Output.DEPTH else 0)
		eye.environment = _plain()
	viewport.add_child(eye)
	add_child(viewport)
	eye.make_current()
	return viewport


## Colors as they are written, on black.
static func _plain() -> Environment:
	var plain := Environment.new()
	plain.background_mode = Environment.BG_COLOR
	plain.background_color = Color.BLACK
	plain.tonemap_mode = Environment.TONE_MAPPER_LINEAR
	return plain
