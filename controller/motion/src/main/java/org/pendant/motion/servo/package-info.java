/**
 * What programs steer frame by frame: speeds of joints and of the tool, positions to run after, and
 * torques. Open {@link org.pendant.motion.servo.Servoing} first.
 */
package org.pendant.motion.servo;
