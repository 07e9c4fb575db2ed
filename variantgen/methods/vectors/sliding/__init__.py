"""What slides on a moving body: a point in a slot, a rod in a sleeve or a cylinder; relative motion, Coriolis."""
