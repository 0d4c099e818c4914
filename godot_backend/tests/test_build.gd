extends RefCounted
## Tiles and their merged collision.

const Tiles := preload("../build/tiles.gd")
const Cells := preload("../build/cells.gd")
const TileMesh := preload("../build/tile_mesh.gd")


func test_every_mask_has_a_shape_and_a_turn_that_give_it_back() -> String:
	for mask in 256:
		var turned := Tiles.shape_of(mask)
		if (
			Tiles.turn(turned.x, turned.y) != mask
			or Tiles.shape_of(turned.x) != Vector2i(turned.x, 0)
		):
			return "mask %d" % mask
	return ""


func test_as_many_shapes_as_neighbors_allow() -> String:
	var shapes: Dictionary = {}
	var narrow: Dictionary = {}
	var masks := 0
	for mask in 256:
		if Tiles.is_mask(mask):
			masks += 1
			shapes[Tiles.shape_of(mask).x] = true
			if mask < 16:
				narrow[Tiles.shape_of(mask).x] = true
	var found: Array[int] = [masks, shapes.size(), narrow.size()]
	return "" if found == ([47, 15, 6] as Array[int]) else str(found)


func test_tiles_fill_their_cell_where_no_curb_rounds_it() -> String:
	for mask: int in [15 | 240, 15, 5, 0]:
		var mesh := TileMesh.make(mask)
		var box := mesh.get_aabb()
		if not is_equal_approx(box.size.x, 1.0) or not is_equal_approx(box.size.z, 1.0):
			return "mask %d: %s" % [mask, box]
		var area := _area(mesh.surface_get_arrays(0)[Mesh.ARRAY_VERTEX])
		var wanted: float = {255: 1.0, 15: 1.0 - PI * 0.06 * 0.06, 5: 0.88}.get(mask, area)
		if absf(area - wanted) > 1e-3:
			return "mask %d: asphalt of %f" % [mask, area]
	return ""


## Of triangles that are clockwise seen from above.
func _area(corners: PackedVector3Array) -> float:
	var sum := 0.0
	for i in range(0, corners.size(), 3):
		sum -= 0.5 * (corners[i + 1] - corners[i]).cross(corners[i + 2] - corners[i]).y
	return sum


func test_rectangles_cover_each_cell_once() -> String:
	var cells: Dictionary = {}
	for i in 40:
		cells[Vector2i((i * 7) % 9, (i * 5) % 8)] = true
	var covered: Dictionary = {}
	for rectangle in Cells.rectangles(cells):
		for x in rectangle.size.x:
			for y in rectangle.size.y:
				var cell := rectangle.position + Vector2i(x, y)
				if covered.has(cell) or not cells.has(cell):
					return str(cell)
				covered[cell] = true
	return "" if covered.size() == cells.size() else "missed some"


func test_a_straight_row_is_one_rectangle() -> String:
	var cells: Dictionary = {}
	for i in 50:
		cells[Vector2i(i, 3)] = true
	return "" if Cells.rectangles(cells).size() == 1 else "cut up"
