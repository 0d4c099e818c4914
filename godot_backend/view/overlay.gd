extends CanvasLayer
## Text over the picture: speeds, and how well each requirement and expectation holds.

var _label := Label.new()


func _ready() -> void:
	_label.position = Vector2(16, 12)
	_label.add_theme_color_override("font_color", Color.WHITE)
	_label.add_theme_color_override("font_shadow_color", Color(0, 0, 0, 0.8))
	_label.add_theme_font_size_override("font_size", 16)
	add_child(_label)


## Takes {lines: [text, ...]}.
func take(wish: Dictionary) -> void:
	var lines: Variant = wish.get("lines", [])
	if not lines is Array:
		return
	var text := PackedStringArray()
	for line: Variant in (lines as Array).slice(0, 40):
		text.append(str(line).left(160))
	_label.text = "\n".join(text)
