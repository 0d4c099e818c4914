"""Networks edge by edge in many candidates: junctions, control, how lanes lead on."""
