extends "thing.gd"
## The signals of a junction: lights on poles, which change as the drive goes on.

enum Light { GREEN, YELLOW, RED }

const Protocol := preload("../net/protocol.gd")
const Looks := preload("looks.gd")

const LONGEST := 1e6
const POLE_HEIGHT := 2.6
const LAMPS: Array[Color] = [Color(0.05, 0.9, 0.35), Color(1.0, 0.7, 0.05), Color(1.0, 0.1, 0.06)]
## Height of the lamps above the foot of the box, meters.
const LAMP_HEIGHTS: Array[float] = [0.18, 0.45, 0.72]

var _offset := 0.0
## Seconds of green, yellow and red of each phase.
var _seconds: PackedFloat32Array
## Of each head, for each phase: whether it has green.
var _has_green: PackedByteArray
var _heads: Array[Node3D] = []
var _lamps: Array[Array] = []
var _shown: Array[int] = []


func build(reader: Reader) -> String:
	var heads := reader.u8()
	var phases := reader.u8()
	_offset = reader.f32(LONGEST)
	_seconds = reader.floats(phases * 3, LONGEST)
	var places := reader.floats(heads * 4, Protocol.MAX_COORDINATE)
	_has_green = reader.bytes(heads * phases)
	if not reader.at_end() or heads < 1 or phases < 1:
		return "bad signals"
	if cycle(_seconds) <= 0.0:
		return "phases of signals take more than 0 s"
	for i in heads:
		_add_head(Vector3(places[4 * i], places[4 * i + 1], places[4 * i + 2]), places[4 * i + 3])
	show_at(0.0)
	return ""


## Where the heads stand, and when they change.
func content() -> PackedByteArray:
	var positions := PackedVector3Array()
	for head in _heads:
		positions.append(head.position)
	return positions.to_byte_array() + _seconds.to_byte_array() + _has_green


## Shows the lights at a time of the drive.
func show_at(time: float) -> void:
	var phases := _seconds.size() / 3
	for i in _heads.size():
		var green := _has_green.slice(i * phases, (i + 1) * phases)
		var shown := light(_seconds, _offset, green, time)
		if shown == _shown[i]:
			continue
		_shown[i] = shown
		for lamp in LAMPS.size():
			var bulb: MeshInstance3D = _lamps[i][lamp]
			bulb.material_override = _glow(lamp) if lamp == shown else _dark(lamp)


## What one head shows that has green in the phases `green`.
static func light(
	seconds: PackedFloat32Array, offset: float, green: PackedByteArray, time: float
) -> int:
	var left := fposmod(time + offset, cycle(seconds))
	for i in seconds.size():
		if left < seconds[i]:
			return i % 3 if green[i / 3] else Light.RED
		left -= seconds[i]
	return Light.RED


## Seconds of all phases.
static func cycle(seconds: PackedFloat32Array) -> float:
	var sum := 0.0
	for part in seconds:
		sum += part
	return sum


func _add_head(place: Vector3, heading: float) -> void:
	var head := Node3D.new()
	head.position = place
	head.rotation.y = heading
	add_child(head)
	_heads.append(head)
	_shown.append(-1)
	var metal := Looks.plain(Color(0.16, 0.17, 0.18), 0.5)
	var pole := CylinderMesh.new()
	pole.top_radius = 0.06
	pole.bottom_radius = 0.08
	pole.height = POLE_HEIGHT
	_add_part(head, pole, Vector3(0, POLE_HEIGHT / 2, 0), metal)
	var box := BoxMesh.new()
	box.size = Vector3(0.2, 0.9, 0.34)
	_add_part(head, box, Vector3(0, POLE_HEIGHT + 0.45, 0), metal)
	var lamps: Array[MeshInstance3D] = []
	for height in LAMP_HEIGHTS:
		var bulb := SphereMesh.new()
		bulb.radius = 0.12
		bulb.height = 0.24
		lamps.append(_add_part(head, bulb, Vector3(-0.08, POLE_HEIGHT + height, 0), null))
	_lamps.append(lamps)


func _add_part(to: Node3D, mesh: Mesh, at: Vector3, material: Material) -> MeshInstance3D:
	var part := MeshInstance3D.new()
	part.mesh = mesh
	part.position = at
	part.material_override = material
	to.add_child(part)
	return part


static func _glow(lamp: int) -> StandardMaterial3D:
	var material := Looks.plain(LAMPS[lamp], 0.4)
	material.emission_enabled = true
	material.emission = LAMPS[lamp]
	material.emission_energy_multiplier = 2.5
	return material


static func _dark(lamp: int) -> StandardMaterial3D:
	return Looks.plain(LAMPS[lamp].darkened(0.85), 0.4)
