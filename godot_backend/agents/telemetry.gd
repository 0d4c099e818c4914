extends RefCounted
## Packs where agents are into records of 64 bytes.

const Agent := preload("res://agents/agent.gd")

const RECORD_BYTES := 64
const HEADER_BYTES := 8
const FIELDS := 13


## One record: tick, world, agent, flags, touching, then 13 float32.
static func record(agent: Agent, tick: int, world: int, outside_force: Vector2) -> PackedByteArray:
	var body := agent.body
	var velocity := Vector3.ZERO
	var spin := 0.0
	if body is RigidBody3D:
		velocity = (body as RigidBody3D).linear_velocity
		spin = (body as RigidBody3D).angular_velocity.y
	else:
		velocity = Vector3(cos(agent.heading), 0.0, -sin(agent.heading)) * agent.speed
	var numbers := PackedFloat32Array(
		[
			agent.x,
			agent.y,
			body.global_position.y,
			agent.heading,
			agent.speed,
			velocity.x,
			-velocity.z,
			spin,
			body.steer_angle(),
			outside_force.y,
			agent.station,
			agent.cross_track_error,
			agent.progress()
		]
	)
	var out := PackedByteArray()
	out.resize(RECORD_BYTES - FIELDS * 4)
	out.encode_u32(0, tick)
	out.encode_u16(4, world)
	out.encode_u16(6, agent.id)
	out.encode_u8(8, body.wheels_down())
	out.encode_u8(9, mini(body.touching, 255))
	out.encode_s8(10, agent.driver.in_charge)
	out.encode_u8(11, int(agent.at_end()))
	out.append_array(numbers.to_byte_array())
	return out
