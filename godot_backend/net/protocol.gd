extends RefCounted
## The numbers of the wire protocol. `docs/godot.md` describes every message.

const VERSION := 2
const USUAL_PORT := 4242
const HEADER_BYTES := 20
## Largest datagram taken or sent; what a client sends in bulk stays far below.
const MAX_DATAGRAM := 8192
## Datagrams a sender may have unacknowledged: below what a kernel queue holds between two polls.
const WINDOW := 32
const WEBSOCKET_WINDOW := 1024
## Coordinates are meters from the scene's origin; beyond this float32 is coarser than 1 cm.
const MAX_COORDINATE := 100000.0
const MAX_WORLDS := 256
const MAX_THINGS := 200000

## Session.
const HELLO := 0x01
const WELCOME := 0x02
const ACK := 0x03
const ERROR := 0x04
const BYE := 0x05
const PING := 0x06

## Scene.
const BEGIN := 0x10
const SEGMENT := 0x11
const PATCH := 0x12
const TILES := 0x13
const OBJECTS := 0x14
const PATH := 0x15
const AGENT := 0x16
const WORLD := 0x17
const REMOVE := 0x18
const PAINT := 0x19
const SIGNALS := 0x1A
const HANDLES := 0x1B
const CAMERA := 0x1C
const LABELS := 0x1D

## Proof.
const COMMIT := 0x20
const BUILT := 0x21
const LIST := 0x22
const REPORT := 0x23
const PROBE := 0x24
const PROBED := 0x25

## Drive.
const RUN := 0x30
const STEP := 0x31
const STATE := 0x32
const DONE := 0x33
const TRACE := 0x34
const STOP := 0x35
const CONTACTS := 0x36

## View.
const VIEW := 0x40
const SHOT := 0x41
const PICTURE := 0x42
const EDIT := 0x43
const NOTE := 0x44
const LOOK := 0x45
const FRAMES := 0x46

## Files.
const EXPORT := 0x48
const EXPORTED := 0x49


static func is_thing(type: int) -> bool:
	return type >= SEGMENT and type <= LABELS and type != REMOVE
