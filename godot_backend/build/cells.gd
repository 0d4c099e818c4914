extends RefCounted
## Merges square cells into few rectangles, for one collision shape without inner edges to trip on.


## Triangles that cover the cells: runs along x, then equal runs of following rows joined.
static func faces(cells: Dictionary, size: float, shift: Vector2) -> PackedVector3Array:
	var out := PackedVector3Array()
	for rectangle in rectangles(cells):
		var a := Vector2(rectangle.position) * size + shift
		var b := Vector2(rectangle.end) * size + shift
		var nw := Vector3(a.x, 0.0, a.y)
		var ne := Vector3(b.x, 0.0, a.y)
		var sw := Vector3(a.x, 0.0, b.y)
		var se := Vector3(b.x, 0.0, b.y)
		out.append_array(PackedVector3Array([nw, ne, sw, sw, ne, se]))
	return out


static func rectangles(cells: Dictionary) -> Array[Rect2i]:
	var left := cells.duplicate()
	var corners: Array = cells.keys()
	corners.sort_custom(
		func(a: Vector2i, b: Vector2i) -> bool: return a.y < b.y or (a.y == b.y and a.x < b.x)
	)
	var out: Array[Rect2i] = []
	for corner: Vector2i in corners:
		if not left.has(corner):
			continue
		var width := 1
		while left.has(corner + Vector2i(width, 0)):
			width += 1
		var height := 1
		while _row_full(left, corner + Vector2i(0, height), width):
			height += 1
		for y in height:
			for x in width:
				left.erase(corner + Vector2i(x, y))
		out.append(Rect2i(corner, Vector2i(width, height)))
	return out


static func _row_full(cells: Dictionary, start: Vector2i, width: int) -> bool:
	for x in width:
		if not cells.has(start + Vector2i(x, 0)):
			return false
	return true
