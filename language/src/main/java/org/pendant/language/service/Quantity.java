package org.pendant.language.service;

import org.pendant.language.signature.Unit;
import org.pendant.language.source.SourceRange;

/**
 * Quantity: a number in the text whose unit is known from where it stands.
 *
 * @param range the number, with its sign
 * @param value as it is written, in {@code unit}
 * @param unit never {@link Unit#NONE}
 * @param name of what it is given for: a parameter, or a part of a pose such as {@code rx}
 */
public record Quantity(SourceRange range, double value, Unit unit, String name) {}
