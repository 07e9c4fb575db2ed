"""Plans of velocities and accelerations: vector equations solved by drawing them to scale and measuring."""
