/**
 * Safety: modes, limits and stops of the arm, checked once a frame. Open {@link
 * org.pendant.controller.safety.SafetySystem} first, then {@link
 * org.pendant.controller.safety.StopReason} for what can stop the arm.
 */
package org.pendant.controller.safety;
