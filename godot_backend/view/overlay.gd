extends CanvasLayer
## Text over the picture: speeds, and the robustness of each requirement and expectation; in a
## window without a scene, how to send one.

const Protocol := preload("../net/protocol.gd")

const NIGHT_BLUE := Color(0.07, 0.1, 0.16)

var _label := Label.new()
var _welcome := Label.new()


func _ready() -> void:
	RenderingServer.set_default_clear_color(NIGHT_BLUE)
	_welcome.set_anchors_preset(Control.PRESET_FULL_RECT)
	_welcome.horizontal_alignment = HORIZONTAL_ALIGNMENT_CENTER
	_welcome.vertical_alignment = VERTICAL_ALIGNMENT_CENTER
	_welcome.mouse_filter = Control.MOUSE_FILTER_IGNORE
	_welcome.add_theme_font_size_override("font_size", 24)
	add_child(_welcome)
	_label.position = Vector2(16, 12)
	_label.add_theme_color_override("font_color", Color.WHITE)
	_label.add_theme_color_override("font_shadow_color", Color(0, 0, 0, 0.8))
	_label.add_theme_font_size_override("font_size", 16)
	add_child(_label)


## Shows how to send a scene while there is none.
func welcome(port: int, is_empty: bool) -> void:
	_welcome.visible = is_empty
	_welcome.text = (
		"roadlang is waiting on port %d\n\nroadlang watch scene.rl --host 127.0.0.1" % port
	)
	if port != Protocol.USUAL_PORT:
		_welcome.text += " --port %d" % port


## Takes {lines: [text, ...]}.
func take(wish: Dictionary) -> void:
	var lines: Variant = wish.get("lines", [])
	if not lines is Array:
		return
	var text := PackedStringArray()
	for line: Variant in (lines as Array).slice(0, 40):
		text.append(str(line).left(160))
	_label.text = "\n".join(text)
