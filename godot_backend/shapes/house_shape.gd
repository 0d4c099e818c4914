extends RefCounted
## Houses: windows in rows, some lit at night, under a flat or a gabled roof.

const Looks := preload("../build/looks.gd")
const Solid := preload("solid.gd")

const WALLS: Array[Color] = [
	Color(0.72, 0.64, 0.5),
	Color(0.55, 0.27, 0.2),
	Color(0.66, 0.68, 0.7),
	Color(0.76, 0.72, 0.64),
	Color(0.45, 0.5, 0.55),
	Color(0.66, 0.5, 0.34),
]
const ROOFS: Array[Color] = [Color(0.3, 0.16, 0.12), Color(0.2, 0.2, 0.22), Color(0.26, 0.2, 0.17)]
const STORY := 3.0
const BAY := 3.0
## Rows and columns of windows on one side: those of larger houses are larger.
const MOST_WINDOWS := 24
## Higher houses have flat roofs.
const GABLED := 9.5
const OUTSIDE := 0.03


## Length along x, height and width along z; `variant` picks color and lit windows.
static func house(size: Vector3, wall: Color, variant: int) -> Solid:
	var out := Solid.new()
	var is_gabled := size.y < GABLED
	var eaves := size.y * (0.72 if is_gabled else 0.97)
	out.box(Vector3(size.x, eaves, size.z), Vector3(0, 0.5 * eaves, 0), Looks.plain(wall))
	out.box(
		Vector3(size.x + 0.06, 0.5, size.z + 0.06),
		Vector3(0, 0.25, 0),
		Looks.plain(wall.darkened(0.45))
	)
	var roof := Looks.plain(ROOFS[variant % ROOFS.size()])
	if is_gabled:
		_add_gable(out, size, eaves, roof, Looks.plain(wall))
	else:
		out.box(
			Vector3(1.04 * size.x, 0.03 * size.y, 1.04 * size.z),
			Vector3(0, size.y * 0.985, 0),
			roof
		)
	for side in 4:
		_add_windows(out, size, eaves, side, variant)
	return out


static func _add_gable(
	out: Solid, size: Vector3, eaves: float, roof: Material, wall: Material
) -> void:
	var over := 0.04 * size
	var half := 0.5 * size.z + over.z
	var slope := (size.y - eaves) / (0.5 * size.z)
	var low := eaves - over.z * slope
	var end := 0.5 * size.x
	for side: float in [-1.0, 1.0]:
		out.pane(
			[
				Vector3(-end - over.x, low, side * half),
				Vector3(end + over.x, low, side * half),
				Vector3(end + over.x, size.y, 0),
				Vector3(-end - over.x, size.y, 0)
			],
			Vector3(0, 1, side),
			roof
		)
		out.pane(
			[
				Vector3(side * end, eaves, -0.5 * size.z),
				Vector3(side * end, eaves, 0.5 * size.z),
				Vector3(side * end, size.y, 0)
			],
			Vector3(side, 0, 0),
			wall
		)
		out.pane(
			[
				Vector3(-end - over.x, low, side * half),
				Vector3(end + over.x, low, side * half),
				Vector3(end + over.x, low, side * (half - over.z)),
				Vector3(-end - over.x, low, side * (half - over.z))
			],
			Vector3.DOWN,
			roof
		)
	if size.y < STORY:
		return
	var chimney := Vector3(0.25 * size.x, size.y - 0.5, 0.13 * size.z)
	out.box(Vector3(0.6, 1.1, 0.6), chimney, Looks.plain(Color(0.32, 0.2, 0.17)))


static func _add_windows(out: Solid, size: Vector3, eaves: float, side: int, variant: int) -> void:
	var turned := Basis(Vector3.UP, side * PI / 2)
	var along := size.x if side % 2 == 0 else size.z
	var away := 0.5 * (size.z if side % 2 == 0 else size.x) + OUTSIDE
	var stories := clampi(floori(eaves / STORY + 0.2), 1, MOST_WINDOWS)
	var bays := clampi(floori(along / BAY), 1, MOST_WINDOWS)
	var frame := Looks.plain(Color(0.8, 0.8, 0.78))
	for story in stories:
		for bay in bays:
			var x := ((bay + 0.5) / bays - 0.5) * along
			var y := (story + 0.56) * eaves / stories
			var is_door := story == 0 and side == 0 and bay == bays / 2
			var half := Vector2(minf(0.58, 0.3 * along / bays), minf(0.68, 0.26 * eaves / stories))
			if is_door:
				half.y = minf(1.05, 0.4 * eaves)
				y = half.y
			var is_lit := (bay * 7 + story * 13 + side * 5 + variant * 3) % 10 < 4
			var look := Looks.plain(Color(0.22, 0.13, 0.09)) if is_door else Looks.window(is_lit)
			_add_pane(out, turned, Vector3(x, y, away), half * 1.15, frame)
			_add_pane(out, turned, Vector3(x, y, away + 0.02), half, look)


static func _add_pane(
	out: Solid, turned: Basis, at: Vector3, half: Vector2, look: Material
) -> void:
	var corners := []
	for corner: Vector2 in [Vector2(-1, -1), Vector2(1, -1), Vector2(1, 1), Vector2(-1, 1)]:
		corners.append(turned * (at + Vector3(corner.x * half.x, corner.y * half.y, 0)))
	out.pane(corners, turned * Vector3.BACK, look)
