/**
 * Motion: trajectories as closed forms over time, from which the setpoint of the joints is taken
 * every frame. Open {@link org.pendant.motion.MotionControl} first, then {@link
 * org.pendant.motion.Motion} and its kinds.
 */
package org.pendant.motion;
