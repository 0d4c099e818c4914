"""Why a formula has its robustness, and which parameters would make it hold."""
