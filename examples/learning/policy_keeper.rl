# Train a policy on this file (train_policy.py), then falsify it: roadlang falsify policy_keeper.rl --seed 1
include "road.rl"
agent ego is car on bent at 5m {
  lane: -1
  drive with process { command: ["python3", "policy_keeper.py"], brake_on_failure: true }
}
world { friction: 0.3..0.9 }
expect in_lane: always (abs(ego.cross_track_error) < 1.5m)
falsify with cma { expects: in_lane, evaluations: 100 }
simulate with builtin { control_step: 100ms }  # how often it decided in training
