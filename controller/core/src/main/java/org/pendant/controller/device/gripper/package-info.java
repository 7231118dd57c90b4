/**
 * Grippers: fingers that move and hold, and what programs say to them. Open {@link
 * org.pendant.controller.device.gripper.Fingers} first.
 */
package org.pendant.controller.device.gripper;
