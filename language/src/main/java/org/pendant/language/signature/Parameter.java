package org.pendant.language.signature;

/**
 * One parameter of a function.
 *
 * @param required whether a call must give it
 * @param defaultText the default as it would be written in a script, or a description in angle
 *     brackets when the default depends on the robot's state; empty when required
 */
public record Parameter(String name, Type type, Unit unit, boolean required, String defaultText) {}
