/**
 * How targets for the joints come about: motions are closed forms over time, asked for a point
 * every frame. Open {@link org.pendant.motion.MotionControl} first, then {@link
 * org.pendant.motion.Motion} and its kinds.
 */
package org.pendant.motion;
