/**
 * Servo motions, which programs steer frame by frame: speeds of joints and of the tool, positions
 * to follow, and torques. Open {@link org.pendant.motion.servo.Servoing} first.
 */
package org.pendant.motion.servo;
