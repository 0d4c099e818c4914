extends RefCounted
## What a client says in a step that an agent is to do.

## What the numbers are: a steering angle or a heading, each with an acceleration; the pose and the
## speed that are reached at the end of the step; or as the first, for one that nobody sees or
## touches any more.
enum Form { NOTHING, STEER, FACE, POSE, LEAVE }

const Protocol := preload("../net/protocol.gd")
const Reader := preload("../net/reader.gd")

const MAX_STEERING := 10.0
const MAX_ACCELERATION := 1000.0

var form := Form.NOTHING
## x and y of a pose.
var place := Vector2.ZERO
## Steering angle or heading.
var angle := 0.0
## Acceleration, or speed of a pose.
var pull := 0.0


## Reads on; false where something is wrong.
func read(reader: Reader) -> bool:
	var number := reader.u32()
	if number == Form.POSE:
		place = Vector2(reader.f32(Protocol.MAX_COORDINATE), reader.f32(Protocol.MAX_COORDINATE))
		angle = reader.f32(Protocol.MAX_COORDINATE)
	else:
		reader.f32(0.0)
		reader.f32(0.0)
		angle = reader.f32(MAX_STEERING)
	pull = reader.f32(MAX_ACCELERATION)
	if reader.failed or number > Form.LEAVE:
		return false
	form = number as Form
	return true
