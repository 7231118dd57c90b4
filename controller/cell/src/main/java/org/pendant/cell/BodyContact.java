package org.pendant.cell;

/**
 * Body contact: a place where two bodies touch.
 *
 * @param first a free body
 * @param second the other
 * @param forceN the force between them there, N
 */
public record BodyContact(String first, String second, double forceN) {}
