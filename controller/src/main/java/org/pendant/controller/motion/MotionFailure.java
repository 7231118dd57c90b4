package org.pendant.controller.motion;

/**
 * Why a motion cannot go on; the arm stops beside its path.
 *
 * @param code stable kebab-case identifier
 * @param message what, the value, what was expected
 */
public record MotionFailure(String code, String message) {}
