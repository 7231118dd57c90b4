package org.pendant.motion.force;

/**
 * Axis of force mode: what it does along or about one axis of its task frame.
 *
 * @param compliant whether the TCP gives way there until the wrench is right
 * @param wrench what the tool is to press with, N or Nm; counts if compliant
 * @param limit of a compliant axis the largest speed of the TCP, m/s or rad/s; of another one the
 *     farthest that the TCP may be from the path, m or rad; at least 0
 */
public record ForceAxis(boolean compliant, double wrench, double limit) {}
