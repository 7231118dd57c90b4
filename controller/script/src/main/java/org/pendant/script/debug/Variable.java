package org.pendant.script.debug;

import java.util.Optional;
import org.pendant.script.value.ValueKind;

/**
 * Variable, element, member or value of an expression, ready to be shown.
 *
 * @param name of the variable or member; {@code [2]} or {@code [0, 2]} for an element
 * @param expression what yields it where the variable can be seen, and what to assign to
 * @param kind empty for a variable without a value
 * @param text the value as scripts print it, cut off after about 200 characters; empty without one
 * @param children how many elements or members it has; those of a matrix are numbers
 */
public record Variable(
    String name, String expression, Optional<ValueKind> kind, String text, int children) {}
