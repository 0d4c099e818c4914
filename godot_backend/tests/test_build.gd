extends RefCounted
## Tiles and their merged collision.

const Tiles := preload("../build/tiles.gd")
const Cells := preload("../build/cells.gd")


func test_every_mask_has_a_shape_and_a_turn_that_give_it_back() -> String:
	for mask in 16:
		var turned := Tiles.shape_of(mask)
		if Tiles.turn(Tiles.SHAPES[turned.x], turned.y) != mask:
			return "mask %d" % mask
	return ""


func test_the_six_shapes_cover_as_many_masks_as_they_should() -> String:
	var count: Array[int] = [0, 0, 0, 0, 0, 0]
	for mask in 16:
		count[Tiles.shape_of(mask).x] += 1
	return "" if count == ([1, 4, 2, 4, 4, 1] as Array[int]) else str(count)


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
