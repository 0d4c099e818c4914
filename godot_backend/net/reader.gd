extends RefCounted
## Reads a payload from the front; anything out of bounds sets `failed` and reads as zero.

var failed := false

var _bytes: PackedByteArray
var _at := 0


func _init(bytes: PackedByteArray) -> void:
	_bytes = bytes


func u8() -> int:
	return _bytes.decode_u8(_at - 1) if _take(1) else 0


func u16() -> int:
	return _bytes.decode_u16(_at - 2) if _take(2) else 0


func u32() -> int:
	return _bytes.decode_u32(_at - 4) if _take(4) else 0


## A finite float32 whose size is at most `limit`.
func f32(limit: float) -> float:
	if not _take(4):
		return 0.0
	var value := _bytes.decode_float(_at - 4)
	if not is_finite(value) or absf(value) > limit:
		failed = true
		return 0.0
	return value


func bytes(count: int) -> PackedByteArray:
	return _bytes.slice(_at - count, _at) if _take(count) else PackedByteArray()


func rest() -> PackedByteArray:
	return bytes(_bytes.size() - _at)


## `count` finite float32 numbers.
func floats(count: int, limit: float) -> PackedFloat32Array:
	var values := bytes(count * 4).to_float32_array()
	for value in values:
		# A NaN compares false with everything, so the test is written to fail for it.
		if not (value <= limit and value >= -limit):
			failed = true
			return PackedFloat32Array()
	return values


## Printable ASCII of `count` bytes; anything else fails.
func ascii(count: int) -> String:
	var raw := bytes(count)
	for code in raw:
		if code < 32 or code > 126:
			failed = true
			return ""
	return raw.get_string_from_ascii()


## The rest as a JSON object.
func json() -> Dictionary:
	var text := ascii(_bytes.size() - _at)
	var parser := JSON.new()
	if failed or parser.parse(text) != OK or not parser.data is Dictionary:
		failed = true
		return {}
	return parser.data


func at_end() -> bool:
	return not failed and _at == _bytes.size()


func _take(count: int) -> bool:
	if failed or count < 0 or _at + count > _bytes.size():
		failed = true
		return false
	_at += count
	return true
