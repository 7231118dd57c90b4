package org.pendant.controller.quantity;

/**
 * Component: one number of a quantity.
 *
 * @param name stable name in settings and files, such as {@code actual_q_0}
 * @param title what people read beside the others of its group, such as {@code Base}
 * @param unit what it counts
 */
public record Component(String name, String title, PhysicalUnit unit) {}
